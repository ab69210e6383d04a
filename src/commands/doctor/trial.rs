//! The self-test: a few hundred rays by the very WGSL of the pictures, held against the f64
//! reference, and timed.

use glam::UVec2;
use lightfall_core::accuracy::{ErrorSummary, Ray, Truth, rays_near_edge, rays_over_picture};
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::gpu::timing::{Effort, Stage, Stopwatch};
use lightfall_core::gpu::{Gpu, GpuError};
use lightfall_core::reports::bench::{CRITICAL, short};
use lightfall_core::reports::extremes::tolerance;
use lightfall_core::scene::Scene;
use serde::Serialize;
use std::time::Duration;

/// Rays of a trial, half of them all over the picture, half next to the shadow's edge.
const RAYS: usize = 512;
/// The picture whose rays are timed.
const TIMED: UVec2 = UVec2::new(1920, 1080);
/// How often they are.
const EFFORT: Effort = Effort {
    min_samples: 3,
    max_time: Duration::from_millis(100),
};

/// The backward errors that the documentation states for a method, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stated {
    /// 99 rays of 100 are within: docs/ACCURACY.md.
    pub p99: f64,
    /// Every ray is within: docs/EXTREMES.md.
    pub max: f64,
}

impl Stated {
    /// Of the method that traces this scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let method = scene.method.resolved(scene.hole.spin);
        let max = tolerance(&Scene {
            method,
            ..scene.clone()
        })
        .backward;
        let p99 = method.properties().backward_p99.unwrap_or(max);
        Self { p99, max }
    }

    /// Whether all answers are there and their errors are as stated.
    #[must_use]
    pub fn admits(&self, errors: &ErrorSummary) -> bool {
        unanswered(errors) == 0
            && errors.backward.p99 <= self.p99
            && errors.backward.max <= self.max
    }
}

/// Rays without an answer, or with one that holds something that is no number.
fn unanswered(errors: &ErrorSummary) -> usize {
    errors.unfinished().max(errors.not_finite)
}

/// What is wrong with the GPU's answers to a trial's rays.
///
/// # ErrorSummary
/// A scene that cannot be traced, or a device that failed.
pub fn errors(gpu: &Gpu, scene: &Scene) -> Result<ErrorSummary, GpuError> {
    let mut rays = rays_over_picture(scene, RAYS / 2);
    rays.extend(rays_near_edge(scene, RAYS / 2, CRITICAL));
    let truth = Truth::of(scene, rays)?;
    let given: Vec<_> = truth.rays.iter().map(Ray::given).collect();
    Ok(ErrorSummary::of(
        &truth,
        &RayKernel::new(gpu, scene)?.trace(gpu, scene, &given)?,
    ))
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// Name of the preset.
    pub scene: String,
    /// The method that `auto` takes.
    pub method: &'static str,
    /// How many rays.
    pub rays: usize,
    /// Rays without an answer, or with one that holds something that is no number.
    pub unanswered: usize,
    /// The largest turn of a ray that explains its error, in pixels of the preset's picture.
    pub backward_max_px: f64,
    /// The same in radians.
    pub backward_max: f64,
    /// What is stated of it, in radians.
    pub stated_max: f64,
    /// Its 99th percentile, in radians.
    pub backward_p99: f64,
    /// What is stated of that, in radians.
    pub stated_p99: f64,
    /// Whether every ray has an answer, and the errors are as stated.
    pub holds: bool,
    /// Time of tracing the rays of a picture of 1920x1080, in milliseconds.
    pub trace_ms_1920x1080: f64,
    /// What that was read from.
    pub clock: &'static str,
}

impl Trial {
    /// Traces a scene's rays on the GPU, judges the answers, and times those of a large picture.
    ///
    /// # ErrorSummary
    /// A scene that cannot be traced, or a device that failed.
    pub(super) fn of(gpu: &Gpu, name: &str, scene: &Scene) -> Result<Self, GpuError> {
        let (errors, stated) = (errors(gpu, scene)?, Stated::of(scene));
        let timing = Stopwatch::new(gpu, scene, TIMED, Stage::Compute)?.time(gpu, EFFORT)?;
        let backward = errors.backward;
        Ok(Self {
            scene: name.into(),
            method: scene.method.resolved(scene.hole.spin).word(),
            rays: errors.rays,
            unanswered: unanswered(&errors),
            backward_max_px: backward.max
                / scene.camera.pixel_angle(f64::from(scene.picture.height)),
            backward_max: backward.max,
            stated_max: stated.max,
            backward_p99: backward.p99,
            stated_p99: stated.p99,
            holds: stated.admits(&errors),
            trace_ms_1920x1080: timing.median_ms,
            clock: timing.clock.word(),
        })
    }

    /// Time of tracing a picture of 960x540, in milliseconds.
    pub(super) fn frame_ms(&self) -> f64 {
        self.trace_ms_1920x1080 / 4.0
    }

    /// What is wrong with it, if anything is.
    pub(super) fn fault(&self) -> Option<String> {
        let Self {
            scene,
            method,
            rays,
            unanswered,
            ..
        } = self;
        (!self.holds).then(|| {
            format!(
                "self-test {scene}: of {rays} rays by {method} {unanswered} have no answer, 99 of 100 are within {} rad (stated: \
                 {}), all within {} rad (stated: {})",
                short(self.backward_p99),
                short(self.stated_p99),
                short(self.backward_max),
                short(self.stated_max)
            )
        })
    }
}
