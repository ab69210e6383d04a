//! The header of an EXR file, as OpenEXR's file layout describes it.

/// The magic number and the version, in front of the first attribute.
const START: usize = 8;

/// Sorts the attributes of a file with one part by name. The header keeps its length, so the
/// offsets behind it stay right. `None` if the bytes are not such a file.
pub(super) fn sort_attributes(bytes: &mut [u8]) -> Option<()> {
    let mut attributes = Vec::new();
    let mut at = START;
    // An empty name ends the header.
    while *bytes.get(at)? != 0 {
        let name = text(bytes, at)?;
        let size_at = at + name.len() + 1 + text(bytes, at + name.len() + 1)?.len() + 1;
        let size = bytes.get(size_at..)?.first_chunk()?;
        let end = size_at
            .checked_add(4)?
            .checked_add(u32::from_le_bytes(*size) as usize)?;
        attributes.push((name.to_vec(), bytes.get(at..end)?.to_vec()));
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

/// The text that begins at a place and ends in front of a zero.
fn text(bytes: &[u8], at: usize) -> Option<&[u8]> {
    let rest = bytes.get(at..)?;
    Some(&rest[..rest.iter().position(|byte| *byte == 0)?])
}
