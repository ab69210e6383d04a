//! The circumstances of a measurement.

use super::numbers::short_number;
use serde::Serialize;

/// The circumstances under which a report was made.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Circumstances {
    /// Name of the graphics adapter.
    pub adapter: String,
    /// Name and version of its driver.
    pub driver: String,
    /// The graphics interface.
    pub backend: String,
    /// Size of the picture whose rays are timed.
    pub size: String,
    /// Entry point of the shader that is timed.
    pub entry: String,
    /// Revision of the program.
    pub commit: String,
    /// Time of a run that only traces straight lines, in milliseconds, in reports of times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub floor_ms: Option<f64>,
    /// The command line that made the report.
    pub command: String,
}

impl Circumstances {
    /// Name and value of each.
    pub(super) fn lines(&self) -> impl Iterator<Item = (&'static str, String)> {
        let floor = self
            .floor_ms
            .map(|floor| format!("{} (straight lines without a disk)", short_number(floor)));
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
