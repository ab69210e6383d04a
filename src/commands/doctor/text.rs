//! The diagnosis for people: a name and what is found, line by line.

use super::{Adapter, Diagnosis, Folder, Trial};
use lightfall_core::reports::bench::short;
use std::fmt::{Display, Formatter, Result};
use std::path::Path;

/// Width of the names.
const NAME: usize = 12;

impl Display for Diagnosis {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let mut line = |name: &str, found: &str| writeln!(f, "{name:NAME$}{found}");
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
        for trial in &self.trials {
            line("self-test", &trial.to_string())?;
            line("", &trial.speed())?;
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
            writeln!(f, "\nAll that is needed works.")
        } else {
            Ok(())
        }
    }
}

impl Diagnosis {
    fn settings_line(&self) -> String {
        let settings = &self.settings;
        let state = match (settings.exists, &settings.wrong) {
            (_, Some(_)) => "not sound, see below",
            (true, None) => "sound",
            (false, None) => "none yet, the defaults serve",
        };
        format!("{}: {state}", shown(settings.path.as_deref()))
    }
}

impl Display for Adapter {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let used = if self.used { ", in use" } else { "" };
        write!(
            f,
            "{} ({}, {}, {}){used}",
            self.name, self.kind, self.backend, self.driver
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
        let limits = if self.too_small.is_empty() {
            "limits suffice"
        } else {
            "limits too small, see below"
        };
        format!(
            "textures to {0} x {0}, storage buffers to {buffers} MiB, {timestamps}; {limits}",
            self.longest_texture_side
        )
    }
}

impl Display for Folder {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let state = match (self.exists, &self.wrong) {
            (_, Some(wrong)) => wrong,
            (true, None) => "can be written",
            (false, None) => "not there yet, can be made",
        };
        write!(f, "{}: {state}", shown(self.path.as_deref()))
    }
}

impl Display for Trial {
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
            short(self.backward_max_px),
            short(self.backward_max),
            short(self.backward_p99)
        )
    }
}

impl Trial {
    fn speed(&self) -> String {
        let by = if self.clock == "timestamps" {
            "the GPU's timestamps"
        } else {
            "the clock on the wall"
        };
        format!(
            "1920x1080 rays in {} ms by {by}",
            short(self.trace_ms_1920x1080)
        )
    }
}

fn shown(path: Option<&Path>) -> String {
    path.map_or("no place on this system".into(), |path| {
        path.display().to_string()
    })
}
