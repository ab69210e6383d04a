//! What this machine is, and whether the program will run well on it.

use super::{Folder, SettingsFile, System, Trial, places};

use lightfall_core::gpu::{AdapterName, Gpu, GpuError, Listed, adapters};
use lightfall_core::scene::presets;
use serde::Serialize;

/// The presets that are traced in the self-test: one without spin, and the one with the fastest.
pub const TRIALS: [&str; 2] = ["edge-on", "extremal"];

/// Time in which the rays of the picture should be traced, in milliseconds: a frame of the rate
/// that the window holds.
const FLUENT_MS: f64 = 33.0;

/// All that is found out about a machine.
#[derive(Clone, Debug, Serialize)]
pub struct Diagnosis {
    /// Of the program.
    pub version: &'static str,
    /// The computer.
    pub system: System,
    /// Whether this build reads gamepads.
    pub gamepads: bool,
    /// Every graphics adapter.
    pub adapters: Vec<Adapter>,
    /// The file of settings.
    pub settings: SettingsFile,
    /// The folders that are written to.
    pub folders: Vec<Folder>,
    /// Rays that were traced on the adapter in use, held against the f64 reference.
    pub trials: Vec<Trial>,
    /// What is needed and does not work, each a sentence with what to do.
    pub faults: Vec<String>,
    /// What works and could be better, likewise.
    pub remarks: Vec<String>,
}

/// A graphics adapter.
#[derive(Clone, Debug, Serialize)]
pub struct Adapter {
    /// As its driver calls it.
    pub name: String,
    /// The interface that it is reached through.
    pub backend: String,
    /// Software, integrated and so on.
    pub kind: &'static str,
    /// Its driver, with the version.
    pub driver: String,
    /// Whether it is the one that commands use.
    pub used: bool,
    /// Whether it can tell how long passes take.
    pub timestamps: bool,
    /// Longest side of a texture, in pixels.
    pub longest_texture_side: u32,
    /// Largest storage buffer that a shader can see, in bytes.
    pub largest_storage_buffer: u64,
    /// Its limits that are less than what the passes may count on, each with what there is and what
    /// there should be.
    pub too_small: Vec<String>,
}

impl Diagnosis {
    /// Looks at everything. `gpu` is the device that commands use, or why there is none; `next` is
    /// told of each self-test before it begins.
    #[must_use]
    pub fn of(gpu: Result<Gpu, GpuError>, mut next: impl FnMut(&str)) -> Self {
        let used = gpu.as_ref().ok().map(|gpu| AdapterName::of(&gpu.info));
        let mut diagnosis = Self {
            version: env!("CARGO_PKG_VERSION"),
            system: System::here(),
            gamepads: cfg!(feature = "gamepad"),
            adapters: adapters()
                .into_iter()
                .map(|listed| Adapter::new(listed, used.as_ref()))
                .collect(),
            settings: SettingsFile::here(),
            folders: places::folders(),
            trials: Vec::new(),
            faults: Vec::new(),
            remarks: Vec::new(),
        };
        match gpu {
            Ok(gpu) => diagnosis.trace(&gpu, &mut next),
            Err(error) => diagnosis.faults.push(error.to_string()),
        }
        diagnosis.judge();
        diagnosis
    }

    /// Whether all that is needed works.
    #[must_use]
    pub fn is_well(&self) -> bool {
        self.faults.is_empty()
    }

    /// For programs.
    #[must_use]
    pub fn json(&self) -> String {
        let mut all = serde_json::json!({ "well": self.is_well() });
        if let (Some(all), Ok(serde_json::Value::Object(rest))) =
            (all.as_object_mut(), serde_json::to_value(self))
        {
            all.extend(rest);
        }
        format!("{all:#}\n")
    }

    /// The self-test.
    fn trace(&mut self, gpu: &Gpu, next: &mut impl FnMut(&str)) {
        for name in TRIALS {
            next(name);
            let Some(Ok(scene)) = presets::find(name).map(|preset| preset.scene(&[])) else {
                continue;
            };
            match Trial::of(gpu, name, &scene) {
                Ok(trial) => {
                    if let Some(fault) = trial.fault() {
                        self.faults.push(format!(
                            "{fault}; try another driver, or another adapter with --gpu"
                        ));
                    }
                    self.trials.push(trial);
                }
                Err(error) => {
                    self.faults
                        .push(format!("self-test {name}: {error}; try another driver, or another adapter with --gpu"));
                }
            }
        }
    }

    /// Faults and remarks of all but the self-test.
    fn judge(&mut self) {
        self.faults.extend(self.settings.fault());
        self.faults
            .extend(self.folders.iter().filter_map(Folder::fault));
        let too_small = self
            .adapters
            .iter()
            .filter(|adapter| adapter.used && !adapter.too_small.is_empty());
        self.remarks.extend(too_small.map(|adapter| {
            format!(
                "{} offers less than the passes may count on: {}",
                adapter.name,
                adapter.too_small.join(", ")
            )
        }));
        if let Some(missing) = &self.system.no_display {
            self.remarks.push(format!(
                "there is no display ({missing}): `lightfall` draws a PNG instead of flying"
            ));
        }
        if self
            .adapters
            .iter()
            .any(|adapter| adapter.used && adapter.kind == "software")
        {
            self.remarks
                .push("pictures are drawn in software: a graphics card with its Vulkan driver is far faster".into());
        }
        let wanted = self.settings.adapter.as_ref();
        let there = |wanted: &AdapterName| {
            self.adapters
                .iter()
                .any(|it| (&it.name, &it.backend) == (&wanted.name, &wanted.backend))
        };
        if let Some(gone) = wanted.filter(|wanted| !there(wanted)) {
            self.remarks.push(format!(
                "the settings name {gone} for the window, which is not there: the best one is used"
            ));
        }
        if let Some(frame) = self
            .trials
            .first()
            .map(Trial::frame_ms)
            .filter(|time| *time > FLUENT_MS)
        {
            self.remarks.push(format!(
                "tracing a picture of 960x540 takes {frame:.0} ms: the window draws fewer pixels while something moves"
            ));
        }
        if !self.gamepads {
            self.remarks
                .extend(crate::app::NO_GAMEPAD.map(str::to_owned));
        }
    }
}

impl Adapter {
    fn new(listed: Listed, used: Option<&AdapterName>) -> Self {
        let used = used == Some(&listed.name);
        let Listed {
            name: AdapterName { name, backend },
            kind,
            driver,
            timestamps,
            limits,
        } = listed;
        let mut too_small = Vec::new();
        // What WebGPU promises everywhere, and the passes therefore take for granted.
        wgpu::Limits::default().check_limits_with_fail_fn(
            &limits,
            false,
            |limit, needed, there| {
                too_small.push(format!("{limit} is {there}, not {needed}"));
            },
        );
        Self {
            name,
            backend,
            kind,
            driver,
            used,
            timestamps,
            longest_texture_side: limits.max_texture_dimension_2d,
            largest_storage_buffer: limits.max_storage_buffer_binding_size,
            too_small,
        }
    }
}
