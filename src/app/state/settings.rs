//! What the program remembers from one start to the next: a TOML file in the platform's folder for
//! settings.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::storage;
use lightfall_core::gpu::AdapterName;
use lightfall_core::optics::readout::si::MASSES;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::Path;

/// Everything that is remembered. A file may leave out what it does not change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Settings {
    /// Size of the text and the panel, as a multiple of the desktop's.
    pub ui_scale: f32,
    /// Whether the picture gets coarser while something moves, so that the frame rate is held.
    pub automatic_resolution: Automatic,
    /// The frame rate that is held, in frames a second.
    pub frame_rate: f64,
    /// Most frames a second; 0 leaves it to the monitor.
    pub most_frames: f64,
    /// Whether the exposure follows the light.
    pub automatic_exposure: bool,
    /// Whether motion that nobody steers is kept calm: no roll in journeys, no exposure that
    /// changes by itself.
    pub reduced_motion: bool,
    /// The hole's mass for the read-outs, in suns.
    pub hole_mass_suns: f64,
    /// The graphics adapter that the window is drawn with, from the next start on; none for the
    /// best.
    pub adapter: Option<AdapterName>,
    /// Keys of the controls that differ from the key table.
    pub keys: BTreeMap<String, Vec<String>>,
    /// Buttons of a gamepad, likewise.
    pub buttons: BTreeMap<String, Vec<String>>,
}

/// Whether something is done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Automatic {
    /// Where the graphics adapter is software or part of the processor.
    #[default]
    Auto,
    /// Always.
    On,
    /// Never.
    Off,
}

/// Sizes of the text that still fit into a window.
pub const UI_SCALES: [f32; 2] = [0.6, 2.5];
/// Masses that can be chosen, in suns.
pub const HOLE_MASSES: [f64; 2] = [0.1, 1e11];
/// Frame rates that can be asked for.
pub const FRAME_RATES: [f64; 2] = [5.0, 240.0];

impl Default for Settings {
    fn default() -> Self {
        Self {
            ui_scale: 1.0,
            automatic_resolution: Automatic::Auto,
            frame_rate: 30.0,
            most_frames: 0.0,
            automatic_exposure: false,
            reduced_motion: false,
            hole_mass_suns: MASSES[0].suns,
            adapter: None,
            keys: BTreeMap::new(),
            buttons: BTreeMap::new(),
        }
    }
}

impl Settings {
    /// Whether the exposure follows the light.
    #[must_use]
    pub fn follows_light(&self) -> bool {
        self.automatic_exposure && !self.reduced_motion
    }

    /// Reads the text of a settings file.
    ///
    /// # Errors
    /// One sentence that names the fault.
    pub fn read(text: &str) -> Result<Self, String> {
        let settings: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| {
                1 + text[..span.start.min(text.len())].matches('\n').count()
            });
            format!(
                "line {line}: {}",
                error.message().lines().collect::<Vec<_>>().join(", ")
            )
        })?;
        settings.check().map(|()| settings)
    }

    fn check(&self) -> Result<(), String> {
        let within = |name: &str, value: f64, [low, high]: [f64; 2]| match value {
            value if (low..=high).contains(&value) => Ok(()),
            value => Err(format!(
                "{name} = {value} is refused: it must be a number from {low} to {high}"
            )),
        };
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
        within("hole_mass_suns", self.hole_mass_suns, HOLE_MASSES)?;
        Bindings::new(&self.keys)?;
        PadBindings::new(&self.buttons).map(drop)
    }

    /// Reads a settings file. Without one, the defaults; a broken one is renamed, and the defaults
    /// serve. The second value says what was wrong.
    #[must_use]
    pub fn load(file: &Path) -> (Self, Option<String>) {
        match Self::look(file) {
            Ok(settings) => (settings.unwrap_or_default(), None),
            Err(fault) => (
                Self::default(),
                Some(format!("{}: {fault}; {}", file.display(), set_aside(file))),
            ),
        }
    }

    /// What a settings file says; none where there is no such file. It is left as it is.
    ///
    /// # Errors
    /// One clause that names the fault, without the file.
    pub fn look(file: &Path) -> Result<Option<Self>, String> {
        match std::fs::read_to_string(file) {
            Ok(text) => Self::read(&text).map(Some),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(format!("cannot be read: {error}")),
        }
    }

    /// Writes the settings; the file appears whole or not at all.
    ///
    /// # Errors
    /// What the file system says, with the file's name.
    pub fn save(&self, file: &Path) -> Result<(), String> {
        let text = format!(
            "# Settings of Lightfall. What is left out has its default.\n\n{}",
            self.text()
        );
        let written = storage::create_parent_folder(file)
            .and_then(|()| storage::write_atomically(file, text.as_bytes()));
        written.map_err(|error| {
            format!(
                "{}: the settings cannot be written: {}",
                file.display(),
                error.source
            )
        })
    }

    fn text(&self) -> String {
        toml::to_string_pretty(self).expect("settings are made of numbers, words and tables only")
    }
}

/// Renames a file that is no use, so that nothing a user wrote is lost, and says how that went.
fn set_aside(file: &Path) -> String {
    let names = (1..1000).map(|number| file.with_extension(format!("broken-{number}.toml")));
    let Some(aside) = names.into_iter().find(|name| !name.exists()) else {
        return "default settings are used".into();
    };
    match std::fs::rename(file, &aside) {
        Ok(()) => format!(
            "it is kept as {}, and default settings are used",
            aside.display()
        ),
        Err(_) => "default settings are used".into(),
    }
}
