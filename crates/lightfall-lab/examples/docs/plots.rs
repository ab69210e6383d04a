//! The plots that documents show, drawn from the CSV files beside them.

use crate::measured::measured;
use lightfall_lab::bench::{Measurement, plot};

/// The CSV file of each plot, and its scene.
const SHOWN: [(&str, &str); 2] = [
    ("h200/bench", "edge-on"),
    ("h200/bench", "edge-on-spinning"),
];

/// The path of each plot, and its text.
pub fn all() -> Result<Vec<(String, String)>, String> {
    let draw = |(file, scene): (&str, &str)| {
        let report = measured::<Measurement>(file)?;
        let said = |name: &str| report.head.get(name).unwrap_or("unknown");
        let about = format!("{}, {}", said("size"), said("adapter"));
        let svg = plot(scene, &about, &report.rows)?;
        let svg = svg.ok_or_else(|| format!("{file} has no rows of {scene}"))?;
        let folder = file.split('/').next().unwrap_or(file);
        Ok((format!("docs/bench/{folder}/{scene}.svg"), svg))
    };
    SHOWN.into_iter().map(draw).collect()
}
