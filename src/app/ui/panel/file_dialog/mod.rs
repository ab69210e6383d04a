//! The file dialog of the desktop or of the browser.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;

#[cfg(target_arch = "wasm32")]
pub(super) use browser::FileDialog;
#[cfg(not(target_arch = "wasm32"))]
pub(super) use desktop::FileDialog;

use lightfall_core::scene::Scene;
use std::path::PathBuf;

/// What came of the dialog.
#[derive(Clone)]
pub(super) enum Picked {
    /// The user chose this file, which holds this scene, or why it holds none. A browser says only the
    /// file's name.
    File(PathBuf, Box<Result<Scene, String>>),
    /// The user chose none.
    Nothing,
    /// There is no file dialog.
    NoDialog,
}
