//! The header of an EXR file, as OpenEXR's file layout describes it.

/// The magic number and the version, in front of the first attribute.
const START: usize = 8;

/// Sorts the attributes of a file with one part by name. The header keeps its length, so the
/// offsets behind it stay right. `None` if the bytes are not such a file.
pub(super) fn sort_attributes(bytes: &mut [u8]) -> Option<()> {
    let mut attributes = Vec::new();
    let mut at = START;
    while let Some(end) = attribute_end(bytes, at)? {
        let name = text(bytes, at)?.to_vec();
        attributes.push((name, bytes.get(at..end)?.to_vec()));
        at = end;
    }
    attributes.sort();
    let sorted: Vec<u8> = attributes
        .into_iter()
        .flat_map(|(_, whole)| whole)
        .collect();
    bytes.get_mut(START..at)?.copy_from_slice(&sorted);
    Some(())
}

/// The length of the header of a file with one part; behind it are the offsets of its blocks. `None` if the
/// bytes are not the beginning of such a file, or end before its header.
pub(super) fn length(bytes: &[u8]) -> Option<usize> {
    let mut at = START;
    while let Some(end) = attribute_end(bytes, at)? {
        at = end;
    }
    Some(at + 1)
}

/// The end of the attribute that begins at a place. The inner `None` is the empty name that ends the header.
fn attribute_end(bytes: &[u8], at: usize) -> Option<Option<usize>> {
    let name = text(bytes, at)?;
    if name.is_empty() {
        return Some(None);
    }
    let size_at = at + name.len() + 1 + text(bytes, at + name.len() + 1)?.len() + 1;
    let size = bytes.get(size_at..)?.first_chunk()?;
    let end = size_at
        .checked_add(4)?
        .checked_add(u32::from_le_bytes(*size) as usize)?;
    Some(Some(end))
}

/// The text that begins at a place and ends in front of a zero.
fn text(bytes: &[u8], at: usize) -> Option<&[u8]> {
    let rest = bytes.get(at..)?;
    Some(&rest[..rest.iter().position(|byte| *byte == 0)?])
}
