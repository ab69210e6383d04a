//! How much faster one method is than another where both are as exact.

use super::Measured;

/// One method against another in a scene, at each level of error that the other reaches with some
/// setting: the 99th percentile of the backward error.
#[derive(Clone, Debug, PartialEq)]
pub struct AtEqualError {
    /// The scene.
    pub scene: String,
    /// Time of the slower over that of the faster: least and largest of the levels.
    pub ratio: [f64; 2],
    /// The same without what both pay in the bench itself, where that was measured.
    pub net_ratio: Option<[f64; 2]>,
    /// The least error of the faster and of the slower, in radians.
    pub best: [f64; 2],
}

/// `fast` against `slow` in a scene, `floor` being the time of a run that traces nothing but
/// straight lines. None where a method was not measured or the slower reaches no level that the
/// faster reaches too.
#[must_use]
pub fn at_equal_error(
    rows: &[Measured],
    scene: &str,
    fast: &str,
    slow: &str,
    floor: Option<f64>,
) -> Option<AtEqualError> {
    let rows_of = |method: &str| -> Vec<&Measured> {
        let wanted = |row: &&Measured| {
            row.scene == scene && row.method == method && row.backward_p99.is_finite()
        };
        rows.iter().filter(wanted).collect()
    };
    let (fast, slow) = (rows_of(fast), rows_of(slow));
    let quickest = |rows: &[&Measured], error: f64| {
        let exact = rows.iter().filter(|row| row.backward_p99 <= error);
        exact.map(|row| row.trace_ms).min_by(f64::total_cmp)
    };
    // The slower method, too, takes its cheapest setting for a level.
    let pairs: Vec<(f64, f64)> = slow
        .iter()
        .filter_map(|row| quickest(&slow, row.backward_p99).zip(quickest(&fast, row.backward_p99)))
        .collect();
    let range = |floor: f64| {
        let ratios = pairs
            .iter()
            .map(|(slow, fast)| (slow - floor) / (fast - floor).max(f64::MIN_POSITIVE));
        ratios.fold([f64::INFINITY, 0.0_f64], |[low, high], ratio| {
            [low.min(ratio), high.max(ratio)]
        })
    };
    let best = |rows: &[&Measured]| {
        rows.iter()
            .map(|row| row.backward_p99)
            .min_by(f64::total_cmp)
    };
    let best = best(&fast).zip(best(&slow))?;
    (!pairs.is_empty()).then(|| AtEqualError {
        scene: scene.into(),
        ratio: range(0.0),
        net_ratio: floor.map(range),
        best: best.into(),
    })
}
