//! Comparisons in which NaN is the worst value of all.

use crate::optics::trace::Trace;
use glam::DVec3;

/// Whether every number of an answer is finite.
pub(super) fn all_finite(trace: &Trace) -> bool {
    let hits = trace
        .hits
        .iter()
        .flatten()
        .all(|hit| (hit.r * hit.phi * hit.g * hit.delay.unwrap_or(1.0)).is_finite());
    hits && trace.sky.is_none_or(DVec3::is_finite) && trace.residual.is_finite()
}

/// The greater of two numbers. NaN is greater than any number.
pub(crate) fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
