//! The circumstances of a measurement.

use lightfall_model::numbers::short_number;
use serde::Serialize;
use std::time::Duration;

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
    /// The day on which the measurement ended, in universal time, as [`date`] writes it.
    pub date: String,
    /// Time of a run that only traces straight lines, in milliseconds, in reports of times.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub floor_ms: Option<f64>,
    /// The command line that made the report.
    pub command: String,
}

impl Circumstances {
    /// Name and value of each.
    fn lines(&self) -> impl Iterator<Item = (&'static str, String)> {
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
            ("date", Some(self.date.clone())),
            ("floor_ms", floor),
            ("command", Some(self.command.clone())),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
    }

    /// The circumstances as lines that begin with this mark.
    pub(super) fn marked(&self, mark: char) -> String {
        let lines = self.lines();
        lines
            .map(|(name, value)| format!("{mark} {name}: {value}\n"))
            .collect()
    }

    /// The measurement and the machine, for the caption of a plot.
    pub fn about(&self) -> String {
        format!("{}, {}", self.size, self.adapter)
    }

    /// The circumstances that a later run must share to continue this one: all but the day, and the
    /// floor, which is measured last.
    pub(super) fn conditions(&self) -> impl Iterator<Item = (&'static str, String)> {
        self.lines()
            .filter(|(name, _)| !matches!(*name, "date" | "floor_ms"))
    }
}

/// The day, as in 2026-02-28, of a time since the beginning of 1970, in universal time.
pub fn date(since_1970: Duration) -> String {
    // Days are counted from 1 March of the year 0: a leap day then ends a year, and 153 days are
    // five months (Hinnant, "chrono-compatible low-level date algorithms", civil_from_days).
    let days = since_1970.as_secs() / 86_400 + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = (month_from_march + 2) % 12 + 1;
    let year = 400 * era + year_of_era + u64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}
