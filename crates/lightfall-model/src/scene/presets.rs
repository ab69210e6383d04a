//! The built-in presets, part of the program itself, so that they are found wherever it runs.

use std::sync::LazyLock;

use super::{Override, Scene, SceneError, load};

/// A built-in preset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its number, from 1; up to 9 also its key in the window.
    pub number: usize,
    /// Its name; the same as in its text.
    pub name: &'static str,
    /// Its text, in TOML.
    pub text: &'static str,
}

/// The number of the preset that is shown if none is asked for.
pub const DEFAULT: usize = 2;

macro_rules! presets {
    ($($number:literal $name:literal),* $(,)?) => {
        [$(Preset {
            number: $number,
            name: $name,
            text: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/presets/", $number, "-", $name, ".toml")),
        }),*]
    };
}

/// The presets in the order of their numbers.
pub const PRESETS: [Preset; 18] = presets![
    1 "telescope",
    2 "edge-on",
    3 "above",
    4 "close",
    5 "einstein-ring",
    6 "probe",
    7 "limit",
    8 "extremal",
    9 "falling",
    10 "article",
    11 "flare",
    12 "ring",
    13 "orion",
    14 "thick",
    15 "torus",
    16 "close-thick",
    17 "lanes",
    18 "jet",
];

/// The preset with this number or name.
pub fn find(number_or_name: &str) -> Option<&'static Preset> {
    PRESETS
        .iter()
        .find(|preset| preset.name == number_or_name || preset.number.to_string() == number_or_name)
}

/// The numbers and names of all presets, for messages.
pub fn numbered_names() -> String {
    PRESETS
        .map(|preset| format!("{} {}", preset.number, preset.name))
        .join(", ")
}

/// The scenes of all presets, read once.
static SCENES: LazyLock<Vec<Scene>> = LazyLock::new(|| {
    let scenes = PRESETS.iter().map(|preset| preset.load(&[]));
    scenes
        .collect::<Result<_, _>>()
        .expect("every built-in preset is a scene")
});

impl Preset {
    /// The preset's scene as it is written.
    pub fn plain_scene(&self) -> &'static Scene {
        &SCENES[self.number - 1]
    }

    /// The preset's scene, with some fields set to other values.
    ///
    /// # Errors
    /// An override is wrong, or the preset's other fields do not allow it; without overrides,
    /// never.
    pub fn scene(&self, overrides: &[Override]) -> Result<Scene, SceneError> {
        if overrides.is_empty() {
            return Ok(self.plain_scene().clone());
        }
        self.load(overrides)
    }

    fn load(&self, overrides: &[Override]) -> Result<Scene, SceneError> {
        load(
            &format!("preset {} ({})", self.number, self.name),
            self.text,
            overrides,
        )
    }
}
