//! Systems that do not tell the layout: macOS and browsers.

use crate::app::controls::key_labels::KeyLabels;
use bevy::prelude::KeyCode;

/// None: the layout is learned.
pub(super) fn labels(_: Option<(KeyCode, char)>) -> Option<KeyLabels> {
    None
}
