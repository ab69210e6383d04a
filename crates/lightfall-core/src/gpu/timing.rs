//! How long the GPU takes to trace a picture's rays, and nothing else: the variant that draws the
//! picture, with one vector a pixel in place of its light.

mod work;

use super::kernel::uniform;
use super::{Gpu, GpuError, GpuScene, Variant};
use crate::scene::Scene;
use glam::UVec2;
use std::time::{Duration, Instant};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BindGroup, Buffer, BufferUsages, CommandEncoder, QuerySet};
use work::{Work, compute, fragment};

/// Invocations of a workgroup, as shaders/timed.wgsl declares it.
const WORKGROUP: u32 = 64;

/// Most workgroups along one axis of a dispatch, whatever the device.
const MAX_COLUMNS: u32 = 1 << 15;

/// Time to run before anything counts, as a multiple of the effort's longest: clocks rise under
/// load, but not at once.
const WARM_UP: u32 = 2;

/// Runs of a sample: as many as take this long, so that what it costs to submit them is little.
const MIN_SAMPLE: Duration = Duration::from_millis(10);

/// But no more than this.
const MAX_RUNS_A_SAMPLE: f64 = 50.0;

/// More samples add nothing to a median.
const MAX_RUNS: usize = 200;

/// Which stage of the pipeline traces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// A compute shader: on chips with few graphics units the one to compare methods by.
    #[default]
    Compute,
    /// A fragment shader, as in the picture.
    Fragment,
}

/// What the times were read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// The GPU's own timestamps, around one run.
    Timestamps,
    /// The CPU's clock, around runs of many.
    Wall,
}

/// Time of one run, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    /// Median.
    pub median_ms: f64,
    /// From the tenth percentile to the ninetieth.
    pub spread_ms: f64,
    /// What it was read from.
    pub clock: Clock,
}

/// How many runs are timed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// At least so many.
    pub least_runs: usize,
    /// No more after so long.
    pub longest: Duration,
}

/// The rays of a scene's picture, ready to be traced again and again.
pub struct Stopwatch {
    work: Work,
    size: UVec2,
    numbers: Buffer,
    bind_group: BindGroup,
    /// Two timestamps, where they are resolved, and where they are read.
    timestamps: Option<(QuerySet, Buffer, Buffer)>,
}

impl Stopwatch {
    /// Compiles the variant of the scene.
    ///
    /// # ErrorSummary
    /// A scene that the GPU cannot trace, or a shader that does not compile.
    pub fn new(gpu: &Gpu, scene: &Scene, size: UVec2, stage: Stage) -> Result<Self, GpuError> {
        let numbers = GpuScene::new(scene, size)?;
        let module = gpu.shader("timed", &Variant::timed(scene).source())?;
        let made = gpu.validated(|| {
            let numbers = gpu.device.create_buffer_init(&BufferInitDescriptor {
                label: Some("scene"),
                contents: &uniform(&numbers),
                usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            });
            let answers = buffer(
                gpu,
                u64::from(size.x) * u64::from(size.y) * 16,
                BufferUsages::STORAGE,
            );
            let (work, layout) = match stage {
                Stage::Compute => compute(gpu, &module),
                Stage::Fragment => fragment(gpu, &module, size),
            };
            let mut entries = vec![wgpu::BindGroupEntry {
                binding: 0,
                resource: numbers.as_entire_binding(),
            }];
            if stage == Stage::Compute {
                entries.push(wgpu::BindGroupEntry {
                    binding: 3,
                    resource: answers.as_entire_binding(),
                });
            }
            let descriptor = wgpu::BindGroupDescriptor {
                label: None,
                layout: &layout,
                entries: &entries,
            };
            let bind_group = gpu.device.create_bind_group(&descriptor);
            Self {
                work,
                size,
                numbers,
                bind_group,
                timestamps: timestamps(gpu),
            }
        });
        made.map_err(GpuError::Shader)
    }

    /// Goes over to the numbers of another scene that has the same variant, such as one of another
    /// step scale.
    ///
    /// # ErrorSummary
    /// A scene that the GPU cannot trace.
    pub fn set_scene(&self, gpu: &Gpu, scene: &Scene) -> Result<(), GpuError> {
        gpu.queue.write_buffer(
            &self.numbers,
            0,
            &uniform(&GpuScene::new(scene, self.size)?),
        );
        Ok(())
    }

    /// Times the work: warms up, then runs as often as the effort says.
    ///
    /// # ErrorSummary
    /// A device that failed.
    pub fn time(&self, gpu: &Gpu, effort: Effort) -> Result<Timing, GpuError> {
        let warm_up = gpu
            .validated(|| self.warm_up(gpu, WARM_UP * effort.longest))
            .map_err(GpuError::Device)?;
        let runs = warm_up.map_err(|error| GpuError::Device(error.to_string()))?;
        let began = Instant::now();
        let mut samples = Vec::new();
        while samples.len() < effort.least_runs
            || began.elapsed() < effort.longest && samples.len() < MAX_RUNS
        {
            samples.push(self.sample(gpu, runs)?);
            // One run of a slow method on a slow device may take longer than all the rest.
            if began.elapsed() > 8 * effort.longest {
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

    /// Runs until nothing is cold any more, and tells how many runs a sample takes.
    fn warm_up(&self, gpu: &Gpu, least: Duration) -> Result<u32, wgpu::PollError> {
        let began = Instant::now();
        let mut runs = 1;
        loop {
            let this = Instant::now();
            self.submit(gpu, runs);
            gpu.device.poll(wgpu::PollType::wait_indefinitely())?;
            let one = this.elapsed().as_secs_f64() / f64::from(runs);
            runs = (MIN_SAMPLE.as_secs_f64() / one).clamp(1.0, MAX_RUNS_A_SAMPLE) as u32;
            if began.elapsed() > least {
                return Ok(runs);
            }
        }
    }

    /// One sample, in milliseconds a run, of so many runs: by the CPU's clock around all of them,
    /// or by the GPU's around the last. A GPU that is given a single short run at a time lowers its
    /// clock.
    fn sample(&self, gpu: &Gpu, runs: u32) -> Result<f64, GpuError> {
        let failed = |error: &dyn std::fmt::Display| GpuError::Device(error.to_string());
        let wait = || {
            gpu.device
                .poll(wgpu::PollType::wait_indefinitely())
                .map_err(|error| failed(&error))
        };
        let Some((_, _, readable)) = &self.timestamps else {
            let began = Instant::now();
            self.submit(gpu, runs);
            wait()?;
            return Ok(began.elapsed().as_secs_f64() * 1e3 / f64::from(runs));
        };
        self.submit(gpu, runs);
        let (sender, receiver) = std::sync::mpsc::channel();
        readable
            .slice(..)
            .map_async(wgpu::MapMode::Read, move |result| {
                // Nobody listens once the device has failed; the error is reported there.
                let _ = sender.send(result);
            });
        wait()?;
        receiver
            .recv()
            .map_err(|error| failed(&error))?
            .map_err(|error| failed(&error))?;
        let bytes = readable.slice(..).get_mapped_range().to_vec();
        readable.unmap();
        let [before, after] =
            [0, 8].map(|at| u64::from_le_bytes(std::array::from_fn(|i| bytes[at + i])));
        Ok(
            after.saturating_sub(before) as f64
                * f64::from(gpu.queue.get_timestamp_period())
                * 1e-6,
        )
    }

    fn submit(&self, gpu: &Gpu, runs: u32) {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        for run in 1..=runs {
            self.encode(&mut encoder, run == runs);
        }
        if let Some((queries, resolved, readable)) = &self.timestamps {
            encoder.resolve_query_set(queries, 0..2, resolved, 0);
            encoder.copy_buffer_to_buffer(resolved, 0, readable, 0, 16);
        }
        gpu.queue.submit([encoder.finish()]);
    }

    fn encode(&self, encoder: &mut CommandEncoder, timed: bool) {
        let queries = self
            .timestamps
            .as_ref()
            .filter(|_| timed)
            .map(|(queries, ..)| queries);
        match &self.work {
            Work::Compute(pipeline) => {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
                    label: None,
                    timestamp_writes: queries.map(|query_set| wgpu::ComputePassTimestampWrites {
                        query_set,
                        beginning_of_pass_write_index: Some(0),
                        end_of_pass_write_index: Some(1),
                    }),
                });
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, &self.bind_group, &[]);
                let groups = (self.size.x * self.size.y).div_ceil(WORKGROUP);
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
                    timestamp_writes: queries.map(|query_set| wgpu::RenderPassTimestampWrites {
                        query_set,
                        beginning_of_pass_write_index: Some(0),
                        end_of_pass_write_index: Some(1),
                    }),
                    ..Default::default()
                });
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, &self.bind_group, &[]);
                pass.draw(0..3, 0..1);
            }
        }
    }
}

/// Two timestamps, on a device that has them. Those of a software device are left alone: Mesa's are
/// taken when a compute shader is queued, not when it has run.
fn timestamps(gpu: &Gpu) -> Option<(QuerySet, Buffer, Buffer)> {
    let software = gpu.info.device_type == wgpu::DeviceType::Cpu;
    (!software
        && gpu
            .device
            .features()
            .contains(wgpu::Features::TIMESTAMP_QUERY))
    .then(|| {
        let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: None,
            ty: wgpu::QueryType::Timestamp,
            count: 2,
        });
        let resolved = buffer(
            gpu,
            16,
            BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
        );
        (
            queries,
            resolved,
            buffer(gpu, 16, BufferUsages::COPY_DST | BufferUsages::MAP_READ),
        )
    })
}

fn buffer(gpu: &Gpu, size: u64, usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size,
        usage,
        mapped_at_creation: false,
    })
}
