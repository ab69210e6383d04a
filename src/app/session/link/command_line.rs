//! The command line that opens a scene.

use crate::app::session::clipboard::Clipboard;
use lightfall_core::scene::{Changes, Scene};

/// Copies the command line, and says so.
pub(crate) fn copy_link(scene: &Scene, clipboard: &Clipboard) -> String {
    clipboard.copy(command_line(scene));
    "Copied the command line that opens this scene".into()
}

/// The command line that opens this scene, quoted for the shells of Unix.
#[must_use]
pub fn command_line(scene: &Scene) -> String {
    let Changes { preset, fields } = Changes::of(scene);
    let sets = fields.iter().map(|(key, value)| {
        let set = format!("{key}={value}");
        // An apostrophe ends such a quotation.
        format!(" --set '{}'", set.replace('\'', r"'\''"))
    });
    format!(
        "lightfall --preset {}{}",
        preset.name,
        sets.collect::<String>()
    )
}
