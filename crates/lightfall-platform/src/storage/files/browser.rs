//! Files as texts in the browser's storage, by their paths. The page's server never sees them.

use super::write_error::WriteError;
use crate::browser::Storage;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Writes a file and replaces an older one of the same name.
///
/// # Errors
/// The contents are not text, or the browser stores no more for this page.
pub fn write_atomically(path: &Path, contents: &[u8]) -> Result<(), WriteError> {
    let write = || {
        let text = std::str::from_utf8(contents).map_err(|_| ErrorKind::InvalidData)?;
        storage()?
            .set(&key(path), text)
            .map_err(|()| io::Error::other("the browser stores no more for this page"))
    };
    write().map_err(|error| WriteError::new(path, error))
}

/// Writes a new file.
///
/// # Errors
/// There is a file of this name already, or as [`write_atomically`].
pub fn write_new(path: &Path, contents: &[u8]) -> Result<(), WriteError> {
    if exists(path) {
        return Err(WriteError::new(path, ErrorKind::AlreadyExists.into()));
    }
    write_atomically(path, contents)
}

/// Creates nothing: folders exist by the paths of their files.
///
/// # Errors
/// None.
pub fn create_parent_folder(_: &Path) -> Result<(), WriteError> {
    Ok(())
}

/// Whether there is a file at `path`.
#[must_use]
pub fn exists(path: &Path) -> bool {
    contents(path).is_ok()
}

/// The contents of a file. The storage is small, so that no limit is needed.
///
/// # Errors
/// The file does not exist, or the browser has no storage.
pub fn read(path: &Path, _max_bytes: u64) -> io::Result<Vec<u8>> {
    contents(path).map(String::into_bytes)
}

/// Removes a file.
///
/// # Errors
/// The browser has no storage.
pub fn remove(path: &Path) -> io::Result<()> {
    storage()?.remove(&key(path));
    Ok(())
}

/// Renames a file.
///
/// # Errors
/// The file does not exist or cannot be renamed.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    let text = contents(from)?;
    write_atomically(to, text.as_bytes()).map_err(|error| error.source)?;
    remove(from)
}

/// The files in a folder, in no order.
#[must_use]
pub fn files_in(folder: &Path) -> Vec<PathBuf> {
    let keys = storage().map(|storage| storage.keys()).unwrap_or_default();
    let paths = keys.into_iter().map(PathBuf::from);
    paths.filter(|path| path.parent() == Some(folder)).collect()
}

fn contents(path: &Path) -> io::Result<String> {
    let text = storage()?.get(&key(path));
    text.ok_or_else(|| ErrorKind::NotFound.into())
}

fn storage() -> io::Result<Storage> {
    Storage::open().ok_or_else(|| io::Error::other("the browser gives this page no storage"))
}

fn key(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}
