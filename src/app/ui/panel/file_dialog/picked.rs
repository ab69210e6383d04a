//! What comes of a file dialog.

use lightfall_core::scene::Scene;
use std::path::PathBuf;

/// What came of the dialog.
#[derive(Clone)]
pub(in super::super) enum Picked {
    /// The user chose this file, which holds this scene, or why it holds none. A browser says only the
    /// file's name.
    File(PathBuf, Box<Result<Scene, String>>),
    /// The user chose none.
    Nothing,
    /// There is no file dialog.
    NoDialog,
}
