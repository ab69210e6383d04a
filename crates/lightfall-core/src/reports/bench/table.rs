//! The report as CSV and JSON for programs, as Markdown for people.

use super::{Measured, at_equal_error, is_on_front};
use serde::Serialize;
use std::fmt::Write;

/// Under which circumstances a report was made.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Circumstances {
    /// The graphics adapter.
    pub adapter: String,
    /// Its driver and that one's version.
    pub driver: String,
    /// The graphics interface.
    pub backend: String,
    /// Size of the picture whose rays are timed.
    pub size: String,
    /// Entry of the shader that is timed.
    pub entry: String,
    /// Revision of the program.
    pub commit: String,
    /// Where times are measured: that of a run which traces straight lines and nothing else, in
    /// milliseconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub floor_ms: Option<f64>,
    /// The command that made the report.
    pub command: String,
}

impl Circumstances {
    /// Name and value of each.
    fn lines(&self) -> impl Iterator<Item = (&'static str, String)> {
        let floor = self
            .floor_ms
            .map(|floor| format!("{} (straight lines without a disk)", short(floor)));
        [
            ("adapter", Some(self.adapter.clone())),
            ("driver", Some(self.driver.clone())),
            ("backend", Some(self.backend.clone())),
            ("size", Some(self.size.clone())),
            ("entry", Some(self.entry.clone())),
            ("commit", Some(self.commit.clone())),
            ("floor_ms", floor),
            ("command", Some(self.command.clone())),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
    }
}

/// Everything, one line a row, under a header and, before that, the circumstances in lines that
/// begin with #.
#[must_use]
pub fn csv(circumstances: &Circumstances, rows: &[impl Serialize]) -> String {
    let mut text = String::new();
    for (name, value) in circumstances.lines() {
        writeln!(text, "# {name}: {value}").expect("writing to a string cannot fail");
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let flat = rows
        .iter()
        .map(|row| serde_json::to_value(row).unwrap_or_default());
    for (i, row) in flat.enumerate() {
        let mut fields = Vec::new();
        for (key, value) in row.as_object().into_iter().flatten() {
            flatten(key, value, &mut fields);
        }
        if i == 0 {
            writer
                .write_record(fields.iter().map(|(key, _)| key))
                .expect("writing to a vector cannot fail");
        }
        writer
            .write_record(fields.iter().map(|(_, value)| value))
            .expect("writing to a vector cannot fail");
    }
    text + &String::from_utf8_lossy(&writer.into_inner().unwrap_or_default())
}

/// A field's name and value as text; a list gives one field an element.
fn flatten(key: &str, value: &serde_json::Value, fields: &mut Vec<(String, String)>) {
    match value {
        serde_json::Value::Array(values) => {
            for (i, value) in values.iter().enumerate() {
                flatten(
                    &format!(
                        "{key}_{}",
                        ["sky", "captured", "unfinished"].get(i).unwrap_or(&"more")
                    ),
                    value,
                    fields,
                );
            }
        }
        serde_json::Value::Null => fields.push((key.into(), String::new())),
        serde_json::Value::String(text) => fields.push((key.into(), text.clone())),
        other => fields.push((key.into(), other.to_string())),
    }
}

/// Everything, with the circumstances. What is infinite or no number is null.
#[must_use]
pub fn json(circumstances: &Circumstances, rows: &[impl Serialize]) -> String {
    let whole = serde_json::json!({ "circumstances": circumstances, "rows": rows });
    serde_json::to_string_pretty(&whole).unwrap_or_default() + "\n"
}

/// The rows that matter to a reader, scene by scene; those on the front are in bold, auto's has a
/// star.
#[must_use]
pub fn markdown(circumstances: &Circumstances, rows: &[Measured]) -> String {
    let mut text = String::new();
    for (name, value) in circumstances.lines() {
        writeln!(text, "* {name}: {value}").expect("writing to a string cannot fail");
    }
    text += "\n| scene | method | trace ms | +- | frame ms | backward px p50 | p99 | rad p99 | sky rad p50 | wrong class | unfinished | steps |\n";
    text += "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for row in rows {
        let mark = if is_on_front(rows, row) { "**" } else { "" };
        writeln!(
            text,
            "| {} | {mark}{}{mark}{} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.0} |",
            row.scene,
            row.label(),
            if row.auto { " *" } else { "" },
            short(row.trace_ms),
            short(row.trace_spread_ms),
            row.frame_ms.map(short).unwrap_or_default(),
            short(row.backward_p50_px),
            short(row.backward_p99_px),
            short(row.backward_p99),
            short(row.sky_p50),
            row.misclassified,
            row.unfinished,
            row.steps_mean,
        )
        .expect("writing to a string cannot fail");
    }
    text + &equal_errors(circumstances, rows)
}

/// Ratios beyond this are what is left of two times that are equal but for their noise.
const MAX_RATIO: f64 = 1e6;

/// Our methods against the article's, scene by scene, where they are equally exact; nothing where
/// they were not measured.
fn equal_errors(circumstances: &Circumstances, rows: &[Measured]) -> String {
    let mut scenes: Vec<&str> = rows.iter().map(|row| row.scene.as_str()).collect();
    scenes.dedup();
    let mut text = String::new();
    for (fast, slow) in [("closed", "verlet"), ("mino", "kerr-schild")] {
        for scene in &scenes {
            let Some(found) = at_equal_error(rows, scene, fast, slow, circumstances.floor_ms)
            else {
                continue;
            };
            let range = |[low, high]: [f64; 2]| match (format!("{low:.1}"), format!("{high:.1}")) {
                // A floor as high as the faster method's time leaves nothing to compare.
                _ if !high.is_finite() || high > MAX_RATIO => String::new(),
                (low, high) if low == high => low,
                (low, high) => format!("{low} to {high}"),
            };
            let [ours, theirs] = found.best;
            writeln!(
                text,
                "| {scene} | {fast}, {slow} | {} | {} | {} | {} |",
                range(found.ratio),
                found.net_ratio.map(range).unwrap_or_default(),
                short(theirs),
                short(ours)
            )
            .expect("writing to a string cannot fail");
        }
    }
    if text.is_empty() {
        return text;
    }
    "\nAt equal 99th percentile, at each level that the slower method reaches with some setting:\n\n\
     | scene | methods | times as fast | without the floor | best level of the slower, rad | of the faster |\n\
     |---|---|---|---|---|---|\n"
        .to_owned()
        + &text
}

/// A number to two or three digits.
#[must_use]
pub fn short(number: f64) -> String {
    match number {
        _ if number.is_nan() => String::new(),
        _ if number.is_infinite() => "no bound".into(),
        0.0 => "0".into(),
        _ if (0.01..1000.0).contains(&number.abs()) => {
            let digits = (2 - number.abs().log10().floor() as i32).max(0) as usize;
            format!("{number:.digits$}")
        }
        _ => format!("{number:.1e}"),
    }
}
