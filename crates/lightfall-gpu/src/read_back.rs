//! Copies a buffer from the GPU's memory to the CPU's.

use super::error::GpuError;
use std::sync::mpsc::channel;
use wgpu::{Buffer, Device, MapMode, PollType};

/// The contents of a buffer with the usage `MAP_READ`, once the commands submitted so far are done.
/// Blocks until then.
///
/// # Errors
/// The device failed.
pub fn read_back(device: &Device, buffer: &Buffer) -> Result<Vec<u8>, GpuError> {
    let (sender, receiver) = channel();
    buffer.slice(..).map_async(MapMode::Read, move |mapped| {
        // Sending fails only if this function has returned an error already.
        sender.send(mapped).ok();
    });
    device
        .poll(PollType::wait_indefinitely())
        .map_err(GpuError::device_failed)?;
    // The submission is done, but if another thread polls the same device, that thread may still be
    // about to call the closure.
    receiver
        .recv()
        .map_err(GpuError::device_failed)?
        .map_err(GpuError::device_failed)?;
    let bytes = buffer.slice(..).get_mapped_range().to_vec();
    buffer.unmap();
    Ok(bytes)
}
