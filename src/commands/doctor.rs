//! `lightfall doctor`.

use super::{print, progress};
use crate::{Stop, without_device};
use lightfall::cli::DoctorArgs;
use lightfall::gpu::{Gpu, GpuError};
use lightfall::report::doctor::{Diagnosis, TRIALS};

/// Looks, and prints what there is and what to do.
pub fn doctor(args: &DoctorArgs) -> Result<(), Stop> {
    let gpu = Gpu::headless();
    if let Err(error @ (GpuError::UnknownAdapter { .. } | GpuError::UnknownBackend { .. })) = gpu {
        return Err(without_device(error));
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
        faults => Err(Stop(
            1,
            format!("things that are not well: {faults}; the report says what to do"),
        )),
    }
}
