//! Which rows are worth their time.

use super::Measured;

/// How far `auto` is ahead of every other method in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Margin {
    /// The scene.
    pub scene: String,
    /// Time of the fastest row of another method that is no less exact, over auto's; infinite where
    /// none is that exact.
    pub faster: f64,
    /// 99th percentile of the backward error of the most exact row of another method that is no
    /// slower, over auto's; infinite where none is that fast.
    pub more_exact: f64,
}

impl Margin {
    /// Whether nothing of another method beats auto in both time and error.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.faster > 1.0 && self.more_exact > 1.0
    }
}

/// Auto's margin in a scene; none where it was not measured.
#[must_use]
pub fn auto_margin(rows: &[Measured], scene: &str) -> Option<Margin> {
    let auto = rows.iter().find(|row| row.scene == scene && row.auto)?;
    let others = || {
        rows.iter()
            .filter(|row| row.scene == scene && row.method != auto.method)
    };
    let exact = others().filter(|row| row.backward_p99 <= auto.backward_p99);
    let quick = others().filter(|row| row.trace_ms <= auto.trace_ms);
    Some(Margin {
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
pub fn is_on_front(rows: &[Measured], row: &Measured) -> bool {
    let better = |other: &Measured| {
        other.scene == row.scene
            && other.trace_ms < row.trace_ms
            && other.backward_p99 < row.backward_p99
    };
    row.backward_p99.is_finite() && !rows.iter().any(better)
}
