//! The thread that traces inspected rays again, so that no frame waits for it: first with the f64
//! reference, which answers at once, then on a background GPU device.

use glam::DVec2;
use lightfall_core::accuracy::Ray;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::gpu::passages::{GivenRay, GpuPassage, PassageKernel};
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::gpu::{GpuError, with_background_device};
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::Scene;
use lightfall_platform::worker::Worker;

/// The thread. It answers with the rays so far, or with what failed.
pub(super) type RayWorker = Worker<RayJob, Result<InspectedRays, String>>;

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
    /// Why the GPU gives no answer for the first ray. None while the answer is awaited, too.
    pub(super) gpu_fault: Option<String>,
}

/// Starts the thread.
pub(super) fn start() -> RayWorker {
    Worker::serving_latest(|job, answers| {
        if let Err(fault) = trace(job, |rays| answers.send(Ok(rays))) {
            answers.send(Err(fault));
        }
    })
}

fn trace(RayJob { scene, rays }: RayJob, answer: impl Fn(InspectedRays)) -> Result<(), String> {
    let axes = scene.camera.tetrad_from_camera();
    // The drawing of a path ends there.
    let farthest = 3.0 * scene.camera.r + 60.0;
    let inspected = rays.iter().map(|(ray, pixel)| {
        let direction = axes * ray.direction();
        Inspected::new(&scene, direction, Some(*pixel), farthest).map_err(|error| error.to_string())
    });
    let mut inspected = inspected.collect::<Result<Vec<_>, _>>()?;
    // Only the numbers of the first ray are shown.
    if let Some(first) = inspected.first_mut() {
        first
            .add_matter(&scene)
            .map_err(|error| error.to_string())?;
    }
    let send = |rays: &[Inspected], gpu_fault| {
        answer(InspectedRays {
            scene: scene.clone(),
            rays: rays.to_vec(),
            gpu_fault,
        });
    };
    send(&inspected, None);
    let (Some((ray, pixel)), Some(first)) = (rays.first(), inspected.first_mut()) else {
        return Ok(());
    };
    let gpu_fault = match trace_on_gpu(&scene, *ray, *pixel) {
        Ok((trace, passage)) => {
            first
                .compare(&scene, *ray, &trace)
                .map_err(|error| error.to_string())?;
            if let (Some(matter), Some(passage)) = (&mut first.numbers.matter, passage) {
                let seen = (passage.light, passage.transmission);
                matter.compare(&scene, seen, passage.samples, passage.error);
            }
            None
        }
        Err(error) => Some(error.to_string()),
    };
    send(&inspected, gpu_fault);
    Ok(())
}

/// The trace of a ray and, in a scene with matter with depth, what this does to the pixel's light.
fn trace_on_gpu(
    scene: &Scene,
    ray: Ray,
    pixel: [f64; 2],
) -> Result<(Trace, Option<GpuPassage>), GpuError> {
    let no_answer = || GpuError::Device("it gave no answer".into());
    with_background_device(|gpu| {
        let traces = RayKernel::new(gpu, scene)?.trace_camera_rays(gpu, scene, &[ray.given()])?;
        let trace = traces.into_iter().next().ok_or_else(no_answer)?;
        if !scene.has_medium() {
            return Ok((trace, None));
        }
        let size = scene.picture.size().as_dvec2();
        let beside = |by: DVec2| {
            scene
                .camera
                .looking(DVec2::from(pixel) + by, size)
                .as_vec3()
        };
        let given = GivenRay {
            direction: ray.given(),
            right: beside(DVec2::X),
            below: beside(DVec2::Y),
        };
        let passages = PassageKernel::of_pixels(gpu, scene)?.passages(gpu, scene, [given])?;
        let passage = passages.into_iter().next().ok_or_else(no_answer)?;
        Ok((trace, Some(passage)))
    })
}
