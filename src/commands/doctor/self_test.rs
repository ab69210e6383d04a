//! The self-test: a few hundred rays, traced by the same WGSL as pictures, compared with the f64
//! reference, and timed.

use glam::UVec2;
use lightfall_core::accuracy::{
    ErrorSummary, Ray, Truth, rays_over_picture_and_near_edge, tolerance,
};
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::gpu::timing::{Effort, Stage, Stopwatch};
use lightfall_core::gpu::{Gpu, GpuError};
use lightfall_core::numbers::short_number;
use lightfall_core::scene::Scene;
use serde::Serialize;
use std::time::Duration;

/// Number of rays, half of them spread over the picture, half near the shadow's edge.
const RAYS: usize = 512;
/// Size of the picture whose rays are timed.
const TIMED_SIZE: UVec2 = UVec2::new(1920, 1080);
/// Effort of the timing.
const EFFORT: Effort = Effort {
    min_samples: 3,
    max_time: Duration::from_millis(100),
};

/// The backward errors that the documentation states for a method, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatedErrors {
    /// 99 of 100 rays stay within this error: docs/ACCURACY.md.
    pub p99: f64,
    /// Every ray stays within this error: docs/EXTREMES.md.
    pub max: f64,
}

impl StatedErrors {
    /// The errors stated for the method that traces this scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let method = scene.resolved_method();
        let max = tolerance(&scene.with_method(method));
        let p99 = method.backward_p99(scene.hole.spin).unwrap_or(max);
        Self { p99, max }
    }

    /// Whether every ray has an answer and the errors are as stated.
    #[must_use]
    pub fn admit(&self, errors: &ErrorSummary) -> bool {
        unanswered(errors) == 0
            && errors.backward.p99 <= self.p99
            && errors.backward.max <= self.max
    }
}

/// Number of rays without an answer, or whose answer has a value that is not finite.
fn unanswered(errors: &ErrorSummary) -> usize {
    errors.unfinished().max(errors.not_finite)
}

/// The errors of the GPU's answers to the self-test's rays through a scene.
///
/// # Errors
/// The GPU cannot trace the scene, or the device failed.
pub fn measure_errors(gpu: &Gpu, scene: &Scene) -> Result<ErrorSummary, GpuError> {
    let truth = Truth::of(scene, rays_over_picture_and_near_edge(scene, RAYS))?;
    let directions: Vec<_> = truth.rays.iter().map(Ray::given).collect();
    let given = RayKernel::new(gpu, scene)?.trace_camera_rays(gpu, scene, &directions)?;
    let errors = truth.judge_to_limit(StatedErrors::of(scene).max, &given);
    Ok(ErrorSummary::of_errors(&truth, &given, &errors))
}

/// The result of the self-test for one preset.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SelfTest {
    /// Name of the preset.
    pub scene: String,
    /// The method that `auto` stands for.
    pub method: &'static str,
    /// Number of rays.
    pub rays: usize,
    /// Number of rays without an answer, or whose answer has a value that is not finite.
    pub unanswered: usize,
    /// Maximum of the backward errors, in pixels of the preset's picture.
    pub backward_max_px: f64,
    /// Maximum of the backward errors, in radians.
    pub backward_max: f64,
    /// The maximum that the documentation states, in radians.
    pub stated_max: f64,
    /// 99th percentile of the backward errors, in radians.
    pub backward_p99: f64,
    /// The 99th percentile that the documentation states, in radians.
    pub stated_p99: f64,
    /// Whether every ray has an answer, and the errors are as stated.
    pub holds: bool,
    /// Time of tracing the rays of a picture of 1920x1080, in milliseconds.
    pub trace_ms_1920x1080: f64,
    /// The clock that the time was read from.
    pub clock: &'static str,
}

impl SelfTest {
    /// Traces rays through a scene on the GPU, measures their errors, and times the rays of a large
    /// picture.
    ///
    /// # Errors
    /// The GPU cannot trace the scene, or the device failed.
    pub(super) fn run(gpu: &Gpu, name: &str, scene: &Scene) -> Result<Self, GpuError> {
        let (errors, stated) = (measure_errors(gpu, scene)?, StatedErrors::of(scene));
        let timing = Stopwatch::new(gpu, scene, TIMED_SIZE, Stage::Compute)?.time(gpu, EFFORT)?;
        let backward = errors.backward;
        Ok(Self {
            scene: name.into(),
            method: scene.resolved_method().word(),
            rays: errors.rays,
            unanswered: unanswered(&errors),
            backward_max_px: backward.max / scene.pixel_angle(),
            backward_max: backward.max,
            stated_max: stated.max,
            backward_p99: backward.p99,
            stated_p99: stated.p99,
            holds: stated.admit(&errors),
            trace_ms_1920x1080: timing.median_ms,
            clock: timing.clock.word(),
        })
    }

    /// Time of tracing a picture of 960x540, in milliseconds.
    pub(super) fn frame_ms(&self) -> f64 {
        self.trace_ms_1920x1080 / 4.0
    }

    /// What is wrong, if the test fails.
    pub(super) fn fault(&self) -> Option<String> {
        (!self.holds).then(|| {
            format!(
                "self-test {}: of {} rays traced by {}, {} have no answer; 99 of 100 are within {} rad \
                 (stated: {}), all are within {} rad (stated: {})",
                self.scene,
                self.rays,
                self.method,
                self.unanswered,
                short_number(self.backward_p99),
                short_number(self.stated_p99),
                short_number(self.backward_max),
                short_number(self.stated_max)
            )
        })
    }
}
