//! Buffers in the GPU's memory.

use super::device::Gpu;
use wgpu::{Buffer, BufferUsages};

/// A buffer of `size` bytes that is not initialized.
pub(super) fn empty_buffer(gpu: &Gpu, label: &str, size: u64, usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage,
        mapped_at_creation: false,
    })
}

/// A buffer with these contents.
///
/// The contents are copied by the queue, because wgpu's `create_buffer_init` maps the buffer, which
/// panics where the device is lost or out of memory.
pub(super) fn buffer_from_bytes(
    gpu: &Gpu,
    label: &str,
    contents: &[u8],
    usage: BufferUsages,
) -> Buffer {
    let buffer = empty_buffer(
        gpu,
        label,
        contents.len() as u64,
        usage | BufferUsages::COPY_DST,
    );
    gpu.queue.write_buffer(&buffer, 0, contents);
    buffer
}
