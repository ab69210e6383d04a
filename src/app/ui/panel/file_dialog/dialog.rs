//! The open dialog, whose answer comes some frames later.

#[cfg(target_arch = "wasm32")]
use super::browser::ask;
#[cfg(not(target_arch = "wasm32"))]
use super::desktop::ask;
use super::picked::Picked;
use std::sync::{Arc, OnceLock};

/// The dialog that is open, if one is.
#[derive(Default)]
pub(in super::super) struct FileDialog(Option<Arc<OnceLock<Picked>>>);

impl FileDialog {
    /// Whether a dialog is open.
    pub(in super::super) fn is_open(&self) -> bool {
        self.0.is_some()
    }

    /// Opens the dialog.
    pub(in super::super) fn open(&mut self) {
        let answer = Arc::new(OnceLock::new());
        self.0 = Some(Arc::clone(&answer));
        // A dialog answers once.
        ask(move |picked| {
            answer.set(picked).ok();
        });
    }

    /// What came of the dialog. None while it is open, or if it was never opened.
    pub(in super::super) fn answer(&mut self) -> Option<Picked> {
        let picked = self.0.as_ref()?.get()?.clone();
        self.0 = None;
        Some(picked)
    }
}
