//! A report of `lightfall bench` that grows row by row, keeps its rows while it is measured, and says
//! how long the rest takes.

use crate::commands::cli::BenchArgs;
use crate::commands::kept_rows::KeptRows;
use crate::commands::output::{print, write_tables};
use crate::commands::progress::Progress;
use crate::commands::stop::Stop;
use lightfall_lab::circumstances::Circumstances;
use lightfall_lab::export::{csv, json};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Share of the work after which the time of the rest is estimated.
const SAMPLE_SHARE: f64 = 0.1;

/// A report while it is measured.
pub(super) struct RowReport<'a, T> {
    args: &'a BenchArgs,
    name: &'static str,
    circumstances: Circumstances,
    kept: KeptRows<T>,
    progress: Progress,
}

impl<'a, T: Clone + Serialize + DeserializeOwned> RowReport<'a, T> {
    /// Begins a report. `name` is that of its files, and `left` the work, in any unit, that is left
    /// after so many rows, which an earlier run has measured.
    pub(super) fn begin(
        args: &'a BenchArgs,
        name: &'static str,
        circumstances: Circumstances,
        left: impl Fn(usize) -> f64,
    ) -> Self {
        let kept = KeptRows::open(args.out.as_deref(), name, &circumstances);
        let work = left(kept.rows().len());
        Self {
            args,
            name,
            circumstances,
            kept,
            progress: Progress::new("bench", work, SAMPLE_SHARE * work),
        }
    }

    /// Begins a report of so many rows, each of which is one unit of work.
    pub(super) fn of_rows(
        args: &'a BenchArgs,
        name: &'static str,
        circumstances: Circumstances,
        rows: usize,
    ) -> Self {
        let left = |known| rows.saturating_sub(known) as f64;
        Self::begin(args, name, circumstances, left)
    }

    /// The rows that are known.
    pub(super) fn rows(&self) -> Vec<T> {
        self.kept.rows()
    }

    /// Keeps rows that have been measured.
    pub(super) fn keep(&mut self, rows: impl IntoIterator<Item = T>) {
        for row in rows {
            self.kept.add(row);
        }
    }

    /// Keeps a row that has been measured and counts it. `task` says what it is.
    pub(super) fn add(&mut self, row: &T, task: String) {
        self.keep([row.clone()]);
        self.advance(task, 1.0);
    }

    /// Counts work that has been done, and says what it was.
    pub(super) fn advance(&mut self, task: String, work: f64) {
        self.progress.set_task(task);
        self.progress.advance(work);
    }

    /// Prints and writes the complete report.
    pub(super) fn finish(self, rows: &[T], table: &str) -> Result<(), Stop> {
        self.progress.finish();
        let json = json(&self.circumstances, rows);
        if let Some(folder) = &self.args.out {
            let csv = csv(&self.circumstances, rows);
            write_tables(folder, self.name, [&csv, &json, table])?;
        }
        self.kept.remove();
        print(if self.args.json { &json } else { table })
    }
}
