//! The settings that outlast the program: a TOML file in the platform's folder for settings.

use super::settings_fault::{SettingsFault, Unused};
use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::key_labels::KeyLabels;
use lightfall_core::gpu::AdapterName;
use lightfall_core::optics::readout::si::{HoleMass, MASSES};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::reason::reason;
use lightfall_core::scene::TomlFault;
use lightfall_platform::storage::{self, TextError};
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::Path;

/// The settings. A file may leave out fields, which then have their defaults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Settings {
    /// Version of the file's format. A file without it has version 1.
    pub version: i64,
    /// Size of texts and panels, as a multiple of the desktop's.
    pub ui_scale: f32,
    /// Whether the picture gets coarser while something moves, to hold the frame rate.
    pub automatic_resolution: Automatic,
    /// Whether a picture at rest is the mean of several frames.
    pub average_at_rest: Automatic,
    /// Whether the picture is shown in large cells: the pixel look.
    pub pixel_look: bool,
    /// Whether the picture has the window's shape or the preset's.
    pub picture_shape: PictureShape,
    /// The frame rate to hold, in frames per second.
    pub frame_rate: f64,
    /// The largest number of frames per second. 0 leaves it to the monitor.
    pub most_frames: f64,
    /// Accepted in files of earlier versions, without effect: the exposure is automatic where the
    /// scene says so.
    #[serde(skip_serializing)]
    pub automatic_exposure: IgnoredAny,
    /// Whether motion that nobody steers is kept calm: journeys do not roll, and the exposure does
    /// not change during a flight.
    pub reduced_motion: bool,
    /// Whether texts give kilometres and minutes for a hole of `hole_mass_suns` in place of r_s and
    /// r_s/c, and leave out what only specialists ask for.
    pub simple_words: bool,
    /// Whether the most important keys are named in the window's corner.
    pub key_hints: bool,
    /// Whether the user has chosen `key_hints`, which then does not go away after some use.
    pub keep_key_hints: bool,
    /// Factor of how far the mouse turns the camera.
    pub mouse_sensitivity: f64,
    /// Whether the camera looks down when the mouse or the stick moves up.
    pub invert_y: bool,
    /// Loudness of what the ship's pilot hears, from 0 for silence to 1.
    pub volume: f64,
    /// The hole's mass for the read-outs, in solar masses.
    pub hole_mass_suns: f64,
    /// Who answers questions and flies missions, for the results that a class hands in. Empty for nobody.
    pub pupil: String,
    /// The graphics adapter that draws the window from the next start on. None for the best.
    pub adapter: Option<AdapterName>,
    /// Keys of the controls whose keys differ from the defaults.
    pub keys: BTreeMap<String, Vec<String>>,
    /// Gamepad buttons of the controls whose buttons differ from the defaults.
    pub buttons: BTreeMap<String, Vec<String>>,
}

/// The version of settings that this program reads and writes. It rises with each release that adds
/// fields or changes their meaning: an older program then leaves the file alone, instead of taking it
/// for a broken one.
pub const SETTINGS_VERSION: i64 = 1;

/// Whether something is done that suits some adapters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Automatic {
    /// Where it suits the adapter: the automatic resolution on software adapters and on those that
    /// are part of the processor, means at rest on all but software adapters.
    #[default]
    Auto,
    /// Always.
    On,
    /// Never.
    Off,
}

/// The shape of the picture in the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PictureShape {
    /// The window's: the picture fills it.
    #[default]
    Window,
    /// The preset's, with a black frame where the window has another one.
    Preset,
}

/// Maximum size of a settings file.
const MAX_BYTES: u64 = 1 << 20;

/// The range of `ui_scale`, in which texts still fit into a window.
pub const UI_SCALES: [f32; 2] = [0.6, 2.5];
/// The range of `mouse_sensitivity`.
pub const MOUSE_SENSITIVITIES: [f64; 2] = [0.1, 5.0];
/// The range of `volume`.
pub const VOLUMES: [f64; 2] = [0.0, 1.0];
/// The range of the hole's mass, in solar masses.
pub const HOLE_MASSES: [f64; 2] = [0.1, 1e11];
/// The largest number of characters of `pupil`.
pub const MAX_PUPIL_CHARS: usize = 60;
/// The range of the frame rates, in frames per second.
pub const FRAME_RATES: [f64; 2] = [5.0, 240.0];

impl Default for Settings {
    fn default() -> Self {
        Self {
            version: SETTINGS_VERSION,
            ui_scale: 1.0,
            automatic_resolution: Automatic::Auto,
            average_at_rest: Automatic::Auto,
            pixel_look: true,
            picture_shape: PictureShape::Window,
            frame_rate: 30.0,
            most_frames: 0.0,
            automatic_exposure: IgnoredAny,
            reduced_motion: false,
            simple_words: false,
            key_hints: true,
            keep_key_hints: false,
            mouse_sensitivity: 1.0,
            invert_y: false,
            volume: 0.5,
            hole_mass_suns: MASSES[0].suns,
            pupil: String::new(),
            adapter: None,
            keys: BTreeMap::new(),
            buttons: BTreeMap::new(),
        }
    }
}

impl Settings {
    /// The hole's mass for the read-outs.
    pub(crate) fn mass(&self) -> HoleMass {
        HoleMass::of_suns(self.hole_mass_suns)
    }

    /// The units of texts.
    pub(crate) fn units(&self) -> Units {
        match self.simple_words {
            true => Units::Everyday(self.mass()),
            false => Units::Hole,
        }
    }

    /// Reads the text of a settings file.
    ///
    /// # Errors
    /// The file is of a newer version, or it is wrong: one clause names the line or the field, and
    /// what is wrong with it.
    pub fn read(text: &str) -> Result<Self, SettingsFault> {
        // The version first: a newer file may have fields that this program does not know.
        match version_of(text) {
            Some(version) if version > SETTINGS_VERSION => Err(SettingsFault::Newer {
                version,
                known: SETTINGS_VERSION,
            }),
            _ => Self::read_present(text).map_err(SettingsFault::Wrong),
        }
    }

    /// Reads the text of a settings file that is not of a newer version.
    fn read_present(text: &str) -> Result<Self, String> {
        let settings: Self =
            toml::from_str(text).map_err(|error| TomlFault::new(text, &error).to_string())?;
        settings.check().map(|()| settings)
    }

    fn check(&self) -> Result<(), String> {
        let within = |name: &str, value: f64, [low, high]: [f64; 2]| match value {
            value if (low..=high).contains(&value) => Ok(()),
            value => Err(format!(
                "{name} = {value} is refused: it must be a number from {low} to {high}"
            )),
        };
        if self.version != SETTINGS_VERSION {
            return Err(format!(
                "version = {} is refused: it must be {SETTINGS_VERSION}",
                self.version
            ));
        }
        within(
            "ui_scale",
            f64::from(self.ui_scale),
            UI_SCALES.map(|scale| (f64::from(scale) * 1e4).round() / 1e4),
        )?;
        within("frame_rate", self.frame_rate, FRAME_RATES)?;
        if self.most_frames != 0.0 {
            within("most_frames", self.most_frames, FRAME_RATES)
                .map_err(|error| format!("{error}, or 0 for as many as the monitor shows"))?;
        }
        within(
            "mouse_sensitivity",
            self.mouse_sensitivity,
            MOUSE_SENSITIVITIES,
        )?;
        within("volume", self.volume, VOLUMES)?;
        within("hole_mass_suns", self.hole_mass_suns, HOLE_MASSES)?;
        if !is_line(&self.pupil, MAX_PUPIL_CHARS) {
            return Err(format!(
                "pupil = {:?} is refused: it must be one line of at most {MAX_PUPIL_CHARS} characters",
                self.pupil
            ));
        }
        let usual = KeyLabels::default();
        Bindings::new(&self.keys, &usual)?;
        PadBindings::new(&self.buttons, &usual).map(drop)
    }

    /// Reads a settings file. A file that does not exist gives the defaults. So do a broken file,
    /// which is renamed, and one of a newer version, which stays as it is; the second value then
    /// says so.
    #[must_use]
    pub fn load(file: &Path) -> (Self, Option<Unused>) {
        match Self::read_file(file) {
            Ok(settings) => (settings.unwrap_or_default(), None),
            Err(fault) => (Self::default(), Some(Unused::new(file, &fault))),
        }
    }

    /// Reads a settings file and leaves it as it is. None if there is no such file.
    ///
    /// # Errors
    /// The file cannot be read, or as [`read`](Self::read).
    pub fn read_file(file: &Path) -> Result<Option<Self>, SettingsFault> {
        match storage::read_text(file, MAX_BYTES) {
            Ok(text) => Self::read(&text).map(Some),
            Err(TextError::Unreadable(error)) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error @ TextError::Unreadable(_)) => Err(SettingsFault::Wrong(error.to_string())),
            Err(fault) => Err(SettingsFault::Wrong(format!("cannot be read: it {fault}"))),
        }
    }

    /// Writes the settings to a file.
    ///
    /// # Errors
    /// The file's name and the file system's reason.
    pub fn save(&self, file: &Path) -> Result<(), String> {
        let fields = toml::to_string_pretty(self);
        let fields = fields.expect("settings consist of numbers, words and tables");
        let text = format!(
            "# Settings of Lightfall. Fields that are left out have their defaults.\n\n{fields}"
        );
        let written = storage::create_parent_folder(file)
            .and_then(|()| storage::write_atomically(file, text.as_bytes()));
        written.map_err(|error| {
            format!(
                "{}: the settings cannot be written: {}",
                file.display(),
                reason(&error.source)
            )
        })
    }
}

/// Whether a text is one line, of so many characters at most.
fn is_line(text: &str, most: usize) -> bool {
    text.chars().count() <= most && !text.chars().any(char::is_control)
}

/// The version that a settings file names, if it is TOML and names one.
fn version_of(text: &str) -> Option<i64> {
    toml::from_str::<toml::Table>(text)
        .ok()?
        .get("version")?
        .as_integer()
}
