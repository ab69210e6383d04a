//! The Pareto front of time and error.

use super::measurement::Measurement;

/// The margin of `auto` over all other methods in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct AutoMargin {
    /// The scene.
    pub scene: String,
    /// Time of the fastest row of another method with no larger error, over `auto`'s time. Infinite
    /// if there is no such row.
    pub faster: f64,
    /// That row's method with its setting, if there is one.
    pub next: Option<String>,
    /// Error of the most exact row of another method that is no slower, over `auto`'s error. The
    /// error is the 99th percentile of the backward error. Infinite if there is no such row.
    pub more_exact: f64,
    /// What the measured times say about the front.
    pub ranking: Ranking,
}

/// Whether `auto` is on the Pareto front of its scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ranking {
    /// No other method is as good in both time and error, wherever the times lie within their
    /// spreads.
    OnFront,
    /// Another method is as good in both, wherever the times lie within their spreads.
    NotOnFront,
    /// The answer depends on where the times lie within their spreads.
    Undecided {
        /// The largest half spread of a time of this scene, as a share of the time.
        spread: f64,
    },
}

/// `auto`'s margin in a scene. `None` if `auto`'s method was not measured.
pub fn auto_margin(rows: &[Measurement], scene: &str) -> Option<AutoMargin> {
    let rows: Vec<_> = rows.iter().filter(|row| row.scene == scene).collect();
    let auto = *rows.iter().find(|row| row.auto)?;
    let others: Vec<_> = rows
        .iter()
        .filter(|row| row.method != auto.method)
        .collect();
    let exact: Vec<_> = others
        .iter()
        .filter(|row| row.backward_p99 <= auto.backward_p99)
        .collect();
    // Faster and more exact, with each time moved by a share of its spread.
    let margins = |of_auto: f64, of_others: f64| {
        let auto_ms = moved(auto, of_auto);
        let quick = others.iter().filter(|row| moved(row, of_others) <= auto_ms);
        let faster = exact.iter().map(|row| moved(row, of_others) / auto_ms);
        let more_exact = quick.map(|row| row.backward_p99 / auto.backward_p99);
        [
            faster.fold(f64::INFINITY, f64::min),
            more_exact.fold(f64::INFINITY, f64::min),
        ]
    };
    let leads = |[faster, more_exact]: [f64; 2]| faster > 1.0 && more_exact > 1.0;
    let ranking = match (leads(margins(0.5, -0.5)), leads(margins(-0.5, 0.5))) {
        (true, _) => Ranking::OnFront,
        (false, false) => Ranking::NotOnFront,
        (false, true) => Ranking::Undecided {
            spread: rows
                .iter()
                .map(|row| 0.5 * row.trace_spread_ms / row.trace_ms)
                .fold(0.0, f64::max),
        },
    };
    let [faster, more_exact] = margins(0.0, 0.0);
    let next = exact
        .iter()
        .min_by(|a, b| a.trace_ms.total_cmp(&b.trace_ms))
        .map(|row| row.label());
    Some(AutoMargin {
        scene: scene.into(),
        faster,
        next,
        more_exact,
        ranking,
    })
}

/// The time of a row, moved by a share of its spread, in milliseconds. It stays above zero.
fn moved(row: &Measurement, share: f64) -> f64 {
    (row.trace_ms + share * row.trace_spread_ms).max(f64::MIN_POSITIVE)
}

/// Whether no row of the same scene is both faster and more exact.
pub fn is_on_front(rows: &[Measurement], row: &Measurement) -> bool {
    let better = |other: &Measurement| {
        other.scene == row.scene
            && other.trace_ms < row.trace_ms
            && other.backward_p99 < row.backward_p99
    };
    row.backward_p99.is_finite() && !rows.iter().any(better)
}
