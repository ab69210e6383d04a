//! Compute shaders that map one array to another: rays to traces, or arguments of a shader function
//! to results.

use super::bindings;
use super::buffer::{bind_group, buffer_from_bytes, compute_pipeline, empty_buffer};
use super::device::Gpu;
use super::error::GpuError;
use super::read_back::read_back;
use encase::internal::{CreateFrom, ReadFrom, WriteInto};
use encase::{ShaderSize, ShaderType, StorageBuffer, UniformBuffer};
use wgpu::{Buffer, BufferUsages};

/// The bytes of a uniform.
pub fn uniform<U: ShaderType + WriteInto>(value: &U) -> Vec<u8> {
    let mut bytes = UniformBuffer::new(Vec::new());
    bytes.write(value).expect("a vector grows as it is written");
    bytes.into_inner()
}

/// The bytes of a table in a uniform.
pub fn table_bytes(table: &[[f32; 4]]) -> Vec<u8> {
    table
        .iter()
        .flatten()
        .flat_map(|value| value.to_le_bytes())
        .collect()
}

/// A compute shader that maps a storage array (binding [`INPUT`](bindings::INPUT)) to another one
/// (binding [`OUTPUT`](bindings::OUTPUT)), one element per invocation, in workgroups of
/// [`WORKGROUP_SIZE`](bindings::WORKGROUP_SIZE). The other bindings are uniforms.
#[derive(Debug)]
pub struct ArrayKernel {
    pipeline: wgpu::ComputePipeline,
    uniforms: Vec<(u32, Buffer)>,
}

impl ArrayKernel {
    /// Compiles the entry point `entry` of a WGSL text. `uniforms` lists the bindings of its
    /// uniforms with their bytes.
    ///
    /// # Errors
    /// The text does not compile, or the device refuses the pipeline.
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
                    buffer_from_bytes(
                        gpu,
                        "uniform",
                        bytes,
                        BufferUsages::UNIFORM | BufferUsages::STORAGE,
                    ),
                )
            });
            Self {
                pipeline: compute_pipeline(gpu, &module, entry),
                uniforms: uniforms.collect(),
            }
        })
    }

    /// Replaces the bytes of a uniform.
    pub fn write_uniform(&self, gpu: &Gpu, binding: u32, bytes: &[u8]) {
        for (_, buffer) in self.uniforms.iter().filter(|(at, _)| *at == binding) {
            gpu.queue.write_buffer(buffer, 0, bytes);
        }
    }

    /// Runs the shader over `input`. The result has one element for each of `input`.
    ///
    /// # Errors
    /// The device refuses the commands, or it failed.
    pub fn run<I, O>(&self, gpu: &Gpu, input: &[I]) -> Result<Vec<O>, GpuError>
    where
        I: ShaderSize + WriteInto + Clone,
        O: ShaderSize + Default + Clone + ReadFrom + CreateFrom,
    {
        if input.is_empty() {
            return Ok(Vec::new());
        }
        let mut bytes = StorageBuffer::new(Vec::new());
        bytes
            .write(&input.to_vec())
            .expect("a vector grows as it is written");
        let size = O::SHADER_SIZE.get() * input.len() as u64;
        let readable =
            gpu.validated(|| self.dispatch(gpu, &bytes.into_inner(), input.len(), size))?;
        let bytes = read_back(&gpu.device, &readable)?;
        let mut records = vec![O::default(); input.len()];
        StorageBuffer::new(bytes)
            .read(&mut records)
            .map_err(GpuError::device_failed)?;
        Ok(records)
    }

    /// Submits one run over `count` elements. The returned buffer will hold the result, `size`
    /// bytes.
    fn dispatch(&self, gpu: &Gpu, input: &[u8], count: usize, size: u64) -> Buffer {
        let input = buffer_from_bytes(gpu, "input", input, BufferUsages::STORAGE);
        let output = empty_buffer(
            gpu,
            "output",
            size,
            BufferUsages::STORAGE | BufferUsages::COPY_SRC,
        );
        let readable = empty_buffer(
            gpu,
            "readable output",
            size,
            BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        );
        let arrays = [(bindings::INPUT, &input), (bindings::OUTPUT, &output)];
        let uniforms = self
            .uniforms
            .iter()
            .map(|(binding, buffer)| (*binding, buffer));
        let layout = self.pipeline.get_bind_group_layout(0);
        let bind_group = bind_group(gpu, &layout, uniforms.chain(arrays));
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bind_group, &[]);
            pass.dispatch_workgroups(
                count.div_ceil(bindings::WORKGROUP_SIZE as usize) as u32,
                1,
                1,
            );
        }
        encoder.copy_buffer_to_buffer(&output, 0, &readable, 0, size);
        gpu.queue.submit([encoder.finish()]);
        readable
    }
}
