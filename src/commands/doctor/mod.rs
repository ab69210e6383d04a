//! `lightfall doctor`.

mod diagnosis;
mod places;
mod system;
mod text;
mod trial;

pub use diagnosis::{Adapter, Diagnosis, TRIALS};
pub use places::{Folder, SettingsFile};
pub use system::System;
pub use trial::{Stated, Trial, errors};

use super::cli::DoctorArgs;
use super::output::print;
use super::progress::progress;
use crate::commands::stop::Stop;
use lightfall_core::gpu::{Gpu, GpuError};

/// Looks, and prints what there is and what to do.
pub(super) fn doctor(args: &DoctorArgs) -> Result<(), Stop> {
    let gpu = Gpu::headless();
    if let Err(error @ (GpuError::UnknownAdapter { .. } | GpuError::UnknownBackend { .. })) = gpu {
        return Err(Stop::without_device(error));
    }
    let bar = progress(TRIALS.len());
    let diagnosis = Diagnosis::of(gpu, |scene| {
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
            "things that are not well: {faults}; the report says what to do"
        ))),
    }
}
