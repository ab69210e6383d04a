//! The browser's file dialog. It hands over a file's contents, not its path.

use super::Picked;
use lightfall_platform::browser::pick_file;
use lightfall_platform::storage::open_contents;
use std::path::PathBuf;

/// Opens the dialog, and hands over what comes of it.
pub(super) fn ask(answer: impl FnOnce(Picked) + Clone + 'static) {
    let picked = answer.clone();
    let opened = pick_file(".toml,.png", move |file| {
        picked(file.map_or(Picked::Nothing, |(name, contents)| {
            let name = PathBuf::from(name);
            let opened = open_contents(&name, contents, &[]).map_err(|error| error.to_string());
            Picked::File(name, Box::new(opened))
        }));
    });
    if opened.is_err() {
        answer(Picked::NoDialog);
    }
}
