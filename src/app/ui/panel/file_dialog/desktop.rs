//! The desktop's file dialog. A thread of its own waits for it, so that the window goes on.

use super::Picked;
use lightfall_platform::storage::{presets_folder, read_scene};
use std::time::{Duration, Instant};

/// A dialog that is gone sooner than this was never shown: nobody cancels so quickly.
const NEVER_SHOWN: Duration = Duration::from_millis(250);

/// Opens the dialog, in the folder of the user's presets if it exists, and hands over what comes of it.
pub(super) fn ask(answer: impl FnOnce(Picked) + Send + 'static) {
    std::thread::spawn(move || {
        let begin = Instant::now();
        let mut dialog = rfd::FileDialog::new()
            .set_title("Open a preset or a picture")
            .add_filter("Presets and pictures", &["toml", "png", "exr"]);
        if let Some(folder) = presets_folder().filter(|folder| folder.is_dir()) {
            dialog = dialog.set_directory(folder);
        }
        answer(match dialog.pick_file() {
            Some(file) => {
                let scene = read_scene(&file, &[]).map_err(|error| error.to_string());
                Picked::File(file, Box::new(scene))
            }
            None if begin.elapsed() < NEVER_SHOWN => Picked::NoDialog,
            None => Picked::Nothing,
        });
    });
}
