//! What this machine offers, and whether the program will run well on it.

use super::places::{Folder, SettingsFile, folders};
use super::self_test::SelfTest;
use super::shaders::{FaultyShader, ShaderCheck};
use super::system::System;

use lightfall_core::gpu::{
    AdapterName, Gpu, GpuError, Listed, about_hidden_adapters, adapters, driver_advice,
};
use lightfall_core::scene::Scene;
use lightfall_core::scene::presets::{self, PRESETS};
use serde::Serialize;
use wgpu::AdapterInfo;

/// The presets of the self-test: one without spin, and the one with the fastest spin.
pub const SELF_TEST_PRESETS: [&str; 2] = ["above", "extremal"];

/// Maximum time of tracing a picture's rays for fluent motion, in milliseconds: one frame at the
/// frame rate that the window aims for.
const MAX_FRAME_MS: f64 = 33.0;

/// The report on a machine.
#[derive(Clone, Debug, Serialize)]
pub struct Diagnosis {
    /// Version of the program.
    pub version: &'static str,
    /// The computer.
    pub system: System,
    /// Whether this build reads gamepads.
    pub gamepads: bool,
    /// Whether this build plays sound.
    pub sound: bool,
    /// Every graphics adapter.
    pub adapters: Vec<Adapter>,
    /// The settings file.
    pub settings: SettingsFile,
    /// The folders that the program writes to.
    pub folders: Vec<Folder>,
    /// The shaders of the built-in presets and of the scene at hand.
    pub shaders: ShaderCheck,
    /// The self-test on the adapter in use.
    #[serde(rename = "trials")]
    pub self_tests: Vec<SelfTest>,
    /// Things that are needed and do not work, each a sentence that says what to do.
    pub faults: Vec<String>,
    /// Things that work and could be better, each a sentence.
    pub remarks: Vec<String>,
}

/// A graphics adapter.
#[derive(Clone, Debug, Serialize)]
pub struct Adapter {
    /// Its name and its graphics interface.
    #[serde(flatten)]
    pub name: AdapterName,
    /// Software, integrated and so on.
    pub kind: &'static str,
    /// Its driver, with the version.
    pub driver: String,
    /// Its place on the PCI bus. Empty if the interface does not tell it.
    pub pci_bus_id: String,
    /// Whether commands use this adapter.
    pub used: bool,
    /// Whether it can measure the duration of passes.
    pub timestamps: bool,
    /// Maximum side of a texture, in pixels.
    pub longest_texture_side: u32,
    /// Maximum size of a shader's storage buffer, in bytes.
    pub largest_storage_buffer: u64,
    /// What the passes need and it lacks, each as a clause. Empty if it can be used.
    pub missing: Vec<String>,
}

impl Diagnosis {
    /// Examines the machine. `gpu` is the device that commands use, or the reason why there is
    /// none, and `scene` is the scene at hand, if there is one. `next` is called with the preset of
    /// each self-test before the test.
    #[must_use]
    pub fn new(
        gpu: Result<Gpu, GpuError>,
        scene: Option<&Scene>,
        mut next: impl FnMut(&str),
    ) -> Self {
        // As short-lived as the reference to the scene at hand.
        let built_in = PRESETS
            .iter()
            .map(|preset| -> &Scene { preset.plain_scene() });
        let used = gpu.as_ref().ok().map(|gpu| gpu.info.clone());
        let mut diagnosis = Self {
            version: env!("CARGO_PKG_VERSION"),
            system: System::here(),
            gamepads: cfg!(feature = "gamepad"),
            sound: cfg!(feature = "sound"),
            adapters: adapters()
                .into_iter()
                .map(|listed| Adapter::new(listed, used.as_ref()))
                .collect(),
            settings: SettingsFile::here(),
            folders: folders(),
            shaders: ShaderCheck::of(built_in.chain(scene)),
            self_tests: Vec::new(),
            faults: Vec::new(),
            remarks: Vec::new(),
        };
        match gpu {
            Ok(gpu) => diagnosis.run_self_tests(&gpu, &mut next),
            Err(error) => diagnosis.faults.push(error.to_string()),
        }
        diagnosis.add_faults_and_remarks();
        diagnosis
    }

    /// Whether everything that is needed works.
    #[must_use]
    pub fn is_well(&self) -> bool {
        self.faults.is_empty()
    }

    /// The report as JSON, for programs.
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

    fn run_self_tests(&mut self, gpu: &Gpu, next: &mut impl FnMut(&str)) {
        for name in SELF_TEST_PRESETS {
            next(name);
            let Some(Ok(scene)) = presets::find(name).map(|preset| preset.scene(&[])) else {
                continue;
            };
            match SelfTest::run(gpu, name, &scene) {
                Ok(test) => {
                    if let Some(fault) = test.fault() {
                        self.faults.push(format!(
                            "{fault}; try another driver, or another adapter with --gpu"
                        ));
                    }
                    self.self_tests.push(test);
                }
                Err(error) => {
                    self.faults
                        .push(format!("self-test {name}: {error}; try another driver, or another adapter with --gpu"));
                }
            }
        }
    }

    /// Adds the faults and remarks about everything but the self-test.
    fn add_faults_and_remarks(&mut self) {
        self.faults
            .extend(self.shaders.faults.iter().map(FaultyShader::sentence));
        self.faults.extend(self.settings.fault());
        self.faults
            .extend(self.folders.iter().filter_map(Folder::fault));
        self.remarks.extend(about_hidden_adapters());
        let unusable = self
            .adapters
            .iter()
            .filter(|adapter| !adapter.missing.is_empty());
        self.remarks.extend(unusable.map(|adapter| {
            format!(
                "{} cannot be used: {}; {}",
                adapter.name,
                adapter.missing.join(", "),
                driver_advice::with_old_driver(std::env::consts::OS)
            )
        }));
        if let Some(missing) = &self.system.no_display {
            self.remarks.push(format!(
                "there is no display ({missing}), so `lightfall` draws a PNG instead of flying"
            ));
        }
        if self
            .adapters
            .iter()
            .any(|adapter| adapter.used && adapter.kind == "software")
        {
            self.remarks
                .push("pictures are drawn in software; a graphics card with a Vulkan driver is far faster".into());
        }
        let wanted = self.settings.adapter.as_ref();
        let is_present = |wanted: &AdapterName| self.adapters.iter().any(|it| it.name == *wanted);
        if let Some(missing) = wanted.filter(|wanted| !is_present(wanted)) {
            self.remarks.push(format!(
                "the settings choose {missing} for the window, which does not exist here; the best adapter is used instead"
            ));
        }
        if let Some(frame) = self
            .self_tests
            .first()
            .map(SelfTest::frame_ms)
            .filter(|time| *time > MAX_FRAME_MS)
        {
            self.remarks.push(format!(
                "tracing a picture of 960x540 takes {frame:.0} ms, so the window draws fewer pixels while something moves"
            ));
        }
        if !self.gamepads {
            self.remarks
                .extend(crate::app::NO_GAMEPAD.map(str::to_owned));
        }
        if !self.sound {
            self.remarks.extend(crate::app::NO_SOUND.map(str::to_owned));
        }
    }
}

impl Adapter {
    fn new(listed: Listed, used: Option<&AdapterInfo>) -> Self {
        Self {
            used: used.is_some_and(|info| listed.is(info)),
            name: listed.name,
            kind: listed.kind,
            driver: listed.driver,
            pci_bus_id: listed.pci_bus_id,
            timestamps: listed.timestamps,
            longest_texture_side: listed.limits.max_texture_dimension_2d,
            largest_storage_buffer: listed.limits.max_storage_buffer_binding_size,
            missing: listed.missing,
        }
    }
}
