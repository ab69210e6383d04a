//! Files that are too large to be written at once.

use super::disk::{parent_folder, temporary_file};
use super::write_error::WriteError;
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::{Path, PathBuf, absolute};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tempfile::NamedTempFile;

/// The temporary files that exist now.
static UNFINISHED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

fn unfinished() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The place of a temporary file among those that exist.
#[derive(Debug)]
struct Unfinished(PathBuf);

impl Drop for Unfinished {
    fn drop(&mut self) {
        unfinished().remove(&self.0);
    }
}

/// Removes every file that is not finished, and keeps further ones from being begun, for a program that
/// ends at once. A file that cannot be removed is left without a message, because the program is ending.
pub fn remove_unfinished() {
    let files = unfinished();
    for file in files.iter() {
        fs::remove_file(file).ok();
    }
    // The lock is kept, so a thread that begins or finishes a file from here on waits until the program ends.
    std::mem::forget(files);
}

/// A file that is written piece by piece. It appears under its name when it is finished. Until then
/// it is a temporary file in the same folder, which is removed when it is dropped.
#[derive(Debug)]
pub struct NewFile {
    path: PathBuf,
    file: NamedTempFile,
    // Dropped after `file`, so that the temporary file is gone by then.
    unfinished: Unfinished,
}

impl NewFile {
    /// Begins a file.
    ///
    /// # Errors
    /// Its folder does not exist or does not accept new files.
    pub fn create(path: &Path) -> Result<Self, WriteError> {
        // No file is begun between the removal of all of them and the program's end.
        let mut all = unfinished();
        let file =
            temporary_file(parent_folder(path)).map_err(|error| WriteError::new(path, error))?;
        all.insert(file.path().into());
        Ok(Self {
            path: path.into(),
            unfinished: Unfinished(file.path().into()),
            file,
        })
    }

    /// The file to write to.
    pub fn file(&mut self) -> &mut File {
        self.file.as_file_mut()
    }

    /// Where the file is until it is finished: for another program, which writes it.
    #[must_use]
    pub fn temporary_path(&self) -> PathBuf {
        let path = self.file.path();
        absolute(path).unwrap_or_else(|_| path.into())
    }

    /// Gives the complete file its name, and replaces an older one of the same name.
    ///
    /// # Errors
    /// The file cannot be written to the end or renamed.
    pub fn finish(self) -> Result<(), WriteError> {
        let Self {
            path,
            file,
            unfinished: _unfinished,
        } = self;
        let finish = || {
            file.as_file().sync_all()?;
            file.persist(&path).map_err(|error| error.error)?;
            Ok(())
        };
        finish().map_err(|error| WriteError::new(&path, error))
    }
}

/// A file without a name in the folder of another one. It is gone when it is dropped, or when the
/// program ends.
///
/// # Errors
/// The folder does not exist or does not accept new files. The error names the other file.
pub fn scratch_file(beside: &Path) -> Result<File, WriteError> {
    tempfile::tempfile_in(parent_folder(beside)).map_err(|error| WriteError::new(beside, error))
}

/// Free space in the folder of a file for a user without special rights, in bytes; `None` where the
/// system does not say.
#[must_use]
pub fn free_space(file: &Path) -> Option<u64> {
    #[cfg(unix)]
    {
        let found = rustix::fs::statvfs(parent_folder(file)).ok()?;
        found.f_bavail.checked_mul(found.f_frsize)
    }
    #[cfg(not(unix))]
    {
        let _ = file;
        None
    }
}
