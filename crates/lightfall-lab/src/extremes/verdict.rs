//! The errors of a method in a cell, and whether they are within its tolerance.

use super::cells::Cell;
use super::far_ray::FarRays;
use super::narrow_ring::count_unanswerable;
use crate::import::{or_infinite, or_nan};
use crate::table::grouped_table;
use lightfall_accuracy::{ErrorSummary, RayError, Truth, tolerance};
use lightfall_model::numbers::short_number;
use lightfall_model::scene::{Method, Scene};
use lightfall_optics::trace::Trace;
use serde::{Deserialize, Serialize};

const TIGHTEST: &str = "mino, tightest";

/// The scene with method mino at its tightest setting.
pub(super) fn tightest(scene: &Scene) -> Scene {
    let mut scene = scene.with_method(Method::Mino);
    scene.quality.max_error_px = 1e-4;
    scene
}

/// The errors of a method in a cell.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Verdict {
    /// What is extreme.
    pub group: String,
    /// How extreme.
    pub cell: String,
    /// The method. Mino at its tightest setting has a name of its own.
    pub method: String,
    /// Number of rays.
    pub rays: usize,
    /// Number of rays that the method gave up.
    pub unfinished: usize,
    /// Number of answers with a value that is not finite.
    pub not_finite: usize,
    /// Number of answers with a wrong outcome or number of hits.
    pub misclassified: usize,
    /// Maximum of the backward errors of those answers, in radians.
    #[serde(deserialize_with = "or_infinite")]
    pub misclassified_max: f64,
    /// Median of the backward error, in radians.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p50: f64,
    /// Its 99th percentile, in radians.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p99: f64,
    /// Its maximum, in radians.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_max: f64,
    /// Largest normalized residual of the null constraint.
    pub residual: f64,
    /// Maximum number of steps.
    pub steps_max: f64,
    /// The largest backward error that is allowed, in radians.
    #[serde(rename = "bar")]
    pub tolerance: f64,
    /// Whether every ray has an answer of finite numbers, within the tolerance, or explained by a
    /// rounding, or unanswerable.
    pub holds: bool,
    /// Number of rays with a hit that is compared: one that the method and the reference have.
    pub hits: usize,
    /// Median of the relative error of the hits' radii; NaN in a cell without hits.
    #[serde(deserialize_with = "or_nan")]
    pub hit_r_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub hit_r_p99: f64,
    /// Median of the relative error of the hits' g; NaN in a cell without hits.
    #[serde(deserialize_with = "or_nan")]
    pub hit_g_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub hit_g_p99: f64,
    /// Number of rays with an error beyond the tolerance.
    pub beyond: usize,
    /// Number of those rays whose error nothing explains.
    pub unexplained: usize,
    /// Number of rays that meet a ring by the method or by the reference alone, where the ring is
    /// too narrow for f32 to tell.
    pub unanswerable: usize,
}

impl Verdict {
    /// The verdict on the answers of the scene's method to the cell's rays.
    pub(super) fn new(cell: &Cell, scene: &Scene, truth: &Truth, given: &[Trace]) -> Self {
        let tolerance = tolerance(scene);
        let mut ray_errors = truth.judge(given);
        // The article's methods have errors of their own, far larger than those of f32.
        let [beyond, unexplained] = if scene.method.properties().answers_every_ray {
            let far = FarRays::find(scene, truth, given, &mut ray_errors);
            [far.len(), far.unexplained()]
        } else {
            let is_far = |error: &&RayError| error.backward > tolerance;
            let beyond = ray_errors.iter().filter(is_far).count();
            [beyond, beyond]
        };
        let errors = ErrorSummary::of_errors(truth, given, &ray_errors);
        // In a cell whose rays see nothing there are no backward errors, and none is too large.
        let zero_if_none = |value: f64| if value.is_nan() { 0.0 } else { value };
        let backward_max = zero_if_none(errors.backward.max);
        let sound = errors.unfinished() == 0 && errors.not_finite == 0;
        Self {
            group: cell.group.into(),
            cell: cell.name.clone(),
            method: if *scene == tightest(scene) {
                TIGHTEST.into()
            } else {
                scene.method.word().into()
            },
            rays: errors.rays,
            unfinished: errors.unfinished(),
            not_finite: errors.not_finite,
            misclassified: errors.misclassified,
            misclassified_max: zero_if_none(errors.misclassified_backward.max),
            backward_p50: zero_if_none(errors.backward.p50),
            backward_p99: zero_if_none(errors.backward.p99),
            backward_max,
            residual: errors.residual,
            steps_max: errors.steps[1],
            tolerance,
            holds: sound && errors.rays > 0 && unexplained == 0,
            hits: errors.hit_r.count,
            hit_r_p50: errors.hit_r.p50,
            hit_r_p99: errors.hit_r.p99,
            hit_g_p50: errors.hit_g.p50,
            hit_g_p99: errors.hit_g.p99,
            beyond,
            unexplained,
            unanswerable: count_unanswerable(scene, truth, given),
        }
    }

    /// The verdict in one to three words.
    pub fn word(&self) -> &'static str {
        match self {
            _ if self.holds => "holds",
            _ if self.rays == 0 => "no rays",
            _ if self.not_finite > 0 => "NOT A NUMBER",
            _ if self.unfinished > 0 => "gives up",
            _ => "too far off",
        }
    }
}

/// The matrix as a Markdown table, for people.
pub fn markdown(verdicts: &[Verdict]) -> String {
    let row = |verdict: &Verdict| {
        format!(
            "{} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {}",
            verdict.cell,
            verdict.method,
            verdict.rays,
            verdict.unfinished,
            verdict.not_finite,
            verdict.misclassified,
            short_number(verdict.backward_p50),
            short_number(verdict.backward_p99),
            short_number(verdict.backward_max),
            short_number(verdict.tolerance),
            short_number(verdict.residual),
            verdict.steps_max,
            verdict.word(),
            verdict.hits,
            short_number(verdict.hit_r_p50),
            short_number(verdict.hit_r_p99),
            short_number(verdict.hit_g_p50),
            short_number(verdict.hit_g_p99),
            verdict.beyond,
            verdict.unexplained,
            verdict.unanswerable,
        )
    };
    grouped_table(
        "cell | method | rays | unfinished | not a number | wrong class | backward p50 | p99 | max | bar | \
         residual | steps | verdict | hits | hit r p50 | p99 | hit g p50 | p99 | beyond | unexplained | \
         unanswerable",
        verdicts
            .iter()
            .map(|verdict| (&*verdict.group, row(verdict))),
    )
}
