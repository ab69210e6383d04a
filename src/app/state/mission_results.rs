//! What was reached in missions, as a file of comma-separated values: one row for each attempt that
//! came to its end. A class can hand the file in.

use super::result_file::{MAX_BYTES, cell, rewrite, text_cell, text_of_cell};
use lightfall_core::scene::mission::Quantity;
use lightfall_platform::storage;
use std::cmp::Ordering;
use std::path::{Path, PathBuf};

/// The columns.
const HEADER: &str = "mission,outcome,lamps,attempt,own_time,far_time,rapidity_used,par_quantity,par_reached,peak_g,\
                      peak_tide_g_per_metre,lowest_r,error,answer,is_right,time,pupil";
/// Their number. The last one, a text, may have commas.
const COLUMNS: usize = 17;
/// How every header of an earlier version begins, too.
const HEADER_START: &str = "mission,outcome,";

/// An attempt that came to its end. Times are in r_s/c, radii in r_s.
#[derive(Clone, Debug, PartialEq)]
pub struct MissionResult {
    /// The mission's name.
    pub mission: String,
    /// Whether all goals were reached.
    pub reached: bool,
    /// How many of the three lamps are lit.
    pub lamps: usize,
    /// Which attempt it was since the mission was begun.
    pub attempt: u32,
    /// The ship's own time.
    pub own_time: f64,
    /// The time far away; `None` inside the horizon.
    pub far_time: Option<f64>,
    /// The rapidity spent.
    pub rapidity_used: f64,
    /// The quantity of the mission's first par, and its value.
    pub par: Option<(Quantity, f64)>,
    /// The largest proper acceleration, in g.
    pub peak_g: f64,
    /// The largest tide, in g per metre.
    pub peak_tide: f64,
    /// The smallest radius.
    pub lowest: f64,
    /// The flight's stated error.
    pub error: f64,
    /// The last answer to the mission's question.
    pub answer: Option<f64>,
    /// Whether that answer is right.
    pub is_right: Option<bool>,
    /// When the attempt came to its end, in UTC, as RFC 3339 writes it. Empty in rows of earlier versions.
    pub time: String,
    /// Who flew. Empty if the settings name nobody.
    pub pupil: String,
}

impl MissionResult {
    /// The result as a row.
    #[must_use]
    pub fn row(&self) -> String {
        let optional = |number: Option<f64>| number.map_or(String::new(), cell);
        let outcome = if self.reached { "reached" } else { "missed" };
        [
            self.mission.clone(),
            outcome.into(),
            self.lamps.to_string(),
            self.attempt.to_string(),
            cell(self.own_time),
            optional(self.far_time),
            cell(self.rapidity_used),
            self.par
                .map_or(String::new(), |(quantity, _)| quantity.word().into()),
            optional(self.par.map(|(_, value)| value)),
            cell(self.peak_g),
            cell(self.peak_tide),
            cell(self.lowest),
            cell(self.error),
            optional(self.answer),
            self.is_right
                .map_or(String::new(), |right| right.to_string()),
            self.time.clone(),
            text_cell(&self.pupil),
        ]
        .join(",")
    }

    /// Whether it is better than another one of the same mission, whose goals were reached: it has more
    /// lamps, or as many with less rapidity.
    #[must_use]
    pub fn is_better_than(&self, other: &Self) -> bool {
        self.reached && self.rank(other) == Ordering::Less
    }

    /// Whether it is the same end of the same attempt. An answer may have been given since.
    fn is_same_end(&self, other: &Self) -> bool {
        let unanswered = |result: &Self| Self {
            answer: None,
            is_right: None,
            ..result.clone()
        };
        // As rows, for those of the file are rounded.
        unanswered(self).row() == unanswered(other).row()
    }

    /// The order of results whose goals were reached, the better one first.
    fn rank(&self, other: &Self) -> Ordering {
        let lamps = other.lamps.cmp(&self.lamps);
        lamps.then(self.rapidity_used.total_cmp(&other.rapidity_used))
    }

    /// The result of a row. `None` if it is not one.
    #[must_use]
    pub fn read(row: &str) -> Option<Self> {
        let cells: Vec<&str> = row.trim_end().splitn(COLUMNS, ',').collect();
        let number = |index: usize| cells.get(index)?.parse::<f64>().ok();
        // A value that was not finite has an empty cell.
        let measured = |index: usize| match cells.get(index) {
            Some(&"") => Some(f64::NAN),
            _ => number(index),
        };
        let par = Quantity::from_word(cells.get(7)?).zip(measured(8));
        Some(Self {
            mission: cells[0].into(),
            reached: match cells[1] {
                "reached" => true,
                "missed" => false,
                _ => return None,
            },
            lamps: cells[2].parse().ok()?,
            attempt: cells[3].parse().ok()?,
            own_time: number(4)?,
            far_time: number(5),
            rapidity_used: number(6)?,
            par,
            peak_g: measured(9)?,
            peak_tide: measured(10)?,
            lowest: measured(11)?,
            error: measured(12)?,
            answer: number(13),
            is_right: cells.get(14).and_then(|cell| cell.parse().ok()),
            time: cells.get(15).copied().unwrap_or_default().into(),
            pupil: cells.get(16).copied().map(text_of_cell).unwrap_or_default(),
        })
    }
}

/// All results, and the file that keeps them.
#[derive(Clone, Debug, Default)]
pub struct MissionResults {
    rows: Vec<MissionResult>,
    file: Option<PathBuf>,
}

impl MissionResults {
    /// The results in a file. A file that does not exist has none, and rows that are no results are
    /// passed over. `None` keeps nothing.
    #[must_use]
    pub fn load(file: Option<PathBuf>) -> Self {
        let text = file
            .as_deref()
            .map(|file| storage::read_text(file, MAX_BYTES));
        let rows = match &text {
            Some(Ok(text)) => text.lines().filter_map(MissionResult::read).collect(),
            _ => Vec::new(),
        };
        Self { rows, file }
    }

    /// The file, if there is one.
    #[must_use]
    pub fn file(&self) -> Option<&Path> {
        self.file.as_deref()
    }

    /// The best result of a mission: the one with the most lamps, and among them the one with the least
    /// rapidity. `None` if its goals were never reached.
    #[must_use]
    pub fn best(&self, mission: &str) -> Option<&MissionResult> {
        let of_it = self
            .rows
            .iter()
            .filter(|row| row.mission == mission && row.reached);
        of_it.min_by(|a, b| a.rank(b))
    }

    /// The failed attempt with the most of its par's quantity, which is this one.
    #[must_use]
    pub fn nearest_miss(&self, mission: &str, quantity: Quantity) -> Option<&MissionResult> {
        let missed = self
            .rows
            .iter()
            .filter(|row| row.mission == mission && !row.reached);
        let valued = missed.filter_map(|row| {
            let (its, value) = row.par?;
            (its == quantity && value.is_finite()).then_some((row, value))
        });
        let most = valued.max_by(|a, b| a.1.total_cmp(&b.1));
        most.map(|(row, _)| row)
    }

    /// Keeps the end of an attempt. `before` is an end of the same attempt from which the player went back.
    /// One at which the goals were reached stays unless this one is better. A miss gives way to this one,
    /// even if this one is a miss as well. Returns the one that is kept, and why the file is not written.
    pub fn keep(
        &mut self,
        before: Option<MissionResult>,
        result: MissionResult,
    ) -> (MissionResult, Result<(), String>) {
        match before {
            None => (result.clone(), self.add(result)),
            Some(before) if before.reached && !result.is_better_than(&before) => (before, Ok(())),
            Some(before) => {
                let written = self.replace(&before, result.clone());
                (result, written)
            }
        }
    }

    /// Adds a result, also to the file.
    ///
    /// # Errors
    /// The file cannot be read or written; one sentence names it.
    pub fn add(&mut self, result: MissionResult) -> Result<(), String> {
        let row = result.row();
        self.rows.push(result);
        self.rewrite(|lines| lines.push(row))
    }

    /// Replaces the last result, also in the file.
    ///
    /// # Errors
    /// As those of [`add`](Self::add).
    pub fn correct_last(&mut self, result: MissionResult) -> Result<(), String> {
        let row = result.row();
        let old = self.rows.pop().map(|old| old.row());
        self.rows.push(result);
        self.rewrite(|lines| {
            // Another window may have written since, or someone may have moved the file.
            match lines.iter().rposition(|line| Some(line) == old.as_ref()) {
                Some(index) => lines[index] = row,
                None => lines.push(row),
            }
        })
    }

    /// Replaces an earlier end of an attempt, also in the file.
    ///
    /// # Errors
    /// As those of [`add`](Self::add).
    fn replace(&mut self, old: &MissionResult, result: MissionResult) -> Result<(), String> {
        let row = result.row();
        match self.rows.iter().rposition(|kept| kept.is_same_end(old)) {
            Some(index) => self.rows[index] = result,
            None => self.rows.push(result),
        }
        let is_old =
            |line: &String| MissionResult::read(line).is_some_and(|kept| kept.is_same_end(old));
        self.rewrite(|lines| match lines.iter().rposition(is_old) {
            Some(index) => lines[index] = row,
            None => lines.push(row),
        })
    }

    /// Changes the lines of the file, if there is one.
    fn rewrite(&self, change: impl FnOnce(&mut Vec<String>)) -> Result<(), String> {
        match &self.file {
            Some(file) => rewrite(file, [HEADER, HEADER_START], change),
            None => Ok(()),
        }
    }
}
