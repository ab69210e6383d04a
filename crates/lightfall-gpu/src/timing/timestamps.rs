//! Two timestamps of the GPU, around one run.

use crate::buffer::empty_buffer;
use crate::device::Gpu;
use crate::error::GpuError;
use crate::read_back::read_back;
use wgpu::{Buffer, BufferUsages, CommandEncoder, QuerySet};

/// Size of two timestamps, in bytes.
const BYTES: u64 = 16;

/// A pair of timestamps: the queries, the buffer that they are resolved to, and its copy that the
/// CPU can read.
pub(super) struct Timestamps {
    queries: QuerySet,
    resolved: Buffer,
    readable: Buffer,
}

impl Timestamps {
    /// `None` on a device without timestamps. Those of a software device are not used: Mesa takes
    /// them when a compute shader is queued, not when it has run.
    pub(super) fn new(gpu: &Gpu) -> Option<Self> {
        let software = gpu.info.device_type == wgpu::DeviceType::Cpu;
        let features = gpu.device.features();
        if software || !features.contains(wgpu::Features::TIMESTAMP_QUERY) {
            return None;
        }
        let buffer = |label, usage| empty_buffer(gpu, label, BYTES, usage);
        Some(Self {
            queries: gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: None,
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
            resolved: buffer(
                "timestamps",
                BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
            ),
            readable: buffer(
                "readable timestamps",
                BufferUsages::COPY_DST | BufferUsages::MAP_READ,
            ),
        })
    }

    pub(super) fn compute_writes(&self) -> wgpu::ComputePassTimestampWrites<'_> {
        wgpu::ComputePassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    pub(super) fn render_writes(&self) -> wgpu::RenderPassTimestampWrites<'_> {
        wgpu::RenderPassTimestampWrites {
            query_set: &self.queries,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    /// Copies the timestamps to where the CPU can read them.
    pub(super) fn resolve(&self, encoder: &mut CommandEncoder) {
        encoder.resolve_query_set(&self.queries, 0..2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.readable, 0, BYTES);
    }

    /// The time between the two timestamps, in milliseconds, once the submitted work is done.
    pub(super) fn elapsed_ms(&self, gpu: &Gpu) -> Result<f64, GpuError> {
        let bytes = read_back(&gpu.device, &self.readable)?;
        let [before, after] =
            [0, 8].map(|at| u64::from_le_bytes(std::array::from_fn(|i| bytes[at + i])));
        let ticks = after.saturating_sub(before) as f64;
        Ok(ticks * f64::from(gpu.queue.get_timestamp_period()) * 1e-6)
    }
}
