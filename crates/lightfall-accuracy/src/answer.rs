//! Comparisons of answers.

use glam::DVec3;
use lightfall_optics::trace::{Outcome, Trace};

/// Whether all numbers of an answer are finite.
pub(super) fn all_finite(trace: &Trace) -> bool {
    let hits = trace
        .hits
        .iter()
        .flatten()
        .all(|hit| (hit.r * hit.phi * hit.g * hit.delay.unwrap_or(1.0)).is_finite());
    hits && trace.sky.is_none_or(DVec3::is_finite) && trace.residual.is_finite()
}

/// Whether an answer is finished and all its numbers are finite.
pub(super) fn is_complete(trace: &Trace) -> bool {
    trace.outcome != Outcome::Unfinished && all_finite(trace)
}

/// The number of hits of an answer.
pub fn hits(trace: &Trace) -> usize {
    trace.hits.iter().flatten().count()
}

/// Whether two answers have the same outcome and number of hits.
pub fn is_same_class(a: &Trace, b: &Trace) -> bool {
    a.outcome == b.outcome && hits(a) == hits(b)
}

/// The greater of two numbers. NaN is greater than any number.
pub fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
