//! The CSV files in docs/bench, and the line that says what measured one of them.

use super::lines::wrapped;
use crate::root;
use lightfall_core::reports::import::{Head, Report};
use lightfall_core::reports::sources::Sources;
use serde::de::{DeserializeOwned, IgnoredAny};
use std::fs;

/// A file below docs/bench, without its ending.
pub fn measured<T: DeserializeOwned>(file: &str) -> Report<T> {
    let path = root().join(format!("docs/bench/{file}.csv"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    Report::read(&text).unwrap_or_else(|error| panic!("{path:?}: {error}"))
}

/// The files in a folder below docs/bench whose names begin like this, without their endings.
pub fn files(folder: &str, begin: &str) -> Vec<String> {
    let entries =
        fs::read_dir(root().join("docs/bench").join(folder)).expect("the folder can be read");
    let names = entries.map(|entry| entry.expect("the folder can be listed").file_name());
    let mut found: Vec<String> = names
        .filter_map(|name| {
            let stem = name.to_str()?.strip_suffix(".csv")?;
            stem.starts_with(begin).then(|| format!("{folder}/{stem}"))
        })
        .collect();
    found.sort();
    found
}

/// The line about a file below docs/bench: machine, driver, revision and day, and whether its figures
/// are older than what they measure. `None` if there is no such file.
pub fn provenance(file: &str) -> Option<String> {
    let path = root().join(format!("docs/bench/{file}.csv"));
    let text = fs::read_to_string(path).ok()?;
    let Report::<IgnoredAny> { head, .. } = Report::read(&text).ok()?;
    Some(wrapped("", described(file, &head)?.split(' ')))
}

/// A sentence about a file with this head.
pub fn described(file: &str, head: &Head) -> Option<String> {
    let stem = file.rsplit('/').next()?;
    let report = stem.split('-').next()?;
    Sources::of(report)?;
    let known = |name: &str| head.get(name).unwrap_or("unknown");
    let day = head.get("date").map(|date| format!(", {date}"));
    let stale = is_stale(report, head)
        .then_some(", **measured before the last change of its shaders or its report**");
    Some(format!(
        "*[{stem}.csv](bench/{file}.csv): {}, {}, revision {}{}: `{}`{}.*",
        known("adapter"),
        known("driver"),
        known("commit"),
        day.unwrap_or_default(),
        known("command"),
        stale.unwrap_or_default(),
    ))
}

/// Whether the figures below this head are older than the sources of their report.
pub fn is_stale(report: &str, head: &Head) -> bool {
    let current = Sources::of(report).map(|sources| sources.fingerprint);
    head.get("sources") != current
}
