//! The CSV files in docs/bench, and the line that says what measured one of them.

use lightfall_lab::import::Report;
use serde::de::{DeserializeOwned, IgnoredAny};
use std::fs;

/// The largest number of columns of a line of prose.
const WIDTH: usize = 100;

/// A file below docs/bench, without its ending.
pub fn measured<T: DeserializeOwned>(file: &str) -> Result<Report<T>, String> {
    let path = format!("docs/bench/{file}.csv");
    let text = fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    Report::read(&text).map_err(|error| format!("{path}: {error}"))
}

/// The files in a folder below docs/bench whose names begin like this, without their endings.
pub fn files(folder: &str, begin: &str) -> Result<Vec<String>, String> {
    let path = format!("docs/bench/{folder}");
    let entries = fs::read_dir(&path).map_err(|error| format!("{path}: {error}"))?;
    let mut found: Vec<String> = entries
        .filter_map(|entry| {
            let name = entry.ok()?.file_name();
            let stem = name.to_str()?.strip_suffix(".csv")?;
            stem.starts_with(begin).then(|| format!("{folder}/{stem}"))
        })
        .collect();
    found.sort();
    Ok(found)
}

/// The line about a file below docs/bench: machine, driver, revision, day and command.
pub fn provenance(file: &str) -> Result<String, String> {
    let head = measured::<IgnoredAny>(file)?.head;
    let stem = file.rsplit('/').next().unwrap_or(file);
    let known = |name: &str| head.get(name).unwrap_or("unknown");
    Ok(wrapped(&format!(
        "*[{stem}.csv](bench/{file}.csv): {}, {}, revision {}, {}: `{}`.*",
        known("adapter"),
        known("driver"),
        known("commit"),
        known("date"),
        known("command"),
    )))
}

/// The words of a paragraph in lines of at most [`WIDTH`] columns, as far as they allow.
fn wrapped(text: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= WIDTH => {
                *line += " ";
                *line += word;
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.join("\n")
}
