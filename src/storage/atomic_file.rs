//! Files that appear complete or not at all.

use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;
use thiserror::Error;

/// A file that could not be written.
#[derive(Debug, Error)]
#[error("{path}: cannot be written: {source}")]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// The operating system's reason.
    pub source: io::Error,
}

impl WriteError {
    /// The error of the file at `path`.
    #[must_use]
    pub fn new(path: &Path, source: io::Error) -> Self {
        Self {
            path: path.into(),
            source,
        }
    }
}

/// Writes a file and replaces an older one of the same name. The file appears under its name only
/// when it is complete, so an interrupted program leaves no partial file.
///
/// # Errors
/// The folder does not exist, or the file cannot be written.
pub fn write_atomically(path: &Path, contents: &[u8]) -> Result<(), WriteError> {
    let write = || {
        let mut file = temporary_file(parent_folder(path))?;
        file.write_all(contents)?;
        file.as_file().sync_all()?;
        file.persist(path).map_err(|error| error.error)?;
        Ok(())
    };
    write().map_err(|error| WriteError::new(path, error))
}

/// Checks that a file can be created at `path`, without creating it.
///
/// # Errors
/// The folder does not exist or does not accept new files.
pub fn check_writable(path: &Path) -> Result<(), WriteError> {
    check_folder_writable(parent_folder(path)).map_err(|error| WriteError::new(path, error))
}

/// Checks that files can be created in a folder, by creating and removing one.
///
/// # Errors
/// The folder does not exist or does not accept new files.
pub fn check_folder_writable(folder: &Path) -> io::Result<()> {
    temporary_file(folder).map(drop)
}

/// The folder that a file is in: the current one for a bare file name.
pub(super) fn parent_folder(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// A temporary file in a folder. It is removed when dropped, unless it was renamed before.
fn temporary_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".lightfall-").suffix(".part");
    // By default only the owner may read a temporary file. These permissions, reduced by the
    // umask, are those of every other new file.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
        .tempfile_in(folder)
        .map_err(|error| match error.kind() {
            // The error's own message names the temporary file, which means nothing to the user.
            ErrorKind::NotFound => io::Error::new(ErrorKind::NotFound, "there is no such folder"),
            kind => kind.into(),
        })
}
