//! Buffers in the GPU's memory, and compute pipelines that bind them.

use super::device::Gpu;
use wgpu::{BindGroup, BindGroupLayout, Buffer, BufferUsages, ComputePipeline, ShaderModule};

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

/// The pipeline of a compute entry, with the layout of its own bindings.
pub(super) fn compute_pipeline(gpu: &Gpu, module: &ShaderModule, entry: &str) -> ComputePipeline {
    gpu.device
        .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: None,
            module,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            cache: None,
        })
}

/// The bind group of whole buffers, by their bindings.
pub(super) fn bind_group<'a>(
    gpu: &Gpu,
    layout: &BindGroupLayout,
    buffers: impl Iterator<Item = (u32, &'a Buffer)>,
) -> BindGroup {
    let entries: Vec<_> = buffers
        .map(|(binding, buffer)| wgpu::BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout,
        entries: &entries,
    })
}
