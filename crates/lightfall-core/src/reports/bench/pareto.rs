//! The Pareto front of time and error.

use super::measurement::Measurement;

/// How far `auto` is ahead of all other methods in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct AutoMargin {
    /// The scene.
    pub scene: String,
    /// Time of the fastest row of another method with no larger error, over `auto`'s time. Infinite
    /// if there is no such row.
    pub faster: f64,
    /// Error of the most exact row of another method that is no slower, over `auto`'s error. The
    /// error is the 99th percentile of the backward error. Infinite if there is no such row.
    pub more_exact: f64,
}

impl AutoMargin {
    /// Whether no row of another method is as good as `auto` in both time and error.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.faster > 1.0 && self.more_exact > 1.0
    }
}

/// `auto`'s margin in a scene. `None` if `auto`'s method was not measured.
#[must_use]
pub fn auto_margin(rows: &[Measurement], scene: &str) -> Option<AutoMargin> {
    let auto = rows.iter().find(|row| row.scene == scene && row.auto)?;
    let others = || {
        rows.iter()
            .filter(|row| row.scene == scene && row.method != auto.method)
    };
    let exact = others().filter(|row| row.backward_p99 <= auto.backward_p99);
    let quick = others().filter(|row| row.trace_ms <= auto.trace_ms);
    Some(AutoMargin {
        scene: scene.into(),
        faster: exact
            .map(|row| row.trace_ms / auto.trace_ms)
            .fold(f64::INFINITY, f64::min),
        more_exact: quick
            .map(|row| row.backward_p99 / auto.backward_p99)
            .fold(f64::INFINITY, f64::min),
    })
}

/// Whether no row of the same scene is both faster and more exact.
#[must_use]
pub fn is_on_front(rows: &[Measurement], row: &Measurement) -> bool {
    let better = |other: &Measurement| {
        other.scene == row.scene
            && other.trace_ms < row.trace_ms
            && other.backward_p99 < row.backward_p99
    };
    row.backward_p99.is_finite() && !rows.iter().any(better)
}
