//! The time in which the GPU traces a picture's rays: the variant that draws the picture, with one
//! vector per pixel as its output in place of light.

mod timestamps;
mod work;

use super::bindings;
use super::buffer::{bind_group, buffer_from_bytes, empty_buffer};
use super::device::Gpu;
use super::error::GpuError;
use super::inputs::Inputs;
use super::kernel::uniform;
use super::scene::GpuScene;
use super::shader::Variant;
use glam::UVec2;
use lightfall_model::scene::{Frame, Scene};
use std::time::{Duration, Instant};
use timestamps::Timestamps;
use wgpu::{BindGroup, Buffer, BufferUsages, CommandEncoder, PollType};
use work::{Work, compute, fragment};

/// Maximum number of workgroups along one axis of a dispatch. Every device allows more.
const MAX_COLUMNS: u32 = 1 << 15;

const VECTOR_BYTES: u64 = 16;

/// Duration of the warm-up, as a multiple of [`Effort::max_time`]: a GPU raises its clock only
/// after a while under load.
const WARM_UP: u32 = 2;

/// Minimum duration of a sample. A sample has as many runs as fit into it, so that the cost of
/// submitting them matters little.
const MIN_SAMPLE: Duration = Duration::from_millis(10);

const MAX_RUNS_PER_SAMPLE: f64 = 50.0;

/// Maximum number of samples. More do not improve a median.
const MAX_SAMPLES: usize = 200;

/// The time limit of all samples of a slow method, as a multiple of [`Effort::max_time`].
const MAX_OVERTIME: u32 = 8;

lightfall_model::words! {
    /// The pipeline stage that traces the rays.
    pub enum Stage {
        /// The compute entry: compares methods fairly on every device.
        Compute = "compute",
        /// The fragment entry, as in pictures.
        Fragment = "fragment",
    }
}

lightfall_model::words! {
    /// The clock that the times were read from.
    pub enum Clock {
        /// The GPU's timestamps, around one run.
        Timestamps = "timestamps",
        /// The CPU's clock, around many runs.
        Wall = "wall",
    }
}

/// The duration of one run, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// The median of the samples.
    pub median_ms: f64,
    /// The difference between the 90th and the 10th percentile.
    pub spread_ms: f64,
    /// The clock.
    pub clock: Clock,
}

/// How many samples are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Minimum number of samples.
    pub min_samples: usize,
    /// Once the minimum is reached, no sample starts later than this.
    pub max_time: Duration,
}

/// Traces the rays of a scene's picture again and again, and times it.
pub struct Stopwatch {
    work: Work,
    size: UVec2,
    numbers: Buffer,
    bind_group: BindGroup,
    timestamps: Option<Timestamps>,
}

impl Stopwatch {
    /// Compiles the variant of the scene for a picture of `size` pixels.
    ///
    /// # Errors
    /// The GPU cannot trace the scene, the picture is too large for the device, or a shader does
    /// not compile.
    pub fn new(gpu: &Gpu, scene: &Scene, size: UVec2, stage: Stage) -> Result<Self, GpuError> {
        Self::of_variant(gpu, Variant::timed(scene), scene, size, stage)
    }

    /// The same with a timed variant that differs from the scene's own.
    ///
    /// # Errors
    /// As [`Stopwatch::new`].
    pub fn of_variant(
        gpu: &Gpu,
        variant: Variant,
        scene: &Scene,
        size: UVec2,
        stage: Stage,
    ) -> Result<Self, GpuError> {
        let numbers = GpuScene::new(scene, &Frame::of(scene).with_whole(size))?;
        if stage == Stage::Compute {
            check_output_size(gpu, size)?;
        }
        let source = variant.source();
        let tables = Inputs::new(scene).declared_in(&source);
        let module = gpu.shader("timed", &source)?;
        gpu.validated(|| {
            let uniform_of = |label, bytes: &[u8]| {
                buffer_from_bytes(
                    gpu,
                    label,
                    bytes,
                    BufferUsages::UNIFORM | BufferUsages::STORAGE,
                )
            };
            let numbers = uniform_of("scene", &uniform(&numbers));
            let tables = tables.iter();
            let mut buffers: Vec<(u32, Buffer)> = tables
                .map(|(binding, bytes)| (*binding, uniform_of("table", bytes)))
                .collect();
            let (work, layout) = match stage {
                Stage::Compute => {
                    let size = output_bytes(size);
                    let output = empty_buffer(gpu, "traces", size, BufferUsages::STORAGE);
                    buffers.push((bindings::OUTPUT, output));
                    compute(gpu, &module)
                }
                Stage::Fragment => fragment(gpu, &module, size),
            };
            let buffers = buffers.iter().map(|(binding, buffer)| (*binding, buffer));
            let bound = buffers.chain([(bindings::SCENE, &numbers)]);
            let bind_group = bind_group(gpu, &layout, bound);
            Self {
                work,
                size,
                numbers,
                bind_group,
                timestamps: Timestamps::new(gpu),
            }
        })
    }

    /// Changes to the numbers of another scene of the same variant, such as one with another step
    /// scale.
    ///
    /// # Errors
    /// The GPU cannot trace the scene.
    pub fn set_scene(&self, gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
        let numbers = GpuScene::new(scene, &Frame::of(scene).with_whole(self.size))?;
        gpu.queue.write_buffer(&self.numbers, 0, &uniform(&numbers));
        Ok(())
    }

    /// Warms the GPU up and takes samples.
    ///
    /// # Errors
    /// The device refuses the commands, or it failed.
    pub fn time(&self, gpu: &Gpu, effort: Effort) -> Result<Timing, GpuError> {
        let runs = gpu.validated(|| self.warm_up(gpu, WARM_UP * effort.max_time))??;
        let began = Instant::now();
        let mut samples = Vec::new();
        while samples.len() < effort.min_samples
            || began.elapsed() < effort.max_time && samples.len() < MAX_SAMPLES
        {
            samples.push(self.sample(gpu, runs)?);
            // One run of a slow method on a slow device may take longer than all planned samples.
            if began.elapsed() > MAX_OVERTIME * effort.max_time {
                break;
            }
        }
        samples.sort_by(f64::total_cmp);
        let at = |share: f64| samples[((samples.len() - 1) as f64 * share).round() as usize];
        let clock = if self.timestamps.is_some() {
            Clock::Timestamps
        } else {
            Clock::Wall
        };
        Ok(Timing {
            median_ms: at(0.5),
            spread_ms: at(0.9) - at(0.1),
            clock,
        })
    }

    /// Runs for at least `min_time` and returns the number of runs of a sample.
    fn warm_up(&self, gpu: &Gpu, min_time: Duration) -> Result<u32, GpuError> {
        let began = Instant::now();
        let mut runs = 1;
        loop {
            let this = Instant::now();
            self.submit(gpu, runs);
            wait(gpu)?;
            let one = this.elapsed().as_secs_f64() / f64::from(runs);
            runs = (MIN_SAMPLE.as_secs_f64() / one).clamp(1.0, MAX_RUNS_PER_SAMPLE) as u32;
            if began.elapsed() > min_time {
                return Ok(runs);
            }
        }
    }

    /// One sample: milliseconds per run, from the GPU's clock around the last of `runs` runs, else
    /// from the CPU's clock around all of them. A GPU that gets one short run at a time lowers its
    /// clock.
    fn sample(&self, gpu: &Gpu, runs: u32) -> Result<f64, GpuError> {
        let began = Instant::now();
        self.submit(gpu, runs);
        match &self.timestamps {
            Some(timestamps) => timestamps.elapsed_ms(gpu),
            None => {
                wait(gpu)?;
                Ok(began.elapsed().as_secs_f64() * 1e3 / f64::from(runs))
            }
        }
    }

    fn submit(&self, gpu: &Gpu, runs: u32) {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        for run in 1..=runs {
            self.encode(&mut encoder, run == runs);
        }
        if let Some(timestamps) = &self.timestamps {
            timestamps.resolve(&mut encoder);
        }
        gpu.queue.submit([encoder.finish()]);
    }

    fn encode(&self, encoder: &mut CommandEncoder, timed: bool) {
        let timestamps = self.timestamps.as_ref().filter(|_| timed);
        match &self.work {
            Work::Compute(pipeline) => {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: None,
                    timestamp_writes: timestamps.map(Timestamps::compute_writes),
                });
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, &self.bind_group, &[]);
                let groups = (self.size.x * self.size.y).div_ceil(bindings::WORKGROUP_SIZE);
                let columns = groups.min(MAX_COLUMNS);
                pass.dispatch_workgroups(columns, groups.div_ceil(columns), 1);
            }
            Work::Fragment(pipeline, target) => {
                let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                    color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                        view: target,
                        depth_slice: None,
                        resolve_target: None,
                        ops: Default::default(),
                    })],
                    timestamp_writes: timestamps.map(Timestamps::render_writes),
                    ..Default::default()
                });
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, &self.bind_group, &[]);
                pass.draw(0..3, 0..1);
            }
        }
    }
}

/// Waits until all submitted work is done.
fn wait(gpu: &Gpu) -> Result<(), GpuError> {
    gpu.device
        .poll(PollType::wait_indefinitely())
        .map(drop)
        .map_err(GpuError::device_failed)
}

/// Size of the output of the compute entry, in bytes.
fn output_bytes(size: UVec2) -> u64 {
    u64::from(size.x) * u64::from(size.y) * VECTOR_BYTES
}

/// Checks that the device allows a buffer for the output of the compute entry.
fn check_output_size(gpu: &Gpu, size: UVec2) -> Result<(), GpuError> {
    let limits = gpu.device.limits();
    let limit = u64::min(
        limits.max_buffer_size,
        limits.max_storage_buffer_binding_size,
    );
    let bytes = output_bytes(size);
    if bytes > limit {
        return Err(GpuError::TooLarge {
            what: "the rays of the picture",
            bytes,
            limit,
        });
    }
    Ok(())
}
