//! The run times of two methods at equal errors.

use super::measurement::Measurement;

/// A fast and a slow method in a scene, compared at each error that the slow method reaches with
/// one of its settings. The error is the 99th percentile of the backward error.
#[derive(Clone, Debug, PartialEq)]
pub struct AtEqualError {
    /// Time of the slow method over the time of the fast one: minimum and maximum over these
    /// errors.
    pub ratio: [f64; 2],
    /// The same after subtracting the floor from both times, if the floor was measured.
    pub net_ratio: Option<[f64; 2]>,
    /// The smallest error of the fast and of the slow method, in radians.
    pub best: [f64; 2],
}

/// Compares the methods `fast` and `slow` in a scene. `floor` is the time of a run that only traces
/// straight lines, in milliseconds. `None` if a method was not measured or the fast one reaches
/// none of the slow one's errors.
pub fn at_equal_error(
    rows: &[Measurement],
    scene: &str,
    fast: &str,
    slow: &str,
    floor: Option<f64>,
) -> Option<AtEqualError> {
    let rows_of = |method: &str| -> Vec<&Measurement> {
        let wanted = |row: &&Measurement| {
            row.scene == scene && row.method == method && row.backward_p99.is_finite()
        };
        rows.iter().filter(wanted).collect()
    };
    let (fast, slow) = (rows_of(fast), rows_of(slow));
    let quickest = |rows: &[&Measurement], error: f64| {
        let exact = rows.iter().filter(|row| row.backward_p99 <= error);
        exact.map(|row| row.trace_ms).min_by(f64::total_cmp)
    };
    // For each error the slow method also gets its fastest setting.
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
    let best = |rows: &[&Measurement]| {
        rows.iter()
            .map(|row| row.backward_p99)
            .min_by(f64::total_cmp)
    };
    let best = best(&fast).zip(best(&slow))?;
    (!pairs.is_empty()).then(|| AtEqualError {
        ratio: range(0.0),
        net_ratio: floor.map(range),
        best: best.into(),
    })
}
