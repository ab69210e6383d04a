//! The one device of all work that is done on the GPU outside the window's frames: inspected rays,
//! step counts, and the error map.

use super::device::Gpu;
use super::error::GpuError;
use std::sync::{Arc, Mutex, PoisonError};

static DEVICE: Mutex<Option<Arc<Gpu>>> = Mutex::new(None);

/// Runs `work` on the background device. The first call opens the device; a call after the device
/// failed opens a new one. Any other error, such as a scene that cannot be traced, leaves the
/// device open.
///
/// # Errors
/// No device can be opened, or the error of `work`.
pub fn with_background_device<T>(
    work: impl FnOnce(&Gpu) -> Result<T, GpuError>,
) -> Result<T, GpuError> {
    let shared = || DEVICE.lock().unwrap_or_else(PoisonError::into_inner);
    let gpu = {
        let mut device = shared();
        match &*device {
            Some(gpu) => Arc::clone(gpu),
            None => Arc::clone(device.insert(Arc::new(Gpu::headless()?))),
        }
    };
    let done = work(&gpu);
    if done.as_ref().is_err_and(GpuError::is_device_failure) {
        // Another thread may have opened a new device in the meantime: that one stays.
        shared().take_if(|device| Arc::ptr_eq(device, &gpu));
    }
    done
}
