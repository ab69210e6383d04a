//! SHA-256 of files, bytes and texts, as `sha256sum` prints it.

use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Bytes that are read at once.
const BLOCK_BYTES: usize = 1 << 16;

/// The hash of a file, and its length in bytes.
///
/// # Errors
/// The file does not exist or cannot be read.
pub fn hash_of_file(path: &Path) -> io::Result<(String, u64)> {
    let (mut file, mut hash) = (File::open(path)?, Sha256::new());
    let (mut block, mut length) = (vec![0; BLOCK_BYTES], 0);
    loop {
        let count = file.read(&mut block)?;
        if count == 0 {
            return Ok((in_hexadecimal(&hash.finalize()), length));
        }
        hash.update(&block[..count]);
        length += count as u64;
    }
}

/// The hash of a text in UTF-8.
#[must_use]
pub fn hash_of_text(text: &str) -> String {
    hash_of_bytes(text.as_bytes())
}

/// The hash of bytes.
pub(super) fn hash_of_bytes(bytes: &[u8]) -> String {
    in_hexadecimal(&Sha256::digest(bytes))
}

fn in_hexadecimal(hash: &[u8]) -> String {
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}
