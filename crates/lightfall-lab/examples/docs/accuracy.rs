//! docs/ACCURACY.md.

use crate::bench::Bench;
use crate::measured::measured;
use crate::render::{count, ratio, short, table as markdown};
use lightfall_lab::bench::{
    DelayMeasurement, FlightMeasurement, LightMeasurement, MediumMeasurement, PictureMeasurement,
    RefinementMeasurement, flight_table, light_table, medium_table, pictures_table, ratio_range,
};

/// The scenes whose delays and whose light are shown.
const SHOWN: [&str; 4] = ["edge-on", "above", "extremal", "edge-on-spinning"];

/// Errors and times of `auto`, and its errors on Mesa's driver.
pub fn auto() -> Result<String, String> {
    let (card, mesa) = (Bench::read("h200/bench")?, Bench::read("llvmpipe/bench")?);
    let rows = card.of_auto().map(|row| {
        let on_mesa = |of: fn(&_) -> f64| {
            let same = mesa.own(&row.scene, &row.method);
            same.map_or_else(String::new, |row| short(of(row)))
        };
        vec![
            row.scene.clone(),
            short(row.trace_ms),
            row.frame_ms.map(short).unwrap_or_default(),
            short(row.backward_p50_px),
            short(row.backward_p99_px),
            short(row.backward_p99),
            short(row.backward_max),
            row.misclassified.to_string(),
            on_mesa(|row| row.backward_p99),
            on_mesa(|row| row.backward_max),
        ]
    });
    Ok(markdown(
        "scene | trace ms | frame ms | pixels, median | 99 % | rad, 99 % | largest | wrong class | \
         Mesa: rad, 99 % | largest",
        rows,
    ))
}

/// The other methods at their usual settings, against `closed`.
pub fn others() -> Result<String, String> {
    let bench = Bench::read("h200/bench")?;
    let rows = bench.of_auto().map(|closed| {
        let cells = ["mino", "verlet", "kerr-schild"].map(|method| {
            let Some(own) = bench.own(&closed.scene, method) else {
                return [const { String::new() }; 3];
            };
            let equal = bench.times_as_fast(&closed.scene, method);
            [
                ratio(own.trace_ms / closed.trace_ms),
                short(own.backward_p99),
                equal.map_or_else(|| "none".into(), ratio_range),
            ]
        });
        [vec![closed.scene.clone()], cells.concat()].concat()
    });
    Ok(markdown(
        "scene | mino: time | rad, 99 % | at equal error | verlet: time | rad, 99 % | at equal error | \
         kerr-schild: time | rad, 99 % | at equal error",
        rows,
    ))
}

/// Where each series of refinements begins and what it reaches.
pub fn refine() -> Result<String, String> {
    let rows = measured::<RefinementMeasurement>("llvmpipe/refine")?.rows;
    let key = |row: &RefinementMeasurement| (row.scene.clone(), row.method.clone(), row.study);
    let series = rows.chunk_by(|a, b| key(a) == key(b));
    let rows = series.filter_map(|series| {
        let first = series.first()?;
        let best = series
            .iter()
            .min_by(|a, b| a.backward_p99.total_cmp(&b.backward_p99))?;
        let last = series.last()?;
        let mut cells = vec![
            first.scene.clone(),
            first.method.clone(),
            first.study.word().into(),
        ];
        for row in [first, best] {
            cells.extend([row.label(), short(row.backward_p99_px), steps(row)]);
        }
        cells.extend([last.label(), count(last.unfinished)]);
        Some(cells)
    });
    Ok(markdown(
        "scene | method | series | from | pixels, 99 % | steps | best at | pixels, 99 % | steps | to | \
         given up there",
        rows,
    ))
}

fn steps(row: &RefinementMeasurement) -> String {
    count(row.steps_mean.round() as usize)
}

/// The delays with the nodes that pictures use.
pub fn delay() -> Result<String, String> {
    let rows = measured::<DelayMeasurement>("h200-living/delay")?.rows;
    let own = rows
        .iter()
        .filter(|row| row.own && SHOWN.contains(&row.scene.as_str()));
    Ok(markdown(
        "scene | method | time over none | error, r_s/c, median | 99 % | largest | turn of the matter, rad, 99 % | largest",
        own.map(|row| {
            let mut cells = vec![
                row.scene.clone(),
                row.method.clone(),
                ratio(row.time_over_none(&rows)),
            ];
            cells.extend(row.errors().map(short));
            cells
        }),
    ))
}

pub fn light() -> Result<String, String> {
    let mut rows = measured::<LightMeasurement>("h200-living/light")?.rows;
    let shown = |row: &LightMeasurement| ["closed", "mino"].contains(&row.method.as_str());
    rows.retain(|row| shown(row) && SHOWN.contains(&row.scene.as_str()));
    Ok(light_table(&rows))
}

/// The light of matter with depth.
pub fn medium() -> Result<String, String> {
    let rows = measured::<MediumMeasurement>("h200/medium")?.rows;
    Ok(medium_table(&rows))
}

/// The flight of a ship.
pub fn flight() -> Result<String, String> {
    let rows = measured::<FlightMeasurement>("processor/flight")?.rows;
    Ok(flight_table(&rows))
}

pub fn pictures() -> Result<String, String> {
    let mut rows = measured::<PictureMeasurement>("h200-pictures/pictures")?.rows;
    rows.retain(|row| row.scene == "edge-on-spinning");
    Ok(pictures_table(&rows))
}
