//! The browser's file dialog. It hands over a file's contents, not its path.

use super::picked::Picked;
use crate::browser::pick_file;
use crate::storage::scene_of_file;
use std::path::PathBuf;
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
        let picked = Arc::clone(&answer);
        let opened = pick_file(".toml,.png", move |file| {
            let file = file.map_or(Picked::Nothing, |(name, contents)| {
                let name = PathBuf::from(name);
                let scene = scene_of_file(&name, contents, &[]).map_err(|error| error.to_string());
                Picked::File(name, Box::new(scene))
            });
            picked.set(file).ok();
        });
        if opened.is_err() {
            answer.set(Picked::NoDialog).ok();
        }
        self.0 = Some(answer);
    }

    /// What came of the dialog. None while it is open, or if it was never opened.
    pub(in super::super) fn answer(&mut self) -> Option<Picked> {
        let picked = self.0.as_ref()?.get()?.clone();
        self.0 = None;
        Some(picked)
    }
}
