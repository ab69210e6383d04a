//! Files that are too large to be written at once.

use super::disk::{parent_folder, temporary_file};
use super::write_error::WriteError;
use std::fs::File;
use std::path::{Path, PathBuf, absolute};
use tempfile::NamedTempFile;

/// A file that is written piece by piece. It appears under its name when it is finished. Until then
/// it is a temporary file in the same folder, which is removed when it is dropped.
#[derive(Debug)]
pub struct NewFile {
    path: PathBuf,
    file: NamedTempFile,
}

impl NewFile {
    /// Begins a file.
    ///
    /// # Errors
    /// Its folder does not exist or does not accept new files.
    pub fn create(path: &Path) -> Result<Self, WriteError> {
        let file =
            temporary_file(parent_folder(path)).map_err(|error| WriteError::new(path, error))?;
        Ok(Self {
            path: path.into(),
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
        let Self { path, file } = self;
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
