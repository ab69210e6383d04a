//! The desktop's file dialog. A thread of its own waits for it, so that the window goes on.

use super::picked::Picked;
use crate::storage::{presets_folder, read_scene};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// A dialog that is gone sooner than this was never shown: nobody cancels so quickly.
const NEVER_SHOWN: Duration = Duration::from_millis(250);

/// The dialog that is open, if one is.
#[derive(Default)]
pub(in super::super) struct FileDialog(Option<Arc<OnceLock<Picked>>>);

impl FileDialog {
    /// Whether a dialog is open.
    pub(in super::super) fn is_open(&self) -> bool {
        self.0.is_some()
    }

    /// Opens the dialog, in the folder of the user's presets if it exists.
    pub(in super::super) fn open(&mut self) {
        let answer = Arc::new(OnceLock::new());
        let picked = Arc::clone(&answer);
        self.0 = Some(answer);
        std::thread::spawn(move || {
            let begin = Instant::now();
            let mut dialog = rfd::FileDialog::new()
                .set_title("Open a preset or a picture")
                .add_filter("Presets and pictures", &["toml", "png", "exr"]);
            if let Some(folder) = presets_folder().filter(|folder| folder.is_dir()) {
                dialog = dialog.set_directory(folder);
            }
            let file = dialog.pick_file();
            picked.set(match file {
                Some(file) => {
                    let scene = read_scene(&file, &[]).map_err(|error| error.to_string());
                    Picked::File(file, Box::new(scene))
                }
                None if begin.elapsed() < NEVER_SHOWN => Picked::NoDialog,
                None => Picked::Nothing,
            })
        });
    }

    /// What came of the dialog. None while it is open, or if it was never opened.
    pub(in super::super) fn answer(&mut self) -> Option<Picked> {
        let picked = self.0.as_ref()?.get()?.clone();
        self.0 = None;
        Some(picked)
    }
}
