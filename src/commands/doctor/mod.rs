//! `lightfall doctor`: a report on this machine, and a self-test.

mod diagnosis;
mod places;
mod self_test;
mod system;
mod text;

pub use diagnosis::{Adapter, Diagnosis, SELF_TEST_PRESETS};
pub use places::{Folder, SettingsFile};
pub use self_test::{SelfTest, StatedErrors, measure_errors};
pub use system::System;

use super::cli::DoctorArgs;
use super::output::print;
use super::progress::progress;
use crate::commands::stop::Stop;
use lightfall_core::gpu::{Gpu, GpuError};

/// Examines the machine and prints the report.
pub(super) fn doctor(args: &DoctorArgs) -> Result<(), Stop> {
    let gpu = Gpu::headless();
    if let Err(error @ (GpuError::UnknownAdapter { .. } | GpuError::UnknownBackend { .. })) = gpu {
        return Err(Stop::without_device(error));
    }
    let bar = progress(SELF_TEST_PRESETS.len());
    let diagnosis = Diagnosis::new(gpu, |scene| {
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
