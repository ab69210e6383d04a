//! `lightfall doctor`: a report on this machine, a self-test, and a check of the shaders.

mod diagnosis;
mod places;
mod self_test;
mod shaders;
mod system;
mod text;

pub use diagnosis::{Adapter, Diagnosis, SELF_TEST_PRESETS};
pub use places::{Folder, SettingsFile};
pub use self_test::{SelfTest, StatedErrors, measure_errors};
pub use shaders::{FaultyShader, ShaderCheck};
pub use system::System;

use super::cli::DoctorArgs;
use super::output::print;
use super::progress::progress;
use super::scene::{scene, stars};
use crate::commands::cli::SceneArgs;
use crate::commands::stop::Stop;
use lightfall_core::gpu::{Drawable, Gpu, GpuError};
use lightfall_core::scene::Scene;

/// Examines the machine and prints the report.
pub(super) fn doctor(args: &DoctorArgs) -> Result<(), Stop> {
    let scene = scene_at_hand(&args.scene)?;
    let gpu = Gpu::headless();
    if let Err(
        error @ (GpuError::UnknownAdapter { .. }
        | GpuError::SeveralAdapters { .. }
        | GpuError::UnknownBackend { .. }),
    ) = gpu
    {
        return Err(Stop::without_device(error));
    }
    let bar = progress(SELF_TEST_PRESETS.len());
    let diagnosis = Diagnosis::new(gpu, scene.as_ref(), |scene| {
        bar.set_message(format!("self-test {scene}"));
        bar.inc(1);
    });
    bar.finish_and_clear();
    print(&if args.json {
        diagnosis.json()
    } else {
        diagnosis.to_string()
    })?;
    match diagnosis.faults.len() {
        0 => Ok(()),
        faults => Err(Stop::failed(format!(
            "problems found: {faults}; the report says what to do about each"
        ))),
    }
}

/// The scene of the command line, if it names one. It must be one that can be drawn.
fn scene_at_hand(args: &SceneArgs) -> Result<Option<Scene>, Stop> {
    if *args == SceneArgs::default() {
        return Ok(None);
    }
    stars(args)?;
    let drawable = Drawable::new(scene(args)?).map_err(Stop::refused)?;
    Ok(Some(drawable.scene().clone()))
}
