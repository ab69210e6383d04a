//! The mark by which players know that a film shows the whole sky: Google's Spherical Video V2, in the
//! description of the track of an MPEG-4.

use std::io::{self, Read, Seek, SeekFrom, Write};

/// The most bytes of an index that is read into memory. That of an hour's film has a few megabytes.
const MAX_INDEX: u64 = 1 << 30;

/// The way to the list of sample descriptions, inside the index.
const PATH: [&[u8; 4]; 5] = [b"trak", b"mdia", b"minf", b"stbl", b"stsd"];

/// Bytes of the list before its first description, after its header.
const LIST_FIELDS: usize = 8;

/// Bytes of the header of a box, of those that are read here.
const HEADER: usize = 8;

/// Writes the mark into an MPEG-4 or QuickTime file of one track, whose index stands at the end.
///
/// # Errors
/// The file cannot be read or written, or is not such a file.
pub(super) fn mark_whole_sky(file: &mut (impl Read + Write + Seek)) -> io::Result<()> {
    let begin = index_begin(file)?;
    let end = file.seek(SeekFrom::End(0))?;
    if end - begin > MAX_INDEX {
        return Err(unknown());
    }
    file.seek(SeekFrom::Start(begin))?;
    let mut index = Vec::new();
    file.read_to_end(&mut index)?;
    let marked = marked(&index).ok_or_else(unknown)?;
    file.seek(SeekFrom::Start(begin))?;
    file.write_all(&marked)
}

fn unknown() -> io::Error {
    io::Error::other("ffmpeg wrote no index to which the mark of the whole sky could be added")
}

/// Where the index begins, which must be the last box of the file.
fn index_begin(file: &mut (impl Read + Seek)) -> io::Result<u64> {
    let end = file.seek(SeekFrom::End(0))?;
    let mut begin = 0;
    while begin < end {
        file.seek(SeekFrom::Start(begin))?;
        let mut header = [0; 16];
        file.read_exact(&mut header[..HEADER])?;
        let short = u64::from(u32_at(&header, 0).ok_or_else(unknown)?);
        let size = if short == 1 {
            file.read_exact(&mut header[HEADER..])?;
            let long = header[HEADER..].iter();
            long.fold(0, |size, byte| size << 8 | u64::from(*byte))
        } else {
            short
        };
        if size < HEADER as u64 || size > end - begin {
            return Err(unknown());
        }
        if &header[4..HEADER] == b"moov" {
            return if begin + size == end {
                Ok(begin)
            } else {
                Err(unknown())
            };
        }
        begin += size;
    }
    Err(unknown())
}

/// The index with the mark at the end of the first sample description, and with the sizes of the boxes
/// around it. `None` if it has no such description.
fn marked(index: &[u8]) -> Option<Vec<u8>> {
    let mut around = vec![0];
    let mut inside = HEADER..index.len();
    for name in PATH {
        let begin = child(index, inside, name)?;
        inside = begin + HEADER..begin + size_at(index, begin)?;
        around.push(begin);
    }
    let description = inside.start + LIST_FIELDS;
    around.push(description);
    let end = description.checked_add(size_at(index, description)?)?;
    let mark = mark();
    let mut marked = [index.get(..end)?, &mark, index.get(end..)?].concat();
    for begin in around {
        let size = u32::try_from(size_at(index, begin)? + mark.len()).ok()?;
        marked[begin..begin + 4].copy_from_slice(&size.to_be_bytes());
    }
    Some(marked)
}

/// Where the box with this name begins, among those in a range.
fn child(index: &[u8], range: std::ops::Range<usize>, name: &[u8; 4]) -> Option<usize> {
    let mut begin = range.start;
    while begin + HEADER <= range.end {
        if index.get(begin + 4..begin + HEADER)? == name {
            return Some(begin);
        }
        begin = begin.checked_add(size_at(index, begin)?)?;
    }
    None
}

/// The size of the box that begins here, which has at least a header and ends inside the index.
fn size_at(index: &[u8], begin: usize) -> Option<usize> {
    let size = u32_at(index, begin)? as usize;
    (size >= HEADER && size <= index.len() - begin).then_some(size)
}

fn u32_at(bytes: &[u8], begin: usize) -> Option<u32> {
    let bytes = bytes.get(begin..begin.checked_add(4)?)?;
    Some(u32::from_be_bytes(bytes.try_into().ok()?))
}

/// The boxes of the mark: one eye's picture, in the equirectangular projection, with nothing turned and
/// nothing cut off.
fn mark() -> Vec<u8> {
    let projection = [full_box(b"prhd", &[0; 12]), full_box(b"equi", &[0; 16])].concat();
    let inside = [
        full_box(b"svhd", b"Lightfall\0"),
        plain_box(b"proj", &projection),
    ]
    .concat();
    plain_box(b"sv3d", &inside)
}

fn plain_box(name: &[u8; 4], contents: &[u8]) -> Vec<u8> {
    let size = (HEADER + contents.len()) as u32;
    [&size.to_be_bytes()[..], &name[..], contents].concat()
}

/// A box with a version and flags, which are 0.
fn full_box(name: &[u8; 4], contents: &[u8]) -> Vec<u8> {
    plain_box(name, &[&[0; 4][..], contents].concat())
}
