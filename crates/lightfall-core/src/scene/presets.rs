//! The built-in presets, part of the program itself so that no missing folder can break it.

use super::{Override, Scene, SceneError, load};

/// A built-in preset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its number, from 1; also its key in flight.
    pub number: usize,
    /// Its name; the same as in its text.
    pub name: &'static str,
    /// Its text, in TOML.
    pub text: &'static str,
}

/// The number of the preset that is shown where none is asked for.
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
pub const PRESETS: [Preset; 9] = presets![
    1 "telescope",
    2 "edge-on",
    3 "above",
    4 "close",
    5 "einstein-ring",
    6 "probe",
    7 "limit",
    8 "extremal",
    9 "falling",
];

/// The preset with this number or name.
pub fn find(number_or_name: &str) -> Option<&'static Preset> {
    PRESETS
        .iter()
        .find(|preset| preset.name == number_or_name || preset.number.to_string() == number_or_name)
}

impl Preset {
    /// The preset's scene, with some fields set otherwise.
    ///
    /// # ErrorSummary
    /// An override is wrong, or does not fit the preset; without overrides, never.
    pub fn scene(&self, overrides: &[Override]) -> Result<Scene, SceneError> {
        load(
            &format!("preset {} ({})", self.number, self.name),
            self.text,
            overrides,
        )
    }
}
