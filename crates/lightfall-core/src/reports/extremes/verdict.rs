//! What became of a method in a cell, and whether that is good enough.

use super::Cell;
use crate::accuracy::ErrorSummary;
use crate::reports::bench::short;
use crate::scene::{AccuracySetting, Method, Quality, Scene};
use serde::Serialize;
use std::fmt::Write;

/// The name of mino at its tightest setting.
const TIGHTEST: &str = "mino, tightest";

/// The scene with mino's tightest setting.
pub(super) fn tightest(scene: &Scene) -> Scene {
    let quality = Quality {
        max_error_px: 1e-4,
        ..scene.quality
    };
    Scene {
        method: Method::Mino,
        quality,
        ..scene.clone()
    }
}

/// What a method must keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Largest backward error, of every ray, in radians.
    pub backward: f64,
}

/// The bar of a scene's method. The solved methods are held to what f32 leaves of a direction, mino
/// at least to its own setting in pixels of the scene's picture; the article's to a pixel of their
/// own pictures, 960x540 at 60 degrees.
#[must_use]
pub fn tolerance(scene: &Scene) -> Tolerance {
    let method = scene.method.properties();
    let backward = match method.setting {
        AccuracySetting::MaxError => {
            let pixel = scene.camera.pixel_angle(f64::from(scene.picture.height));
            f64::max(method.backward_max, scene.quality.max_error_px * pixel)
        }
        AccuracySetting::None | AccuracySetting::StepScale => method.backward_max,
    };
    Tolerance { backward }
}

/// A method in a cell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// What is extreme.
    pub group: &'static str,
    /// How extreme.
    pub cell: String,
    /// The method; mino at its tightest setting has a name of its own.
    pub method: &'static str,
    /// How many rays.
    pub rays: usize,
    /// How many were given up.
    pub unfinished: usize,
    /// How many answers hold something that is no number.
    pub not_finite: usize,
    /// How many have the wrong outcome or number of hits.
    pub misclassified: usize,
    /// The largest turn that explains one of those, in radians.
    pub misclassified_max: f64,
    /// Median of the backward error, in radians.
    pub backward_p50: f64,
    /// Its 99th percentile.
    pub backward_p99: f64,
    /// Its largest value.
    pub backward_max: f64,
    /// Largest normalized residual of the null constraint.
    pub residual: f64,
    /// Most steps.
    pub steps_max: f64,
    /// The largest backward error that is allowed.
    pub bar: f64,
    /// Whether all is well: every ray has an answer, of numbers, within the bar.
    pub holds: bool,
}

impl Verdict {
    pub(super) fn new(cell: &Cell, scene: &Scene, errors: &ErrorSummary) -> Self {
        let bar = tolerance(scene).backward;
        // A cell of rays that see nothing has no backward error at all, and that is none.
        let some = |value: f64| if value.is_nan() { 0.0 } else { value };
        let backward_max = some(errors.backward.max);
        let sound = errors.unfinished() == 0 && errors.not_finite == 0;
        Self {
            group: cell.group,
            cell: cell.name.clone(),
            method: if *scene == tightest(scene) {
                TIGHTEST
            } else {
                scene.method.word()
            },
            rays: errors.rays,
            unfinished: errors.unfinished(),
            not_finite: errors.not_finite,
            misclassified: errors.misclassified,
            misclassified_max: some(errors.misclassified_backward.max),
            backward_p50: some(errors.backward.p50),
            backward_p99: some(errors.backward.p99),
            backward_max,
            residual: errors.residual,
            steps_max: errors.steps[1],
            bar,
            holds: sound && errors.rays > 0 && backward_max <= bar,
        }
    }

    /// The verdict in a word or two.
    #[must_use]
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

/// The matrix for people.
#[must_use]
pub fn markdown(verdicts: &[Verdict]) -> String {
    let mut text = String::from(
        "| cell | method | rays | unfinished | not a number | wrong class | backward p50 | p99 | max | bar | residual | steps | verdict |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let mut group = "";
    for verdict in verdicts {
        if verdict.group != group {
            group = verdict.group;
            writeln!(text, "| **{group}** | | | | | | | | | | | | |")
                .expect("writing to a string cannot fail");
        }
        writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            verdict.cell,
            verdict.method,
            verdict.rays,
            verdict.unfinished,
            verdict.not_finite,
            verdict.misclassified,
            short(verdict.backward_p50),
            short(verdict.backward_p99),
            short(verdict.backward_max),
            short(verdict.bar),
            short(verdict.residual),
            verdict.steps_max,
            verdict.word(),
        )
        .expect("writing to a string cannot fail");
    }
    text
}
