//! Texts from files of a limited length.

use super::read;
use lightfall_core::reason::reason;
use lightfall_core::text::{NotText, decode};
use std::io;
use std::path::Path;
use thiserror::Error;

/// Why a file gives no text. Each message continues a sentence that begins with the file's name.
#[derive(Debug, Error)]
pub enum TextError {
    /// The file cannot be read, for the system's reason.
    #[error("cannot be read: {}", reason(.0))]
    Unreadable(#[from] io::Error),
    /// The file is longer than this number of bytes.
    #[error("is longer than {0} bytes")]
    TooLong(u64),
    /// The file has no text, or nothing but comments.
    #[error("is empty")]
    Empty,
    /// The file is not text.
    #[error(transparent)]
    NotText(#[from] NotText),
}

/// Reads a text of at most `max_bytes`.
///
/// # Errors
/// The file does not exist, cannot be read, is longer, or is not text.
pub fn read_text(path: &Path, max_bytes: u64) -> Result<String, TextError> {
    text_of(read(path, max_bytes)?, max_bytes)
}

/// The text of at most `max_bytes` that these bytes are. Of a longer one the first bytes are enough.
///
/// # Errors
/// It is longer, or is not text.
pub fn text_of(bytes: Vec<u8>, max_bytes: u64) -> Result<String, TextError> {
    if bytes.len() as u64 > max_bytes {
        return Err(TextError::TooLong(max_bytes));
    }
    Ok(decode(bytes)?)
}
