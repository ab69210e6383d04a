//! The file dialog of the desktop or of the browser, whose answer comes some frames later.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;

#[cfg(target_arch = "wasm32")]
use browser::ask;
#[cfg(not(target_arch = "wasm32"))]
use desktop::ask;
use lightfall_platform::storage::Opened;
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

/// What came of the dialog.
#[derive(Clone)]
pub(super) enum Picked {
    /// The user chose this file, which holds this, or why it holds nothing. A browser says only the
    /// file's name.
    File(PathBuf, Box<Result<Opened, String>>),
    /// The user cancelled the dialog.
    Nothing,
    /// There is no file dialog, or it gave no answer.
    NoDialog,
}

/// The dialog that is open, if one is.
#[derive(Default)]
pub(super) struct FileDialog(Option<Arc<OnceLock<Picked>>>);

impl FileDialog {
    /// Whether a dialog is open.
    pub(super) fn is_open(&self) -> bool {
        self.0.is_some()
    }

    /// Opens the dialog.
    pub(super) fn open(&mut self) {
        let answer = Arc::new(OnceLock::new());
        self.0 = Some(Arc::clone(&answer));
        // A dialog answers once.
        ask(move |picked| {
            answer.set(picked).ok();
        });
    }

    /// What came of the dialog. None while it is open, or if it was never opened.
    pub(super) fn answer(&mut self) -> Option<Picked> {
        let picked = self.0.as_ref()?.get()?.clone();
        self.0 = None;
        Some(picked)
    }
}
