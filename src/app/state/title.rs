//! The title of a scene, which is shown for some seconds after the scene was chosen.

use bevy::prelude::Resource;
use lightfall_core::scene::Scene;
use lightfall_core::scene::presets::PRESETS;
use std::time::Duration;

/// What is shown, and since when. Times are since the program's start.
#[derive(Resource, Default)]
pub(crate) struct Title {
    /// The name of a built-in preset with its number, or the title of another scene, or its name where
    /// it has no title. Empty while no title is shown.
    pub(crate) name: String,
    /// One line that says what there is to see.
    pub(crate) line: String,
    /// When the title came. None before its first frame.
    pub(crate) came: Option<Duration>,
    /// When the scene's picture was drawn. None before.
    pub(crate) drawn: Option<Duration>,
}

impl Title {
    /// The title of a scene that was just chosen.
    pub(crate) fn of(scene: &Scene) -> Self {
        let preset = PRESETS.iter().find(|preset| preset.name == scene.name);
        let name = in_words(&scene.name);
        let title = scene.title.trim();
        let (name, line) = match preset {
            Some(preset) => (format!("{}  {name}", preset.number), title),
            None if title.is_empty() => (name, ""),
            None => (title.to_owned(), ""),
        };
        Self {
            name,
            line: line.to_owned(),
            came: None,
            drawn: None,
        }
    }

    /// Whether there is a title to show.
    pub(crate) fn is_shown(&self) -> bool {
        !self.name.is_empty()
    }

    /// Takes the title away.
    pub(crate) fn close(&mut self) {
        *self = Self::default();
    }
}

/// A scene's name as words, e.g. `Edge on` for `edge-on`.
fn in_words(name: &str) -> String {
    let mut words = name.replace(['-', '_'], " ");
    if let Some(first) = words.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    words
}
