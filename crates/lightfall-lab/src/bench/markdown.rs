//! The report as Markdown, for people.

use super::equal_error::at_equal_error;
use super::measurement::Measurement;
use super::pareto::is_on_front;
use crate::circumstances::Circumstances;
use crate::table::table;
use lightfall_model::numbers::{ratio, short_number};

/// The report as a Markdown table, scene by scene. Rows on the Pareto front are bold, and `auto`'s
/// row has a star.
pub fn markdown(circumstances: &Circumstances, rows: &[Measurement]) -> String {
    let cells = |row: &Measurement| {
        let mark = if is_on_front(rows, row) { "**" } else { "" };
        format!(
            "{} | {mark}{}{mark}{} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0}",
            row.scene,
            row.label(),
            if row.auto { " *" } else { "" },
            short_number(row.trace_ms),
            half_spread(row.trace_spread_ms),
            row.frame_ms.map(short_number).unwrap_or_default(),
            short_number(row.backward_p50_px),
            short_number(row.backward_p99_px),
            short_number(row.backward_p99),
            short_number(row.sky_p50),
            row.misclassified,
            row.unfinished,
            row.steps_mean,
        )
    };
    let rays = rows.first().map_or(0, |row| row.rays);
    let notes = format!(
        "\nTimes are medians; from 10 % to 90 % of them lie within +-, in ms. Errors are backward errors of {rays} rays in \
         each scene, half over its picture and half next to the shadow's edge: median (p50) and 99th percentile, in pixels \
         of the scene's own picture and in rad. Wrong class counts rays that end at the hole, the disk or the sky by \
         mistake. Steps are the mean per ray. The number after a method is its quality.step_scale or \
         quality.max_error_px; cheap, balanced and high are the article's settings, with its budgets of 128, 256 and 768 \
         steps, and all others have the scene's own. * is the method of auto; no row beats a bold one in both time and error.\n\n"
    );
    let table = table(
        "scene | method | trace ms | +- | frame ms | backward px p50 | p99 | rad p99 | sky rad p50 | \
         wrong class | unfinished | steps",
        rows.iter().map(cells),
    );
    circumstances.marked('*') + &notes + &table + &equal_errors(circumstances, rows)
}

/// Half of a spread, or nothing for a single measurement.
fn half_spread(spread_ms: f64) -> String {
    if spread_ms > 0.0 {
        short_number(0.5 * spread_ms)
    } else {
        String::new()
    }
}

/// A larger ratio only shows that the two times differ from the floor by no more than their noise.
const MAX_RATIO: f64 = 1e6;

/// A range of ratios of times. It is empty if the floor is as high as the faster method's time: then
/// nothing is left to compare.
pub fn ratio_range([low, high]: [f64; 2]) -> String {
    match (ratio(low), ratio(high)) {
        _ if !high.is_finite() || high > MAX_RATIO => String::new(),
        (low, high) if low == high => low,
        (low, high) => format!("{low} to {high}"),
    }
}

/// The methods compared at equal errors, scene by scene. Empty if they were not measured.
fn equal_errors(circumstances: &Circumstances, rows: &[Measurement]) -> String {
    let mut scenes: Vec<&str> = rows.iter().map(|row| row.scene.as_str()).collect();
    scenes.dedup();
    let pairs = [
        ("closed", "mino"),
        ("closed", "verlet"),
        ("closed", "kerr-schild"),
        ("mino", "kerr-schild"),
    ];
    let mut compared = Vec::new();
    for (fast, slow) in pairs {
        for scene in &scenes {
            if let Some(found) = at_equal_error(rows, scene, fast, slow, circumstances.floor_ms) {
                let [fastest, slowest] = found.best;
                compared.push(format!(
                    "{scene} | {fast}, {slow} | {} | {} | {} | {}",
                    ratio_range(found.ratio),
                    found.net_ratio.map(ratio_range).unwrap_or_default(),
                    short_number(slowest),
                    short_number(fastest)
                ));
            }
        }
    }
    if compared.is_empty() {
        return String::new();
    }
    let title = "\nAt equal 99th percentile, at each level that the slower method reaches with some setting:\n\n";
    let head = "scene | methods | times as fast | without the floor | best level of the slower, rad | \
                of the faster";
    title.to_owned() + &table(head, compared)
}
