//! The rows of a report that takes minutes, kept while it is measured: a run that is stopped leaves
//! them in a file, and the same run goes on after them.

use super::cli::ReportArgs;
use super::output::publish;
use super::stop::Stop;
use lightfall_core::reason::reason;
use lightfall_lab::circumstances::Circumstances;
use lightfall_lab::export::csv;
use lightfall_lab::import::Report;
use lightfall_platform::log::say;
use lightfall_platform::storage;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};

/// What the name of the file adds to that of the finished table.
const ENDING: &str = "csv.partial";
/// The largest file that is read.
const MAX_BYTES: u64 = 1 << 26;

/// The rows of a report, so far.
pub(super) struct KeptRows<'a, T> {
    args: &'a ReportArgs,
    /// The name of the report's files.
    name: &'static str,
    pub(super) circumstances: Circumstances,
    rows: Vec<T>,
    /// Whether it has been said that the file cannot be written.
    warned: bool,
}

impl<'a, T: Clone + Serialize + DeserializeOwned> KeptRows<'a, T> {
    /// The rows that an earlier run under the same circumstances has left in the folder of the
    /// report. It says on standard error how many there are, or why they do not count.
    pub(super) fn open(
        args: &'a ReportArgs,
        name: &'static str,
        circumstances: Circumstances,
    ) -> Self {
        let mut kept = Self {
            args,
            name,
            circumstances,
            rows: Vec::new(),
            warned: false,
        };
        if let Some(file) = kept.file() {
            match rows_in(&file, &kept.circumstances) {
                Some(rows) => kept.rows = rows,
                None => say(format_args!(
                    "lightfall: a run that is stopped leaves its rows in {}, and the same command goes on after them",
                    file.display()
                )),
            }
        }
        kept
    }

    /// The file of the rows. `None` if the report is not written to a folder.
    fn file(&self) -> Option<PathBuf> {
        let folder = self.args.out.as_ref()?;
        Some(folder.join(format!("{}.{ENDING}", self.name)))
    }

    /// The rows that are known.
    pub(super) fn rows(&self) -> Vec<T> {
        self.rows.clone()
    }

    /// Adds a row that has been measured, and writes the file.
    pub(super) fn add(&mut self, row: T) {
        self.rows.push(row);
        self.write();
    }

    /// Replaces all rows, after more has been measured about them, and writes the file.
    pub(super) fn replace(&mut self, rows: &[T]) {
        self.rows = rows.to_vec();
        self.write();
    }

    /// Writes the file, or says once that it cannot be written: the measurement goes on.
    fn write(&mut self) {
        let Some(file) = self.file() else { return };
        let text = csv(&self.circumstances, &self.rows);
        if let Err(error) = storage::write_atomically(&file, text.as_bytes())
            && !self.warned
        {
            self.warned = true;
            say(format_args!(
                "lightfall: {error}; a run that is stopped leaves no rows"
            ));
        }
    }

    /// Prints and writes the finished report of these rows, with a table of them, and removes the
    /// file.
    pub(super) fn finish(self, rows: &[T], table: &str) -> Result<(), Stop> {
        publish(
            self.args,
            self.name,
            &self.circumstances,
            rows,
            ("md", table),
        )?;
        if let Some(file) = self.file().filter(|file| storage::exists(file))
            && let Err(error) = storage::remove(&file)
        {
            say(format_args!(
                "lightfall: {}: cannot be removed: {}",
                file.display(),
                reason(&error)
            ));
        }
        Ok(())
    }
}

/// The rows in a file, if they were measured under these circumstances.
fn rows_in<T: DeserializeOwned>(file: &Path, circumstances: &Circumstances) -> Option<Vec<T>> {
    let text = storage::read_text(file, MAX_BYTES).ok()?;
    let name = file.display();
    let reason = match Report::<T>::read(&text) {
        _ if is_older_than_program(file) => "the program was built after them".into(),
        Err(error) => error,
        Ok(report) => match report.head.difference(circumstances) {
            Some(difference) => difference,
            None => {
                say(format_args!(
                    "lightfall: goes on after the {} rows that an earlier run has left in {name}",
                    report.rows.len()
                ));
                return Some(report.rows);
            }
        },
    };
    say(format_args!(
        "lightfall: starts anew: the rows in {name} do not belong to this run: {reason}"
    ));
    None
}

/// Whether the program was built after the file was written. Two builds of a changed program may
/// state the same revision.
fn is_older_than_program(file: &Path) -> bool {
    let changed = |path: &Path| path.metadata().and_then(|data| data.modified()).ok();
    let program = std::env::current_exe().ok().and_then(|path| changed(&path));
    changed(file) < program
}
