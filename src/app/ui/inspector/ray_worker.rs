//! The thread that traces inspected rays again, so that no frame waits for it: first with the f64
//! reference, which answers at once, then on a background GPU device.

use glam::DVec2;
use lightfall_core::accuracy::Ray;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::gpu::{GpuError, with_background_device};
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::Scene;
use lightfall_platform::worker::{Answers, Worker};

/// The thread.
pub(super) type RayWorker = Worker<RayJob, RayAnswer>;

/// An answer of the thread: the rays so far, or what failed.
pub(super) type RayAnswer = Result<InspectedRays, String>;

/// Rays to inspect. The first is the one that was clicked, the others are the fan around it.
pub(super) struct RayJob {
    /// The scene, with the picture that was clicked.
    pub(super) scene: Scene,
    /// The rays, and their places on the picture in pixels.
    pub(super) rays: Vec<(Ray, [f64; 2])>,
}

/// The rays of a job, as far as they are traced.
pub(super) struct InspectedRays {
    pub(super) scene: Scene,
    /// The rays, in the order of the job.
    pub(super) rays: Vec<Inspected>,
    /// The state of the GPU's answer for the first ray.
    pub(super) gpu: GpuState,
}

impl InspectedRays {
    /// The place in the picture of the ray that was clicked.
    pub(super) fn pixel(&self) -> Option<DVec2> {
        let first = self.rays.first()?;
        first.numbers.pixel.map(DVec2::from_array)
    }
}

/// The state of the GPU's answer.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum GpuState {
    Waiting,
    Done,
    Failed(String),
}

/// Starts the thread.
pub(super) fn start() -> RayWorker {
    Worker::serving_latest(|job, answers| {
        if let Err(fault) = trace(job, answers) {
            answers.send(Err(fault));
        }
    })
}

/// Radius at which the drawing of a path ends, in r_s.
fn path_end(scene: &Scene) -> f64 {
    3.0 * scene.camera.r + 60.0
}

fn trace(RayJob { scene, rays }: RayJob, answers: &Answers<RayAnswer>) -> Result<(), String> {
    let axes = scene.camera.tetrad_from_camera();
    let inspected = rays.iter().map(|(ray, pixel)| {
        let direction = axes * ray.direction();
        Inspected::new(&scene, direction, Some(*pixel), path_end(&scene))
            .map_err(|error| error.to_string())
    });
    let mut inspected = inspected.collect::<Result<Vec<_>, _>>()?;
    let send = |rays: &[Inspected], gpu: GpuState| {
        answers.send(Ok(InspectedRays {
            scene: scene.clone(),
            rays: rays.to_vec(),
            gpu,
        }));
    };
    send(&inspected, GpuState::Waiting);
    let (Some((ray, _)), Some(first)) = (rays.first(), inspected.first_mut()) else {
        return Ok(());
    };
    let state = match trace_on_gpu(&scene, *ray) {
        Ok(trace) => {
            first
                .compare(&scene, *ray, &trace)
                .map_err(|error| error.to_string())?;
            GpuState::Done
        }
        Err(error) => GpuState::Failed(error.to_string()),
    };
    send(&inspected, state);
    Ok(())
}

fn trace_on_gpu(scene: &Scene, ray: Ray) -> Result<Trace, GpuError> {
    with_background_device(|gpu| {
        let traces = RayKernel::new(gpu, scene)?.trace_camera_rays(gpu, scene, &[ray.given()])?;
        traces
            .into_iter()
            .next()
            .ok_or_else(|| GpuError::Device("it gave no answer".into()))
    })
}
