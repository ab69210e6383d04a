//! The device that everything shares which is traced beside the window's frames: inspected rays,
//! counts of steps, errors of the picture.

use super::{Gpu, GpuError};
use std::sync::{Arc, Mutex, PoisonError};

static DEVICE: Mutex<Option<Arc<Gpu>>> = Mutex::new(None);

/// Does work on it. Who needs it first opens it; after an error the next one opens another.
///
/// # ErrorSummary
/// There is no device to be had, or the work's own.
pub fn with_background_device<T>(
    work: impl FnOnce(&Gpu) -> Result<T, GpuError>,
) -> Result<T, GpuError> {
    let kept = || DEVICE.lock().unwrap_or_else(PoisonError::into_inner);
    let gpu = {
        let mut device = kept();
        match &*device {
            Some(gpu) => Arc::clone(gpu),
            None => Arc::clone(device.insert(Arc::new(Gpu::headless()?))),
        }
    };
    let done = work(&gpu);
    if done.is_err() {
        // Unless somebody else has opened another one meanwhile.
        kept().take_if(|device| Arc::ptr_eq(device, &gpu));
    }
    done
}
