//! The report as text for people: lines with a name and a finding.

use super::diagnosis::{Adapter, Diagnosis};
use super::places::Folder;
use super::self_test::SelfTest;
use super::shaders::ShaderCheck;
use lightfall_core::numbers::{four_digits, short_number};
use std::fmt::{Display, Formatter, Result};

/// Width of the column of names, in characters.
const NAME_WIDTH: usize = 12;

/// What stands in the place of a path where the system names none.
const NO_PLACE: &str = "no place on this system, see below";

impl Display for Diagnosis {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let mut line = |name: &str, found: &str| writeln!(f, "{name:NAME_WIDTH$}{found}");
        line("lightfall", self.version)?;
        let system = &self.system;
        line(
            "system",
            &format!(
                "{}, {}, cores: {}",
                system.os, system.architecture, system.cores
            ),
        )?;
        let none = system
            .no_display
            .as_ref()
            .map(|missing| format!("none: {missing}"))
            .unwrap_or_default();
        line("display", system.display.as_ref().unwrap_or(&none))?;
        line(
            "gamepads",
            if self.gamepads {
                "are read"
            } else {
                "are not read by this build"
            },
        )?;
        line(
            "sound",
            if self.sound {
                "is played at the ship's controls"
            } else {
                "is not played by this build"
            },
        )?;
        if self.adapters.is_empty() {
            line("adapter", "none")?;
        }
        for adapter in &self.adapters {
            line("adapter", &adapter.to_string())?;
            line("", &adapter.abilities())?;
        }
        line("settings", &self.settings_line())?;
        for folder in &self.folders {
            line(&format!("  {}", folder.holds), &folder.to_string())?;
        }
        line("shaders", &self.shaders.to_string())?;
        for test in &self.self_tests {
            line("self-test", &test.to_string())?;
            line("", &test.speed())?;
        }
        for (heading, sentences) in [("Remarks:", &self.remarks), ("Not well:", &self.faults)] {
            if !sentences.is_empty() {
                writeln!(f, "\n{heading}")?;
            }
            for sentence in sentences {
                writeln!(f, "* {sentence}")?;
            }
        }
        if self.is_well() {
            writeln!(f, "\nEverything that is needed works.")
        } else {
            Ok(())
        }
    }
}

impl Diagnosis {
    fn settings_line(&self) -> String {
        let settings = &self.settings;
        let state = match (settings.exists, &settings.wrong) {
            (_, Some(_)) => "has a fault, see below",
            (true, None) => "valid",
            (false, None) => "does not exist yet, the defaults are used",
        };
        settings.path.as_ref().map_or(NO_PLACE.into(), |path| {
            format!("{}: {state}", path.display())
        })
    }
}

impl Display for Adapter {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let used = if self.used { ", in use" } else { "" };
        write!(
            f,
            "{} ({}, {}, {}){used}",
            self.name.name, self.kind, self.name.backend, self.driver
        )
    }
}

impl Adapter {
    fn abilities(&self) -> String {
        let timestamps = if self.timestamps {
            "timestamps"
        } else {
            "no timestamps"
        };
        let buffers = self.largest_storage_buffer >> 20;
        let verdict = if self.missing.is_empty() {
            "has all that is needed"
        } else {
            "lacks what is needed, see below"
        };
        format!(
            "textures to {0} x {0}, storage buffers to {buffers} MiB, {timestamps}; {verdict}",
            self.longest_texture_side
        )
    }
}

impl Display for Folder {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Some(path) = &self.path else {
            return f.write_str(NO_PLACE);
        };
        let state = match (self.exists, &self.wrong) {
            (_, Some(wrong)) => wrong,
            (true, None) => "can be written",
            (false, None) => "does not exist yet, can be created",
        };
        write!(f, "{}: {state}", path.display())
    }
}

impl Display for ShaderCheck {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let verdict = match self.faults.len() {
            0 => "all valid".into(),
            faults => format!("{faults} NOT valid, see below"),
        };
        let (shaders, scenes) = (self.shaders, self.scenes.len());
        write!(f, "{shaders} for the passes of {scenes} scenes, {verdict}")
    }
}

impl Display for SelfTest {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let verdict = if self.holds {
            "as stated"
        } else {
            "NOT as stated, see below"
        };
        write!(
            f,
            "{}, {}: {} rays within {} of a pixel ({} rad, 99 of 100 within {}), {verdict}",
            self.scene,
            self.method,
            self.rays,
            short_number(self.backward_max_px),
            short_number(self.backward_max),
            short_number(self.backward_p99)
        )
    }
}

impl SelfTest {
    fn speed(&self) -> String {
        let by = if self.clock == "timestamps" {
            "the GPU's timestamps"
        } else {
            "the CPU's clock"
        };
        format!(
            "1920x1080 rays in {} ms by {by}",
            four_digits(self.trace_ms_1920x1080)
        )
    }
}
