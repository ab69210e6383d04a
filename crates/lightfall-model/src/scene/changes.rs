//! A scene as a preset and what differs from it: short enough for a link or a command line.

use super::presets::{DEFAULT, PRESETS, Preset, find};
use super::{Scene, Value};

/// A scene as changes of a built-in preset.
#[derive(Clone, Debug, PartialEq)]
pub struct Changes {
    /// The preset that the scene is named after, else the default one.
    pub preset: &'static Preset,
    /// The fields whose values differ from the preset's, with their values in the scene. A metered
    /// exposure is left out.
    pub fields: Vec<(&'static str, Value)>,
}

impl Changes {
    /// The changes that make this scene. [`Preset::scene`] makes it again from them.
    pub fn of(scene: &Scene) -> Self {
        let preset = find(&scene.name).unwrap_or(&PRESETS[DEFAULT - 1]);
        let mut fields = scene.differences(preset.plain_scene());
        // Setting the exposure switches the automatic one off.
        fields
            .retain(|(key, _)| !scene.picture.automatic_exposure || *key != "picture.exposure_ev");
        Self { preset, fields }
    }
}
