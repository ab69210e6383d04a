//! One row of the report: a method at one setting in one scene.

use super::settings::{Setting, label, setting_label};
use crate::import::{or_infinite, or_nan};
use lightfall_accuracy::{ErrorSummary, Truth, tolerance};
use lightfall_gpu::timing::Timing;
use lightfall_model::scene::AccuracySetting;
use lightfall_optics::trace::Trace;
use serde::{Deserialize, Serialize};

/// Error and time of one method at one setting in one scene. Angles are in radians unless their
/// name ends in `_px`. The error of an unfinished ray is infinite, and null in JSON.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Measurement {
    /// Name of the scene.
    pub scene: String,
    /// Name of the method.
    pub method: String,
    /// Key of the field that is the method's setting, if it has one.
    pub setting: Option<String>,
    /// The setting's value.
    pub value: Option<f64>,
    /// Whether it is the scene's own setting.
    pub own_setting: bool,
    /// Whether `auto` draws the scene with this method and setting.
    pub auto: bool,
    /// Median time of tracing the picture's rays, in milliseconds.
    pub trace_ms: f64,
    /// Difference between the 90th and the 10th percentile of that time, in milliseconds.
    pub trace_spread_ms: f64,
    /// The clock that the times were read from.
    pub clock: String,
    /// GPU time of the whole frame, in milliseconds, if it was measured.
    pub frame_ms: Option<f64>,
    /// Number of rays whose error was measured.
    pub rays: usize,
    /// Number of rays that the method gave up.
    pub unfinished: usize,
    /// Number of rays whose answer has a value that is not finite.
    pub not_finite: usize,
    /// Number of rays with a wrong outcome or number of hits.
    pub misclassified: usize,
    /// Numbers of the rays that should reach the sky, by the method's outcome: sky, captured,
    /// unfinished.
    pub sky_as: [usize; 3],
    /// Numbers of the rays that should be captured, by the method's outcome, in the same order.
    pub captured_as: [usize; 3],
    /// Forward error of the sky direction: its median.
    #[serde(deserialize_with = "or_nan")]
    pub sky_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub sky_p99: f64,
    /// Relative error of the radius of hits: its median.
    #[serde(deserialize_with = "or_nan")]
    pub hit_r_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub hit_r_p99: f64,
    /// Relative error of the g of hits: its median.
    #[serde(deserialize_with = "or_nan")]
    pub hit_g_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub hit_g_p99: f64,
    /// Backward error: its median.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p99: f64,
    /// Its maximum.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_max: f64,
    /// Median of the backward error in pixels of the scene's picture.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p50_px: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p99_px: f64,
    /// Mean number of steps.
    pub steps_mean: f64,
    /// Maximum number of steps.
    pub steps_max: f64,
    /// Largest normalized residual of the null constraint.
    pub residual: f64,
    /// The article's word for the setting, if it has one.
    pub quality: Option<String>,
    /// The budget of steps of a ray, for methods with one.
    pub max_steps: Option<u32>,
}

impl Measurement {
    pub(super) fn new(
        name: &str,
        setting: &Setting,
        timing: Timing,
        truth: &Truth,
        traces: &[Trace],
    ) -> Self {
        let scene = &setting.scene;
        let errors = if scene.method.properties().answers_every_ray {
            truth.judge_to_limit(tolerance(scene), traces)
        } else {
            // The article's methods have large errors of their own: a search for each would take hours.
            truth.judge(traces)
        };
        let errors = ErrorSummary::of_errors(truth, traces, &errors);
        let pixel = scene.pixel_angle();
        let [steps_mean, steps_max] = errors.steps;
        let budgeted = scene.method.properties().setting == AccuracySetting::StepScale;
        Self {
            scene: name.into(),
            method: scene.method.word().into(),
            setting: setting.key.map(str::to_owned),
            value: setting.key.map(|_| setting.value),
            own_setting: setting.own,
            auto: setting.auto,
            trace_ms: timing.median_ms,
            trace_spread_ms: timing.spread_ms,
            clock: timing.clock.word().into(),
            frame_ms: None,
            rays: errors.rays,
            unfinished: errors.unfinished(),
            not_finite: errors.not_finite,
            misclassified: errors.misclassified,
            sky_as: errors.confusion[0],
            captured_as: errors.confusion[1],
            sky_p50: errors.sky.p50,
            sky_p99: errors.sky.p99,
            hit_r_p50: errors.hit_r.p50,
            hit_r_p99: errors.hit_r.p99,
            hit_g_p50: errors.hit_g.p50,
            hit_g_p99: errors.hit_g.p99,
            backward_p50: errors.backward.p50,
            backward_p99: errors.backward.p99,
            backward_max: errors.backward.max,
            backward_p50_px: errors.backward.p50 / pixel,
            backward_p99_px: errors.backward.p99 / pixel,
            steps_mean,
            steps_max,
            residual: errors.residual,
            quality: setting.quality.map(|quality| quality.word().to_owned()),
            max_steps: budgeted.then_some(scene.quality.max_steps),
        }
    }

    /// The method with its setting, as in tables.
    pub fn label(&self) -> String {
        label(&self.method, &self.setting_label())
    }

    /// The setting alone, as in plots.
    pub(super) fn setting_label(&self) -> String {
        setting_label(self.quality.as_deref(), self.value)
    }
}
