//! Catalogues of stars in files.

use super::files::read;
use lightfall_core::optics::stars::{Catalogue, CatalogueError};
use lightfall_core::text::{NotText, decode};
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Maximum size of a catalogue, in bytes: more than the largest number of stars takes.
const MAX_STAR_FILE_BYTES: u64 = 256 << 20;

/// Why a catalogue cannot be read. Each message is one sentence that names the file.
#[derive(Debug, Error)]
pub enum StarFileError {
    /// The file cannot be read.
    #[error("--stars {}: cannot be read: {error}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The operating system's reason.
        error: io::Error,
    },
    /// The file is longer than any catalogue.
    #[error("--stars {}: is longer than {MAX_STAR_FILE_BYTES} bytes", path.display())]
    TooLong {
        /// The file.
        path: PathBuf,
    },
    /// The file is not text.
    #[error("--stars {}: {fault}", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// What it is instead.
        fault: NotText,
    },
    /// The file is not a catalogue.
    #[error("--stars {0}")]
    Catalogue(#[from] CatalogueError),
}

/// The catalogue of a CSV file.
///
/// # Errors
/// The file cannot be read, or is not a catalogue.
pub fn read_stars(path: &Path) -> Result<Catalogue, StarFileError> {
    let bytes = read(path, MAX_STAR_FILE_BYTES).map_err(|error| StarFileError::Unreadable {
        path: path.into(),
        error,
    })?;
    if bytes.len() as u64 > MAX_STAR_FILE_BYTES {
        return Err(StarFileError::TooLong { path: path.into() });
    }
    let text = decode(bytes).map_err(|fault| StarFileError::NotText {
        path: path.into(),
        fault,
    })?;
    Ok(Catalogue::from_csv(&path.display().to_string(), &text)?)
}
