//! The desktop's file dialog. A thread of its own waits for it, so that the window goes on.

use super::Picked;
use bevy::log::warn;
use lightfall_platform::file_dialog::{FileRequest, pick_file};
use lightfall_platform::storage::{open_file, presets_folder};

/// Opens the dialog, in the folder of the user's presets if it exists, and hands over what comes of it.
pub(super) fn ask(answer: impl FnOnce(Picked) + Send + 'static) {
    std::thread::spawn(move || {
        let picked = pick_file(&FileRequest {
            title: "Open a preset, a mission, a lesson or a picture",
            kind: "Presets, missions, lessons and pictures",
            extensions: &["toml", "png", "exr"],
            folder: presets_folder().filter(|folder| folder.is_dir()),
        });
        answer(match picked {
            Ok(Some(file)) => {
                let opened = open_file(&file, &[]).map_err(|error| error.to_string());
                Picked::File(file, Box::new(opened))
            }
            Ok(None) => Picked::Nothing,
            Err(reason) => {
                warn!("no file dialog: {reason}");
                Picked::NoDialog
            }
        });
    });
}
