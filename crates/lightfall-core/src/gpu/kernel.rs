//! Compute shaders that map one array to another: rays to traces, and whatever a test asks of a
//! shader's functions.

use super::{Gpu, GpuError};
use encase::internal::{CreateFrom, ReadFrom, WriteInto};
use encase::{ShaderSize, ShaderType, StorageBuffer, UniformBuffer};
use std::fmt::Display;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages};

/// Invocations of a workgroup, as the shaders declare it.
const WORKGROUP: usize = 64;

/// The bytes of a uniform.
pub fn uniform<U: ShaderType + WriteInto>(value: &U) -> Vec<u8> {
    let mut bytes = UniformBuffer::new(Vec::new());
    bytes.write(value).expect("a vector grows as it is written");
    bytes.into_inner()
}

/// A compute shader that maps a storage array (binding 2) to another (binding 3), one element an
/// invocation, in workgroups of 64; the other bindings are uniforms.
#[derive(Debug)]
pub struct Kernel {
    pipeline: wgpu::ComputePipeline,
    uniforms: Vec<(u32, Buffer)>,
}

impl Kernel {
    /// Compiles `entry` of a WGSL text, with the bytes of the uniforms that it uses, by binding.
    ///
    /// # ErrorSummary
    /// A text that does not compile.
    pub fn new(
        gpu: &Gpu,
        source: &str,
        entry: &str,
        uniforms: &[(u32, Vec<u8>)],
    ) -> Result<Self, GpuError> {
        let module = gpu.shader(entry, source)?;
        gpu.validated(|| {
            let uniforms = uniforms.iter().map(|(binding, bytes)| {
                (
                    *binding,
                    buffer(
                        gpu,
                        "uniform",
                        bytes,
                        BufferUsages::UNIFORM | BufferUsages::COPY_DST,
                    ),
                )
            });
            let pipeline = gpu
                .device
                .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                    label: Some(entry),
                    layout: None,
                    module: &module,
                    entry_point: Some(entry),
                    compilation_options: Default::default(),
                    cache: None,
                });
            Self {
                pipeline,
                uniforms: uniforms.collect(),
            }
        })
        .map_err(GpuError::Shader)
    }

    /// Gives a uniform other bytes, as many as it has.
    pub fn write_uniform(&self, gpu: &Gpu, binding: u32, bytes: &[u8]) {
        for (_, buffer) in self.uniforms.iter().filter(|(at, _)| *at == binding) {
            gpu.queue.write_buffer(buffer, 0, bytes);
        }
    }

    /// Runs it over `input`; nothing in, nothing out.
    ///
    /// # ErrorSummary
    /// A device that failed.
    pub fn run<I, O>(&self, gpu: &Gpu, input: &[I]) -> Result<Vec<O>, GpuError>
    where
        I: ShaderSize + WriteInto + Clone,
        O: ShaderSize + Default + Clone + ReadFrom + CreateFrom,
    {
        if input.is_empty() {
            return Ok(Vec::new());
        }
        let failed = |error: &dyn Display| GpuError::Device(error.to_string());
        let mut bytes = StorageBuffer::new(Vec::new());
        bytes
            .write(&input.to_vec())
            .map_err(|error| failed(&error))?;
        let size = O::SHADER_SIZE.get() * input.len() as u64;
        let readable = gpu
            .validated(|| self.dispatch(gpu, &bytes.into_inner(), input.len(), size))
            .map_err(GpuError::Device)?;
        let (sender, receiver) = std::sync::mpsc::channel();
        readable
            .slice(..)
            .map_async(wgpu::MapMode::Read, move |result| {
                // Nobody listens once the device has failed; the error is reported there.
                let _ = sender.send(result);
            });
        gpu.device
            .poll(wgpu::PollType::wait_indefinitely())
            .map_err(|error| failed(&error))?;
        // The submission is done; another thread that polls the same device may still be about to
        // say so.
        receiver
            .recv()
            .map_err(|error| failed(&error))?
            .map_err(|error| failed(&error))?;
        let mut records = vec![O::default(); input.len()];
        let bytes = readable.slice(..).get_mapped_range();
        StorageBuffer::new(&bytes[..])
            .read(&mut records)
            .map_err(|error| failed(&error))?;
        Ok(records)
    }

    /// Submits one run over `count` elements; the answer, of `size` bytes, will be in the buffer.
    fn dispatch(&self, gpu: &Gpu, input: &[u8], count: usize, size: u64) -> Buffer {
        let input = buffer(gpu, "input", input, BufferUsages::STORAGE);
        let make = |label, usage| {
            let descriptor = wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage,
                mapped_at_creation: false,
            };
            gpu.device.create_buffer(&descriptor)
        };
        let output = make("output", BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let readable = make(
            "readable output",
            BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        );
        let arrays = [(2, &input), (3, &output)];
        let bindings = self
            .uniforms
            .iter()
            .map(|(binding, buffer)| (*binding, buffer))
            .chain(arrays);
        let entries: Vec<_> = bindings
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        let bind_group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &entries,
        });
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bind_group, &[]);
            pass.dispatch_workgroups(count.div_ceil(WORKGROUP) as u32, 1, 1);
        }
        encoder.copy_buffer_to_buffer(&output, 0, &readable, 0, size);
        gpu.queue.submit([encoder.finish()]);
        readable
    }
}

fn buffer(gpu: &Gpu, label: &str, contents: &[u8], usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer_init(&BufferInitDescriptor {
        label: Some(label),
        contents,
        usage,
    })
}
