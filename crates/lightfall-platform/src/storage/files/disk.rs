//! Files of the file system. Those that are written appear complete or not at all.

use super::new_file::NewFile;
use super::write_error::WriteError;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Writes a file and replaces an older one of the same name. The file appears under its name only
/// when it is complete, so an interrupted program leaves no partial file.
///
/// # Errors
/// The folder does not exist, or the file cannot be written.
pub fn write_atomically(path: &Path, contents: &[u8]) -> Result<(), WriteError> {
    let mut file = NewFile::create(path)?;
    file.file()
        .write_all(contents)
        .map_err(|error| WriteError::new(path, error))?;
    file.finish()
}

/// Writes a new file, complete or not at all.
///
/// # Errors
/// There is a file of this name already, which stays as it is; or the folder does not exist, or the
/// file cannot be written.
pub fn write_new(path: &Path, contents: &[u8]) -> Result<(), WriteError> {
    let write = || {
        let mut file = temporary_file(parent_folder(path))?;
        file.write_all(contents)?;
        file.as_file().sync_all()?;
        file.persist_noclobber(path).map_err(|error| error.error)?;
        Ok(())
    };
    write().map_err(|error| WriteError::new(path, error))
}

/// Checks that a file can be created at `path`, without creating it.
///
/// # Errors
/// It is a folder or no regular file, or its name is too long; or its folder does not exist or does not accept new
/// files.
pub fn check_writable(path: &Path) -> Result<(), WriteError> {
    check_name(path)?;
    check_folder_writable(parent_folder(path)).map_err(|error| WriteError::new(path, error))
}

/// Checks that a file in a folder that accepts new files can have this name. It only looks, so it is
/// quick enough for the files of a long sequence.
///
/// # Errors
/// It is a folder or no regular file, or its name is too long.
pub fn check_name(path: &Path) -> Result<(), WriteError> {
    let reason = match fs::metadata(path) {
        Ok(found) if found.is_dir() => io::Error::new(ErrorKind::IsADirectory, "it is a folder"),
        // The complete file would take the place of a device or a pipe.
        Ok(found) if !found.is_file() => io::Error::other("it is not a regular file"),
        Err(error) if error.kind() == ErrorKind::InvalidFilename => error,
        _ => return Ok(()),
    };
    Err(WriteError::new(path, reason))
}

/// Checks that files can be created in a folder, by creating and removing one.
///
/// # Errors
/// The folder does not exist or does not accept new files.
pub fn check_folder_writable(folder: &Path) -> io::Result<()> {
    temporary_file(folder).map(drop)
}

/// Creates the folder of a file, with the folders above it.
///
/// # Errors
/// The folder cannot be created. The error names the file.
pub fn create_parent_folder(path: &Path) -> Result<(), WriteError> {
    fs::create_dir_all(parent_folder(path)).map_err(|error| WriteError::new(path, error))
}

/// Whether there is a file or a folder at `path`.
#[must_use]
pub fn exists(path: &Path) -> bool {
    path.exists()
}

/// The first `max_bytes` of a file, and one more if it is longer: some files, such as /dev/zero, have
/// no end.
///
/// # Errors
/// The file does not exist or cannot be read.
pub fn read(path: &Path, max_bytes: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?
        .take(max_bytes + 1)
        .read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Removes a file.
///
/// # Errors
/// The file does not exist or cannot be removed.
pub fn remove(path: &Path) -> io::Result<()> {
    fs::remove_file(path)
}

/// Renames a file.
///
/// # Errors
/// The file does not exist or cannot be renamed.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    fs::rename(from, to)
}

/// What is in a folder, in no order. A folder that does not exist holds nothing.
#[must_use]
pub fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).collect()
}

/// The folder that a file is in: the current one for a bare file name.
pub(super) fn parent_folder(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// A temporary file in a folder. It is removed when dropped, unless it was renamed before.
pub(super) fn temporary_file(folder: &Path) -> io::Result<NamedTempFile> {
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
            ErrorKind::NotFound if folder.is_dir() => {
                io::Error::new(ErrorKind::NotFound, "the folder accepts no new files")
            }
            ErrorKind::NotFound => io::Error::new(ErrorKind::NotFound, "there is no such folder"),
            kind => kind.into(),
        })
}
