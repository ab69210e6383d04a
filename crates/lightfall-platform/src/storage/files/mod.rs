//! Files: those of the file system or, in a browser, texts in its storage.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod disk;
mod write_error;

#[cfg(target_arch = "wasm32")]
pub use browser::{create_parent_folder, exists, files_in, read, remove, rename, write_atomically};
#[cfg(not(target_arch = "wasm32"))]
pub use disk::{
    check_folder_writable, check_name, check_writable, create_parent_folder, exists, files_in,
    read, remove, rename, write_atomically,
};

pub use write_error::WriteError;

use lightfall_core::text::decode;
use std::io;
use std::path::Path;

/// Reads a text of at most `max_bytes`.
///
/// # Errors
/// The file does not exist, cannot be read, is longer, or is not text.
pub fn read_text(path: &Path, max_bytes: u64) -> io::Result<String> {
    let bytes = read(path, max_bytes)?;
    if bytes.len() as u64 > max_bytes {
        let fault = format!("it is longer than {max_bytes} bytes");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, fault));
    }
    decode(bytes).map_err(|fault| io::Error::new(io::ErrorKind::InvalidData, format!("it {fault}")))
}
