//! Tables of results, which a class can hand in: files of comma-separated values that appear whole or not
//! at all.

use lightfall_lab::circumstances::date;
use lightfall_platform::storage::{self, TextError};
use std::io::ErrorKind;
use std::path::Path;
use std::time::Duration;
use web_time::{SystemTime, UNIX_EPOCH};

/// Largest size of a file, in bytes.
pub(super) const MAX_BYTES: u64 = 8 << 20;

/// Changes the lines of a file. A new one has this header. A header that begins as that of an earlier
/// version becomes today's.
///
/// # Errors
/// The file cannot be read or written; one sentence names it.
pub(super) fn rewrite(
    file: &Path,
    [header, header_start]: [&str; 2],
    change: impl FnOnce(&mut Vec<String>),
) -> Result<(), String> {
    let mut lines = existing_lines(file, header, header_start)?;
    change(&mut lines);
    let text = lines.join("\n") + "\n";
    storage::create_parent_folder(file)
        .and_then(|()| storage::write_atomically(file, text.as_bytes()))
        .map_err(|error| error.to_string())
}

/// The lines of the file, or the header of a new one.
fn existing_lines(file: &Path, header: &str, header_start: &str) -> Result<Vec<String>, String> {
    match storage::read_text(file, MAX_BYTES) {
        Ok(text) => {
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            // Rows of an earlier version have fewer cells at their end.
            if let Some(first) = lines.first_mut().filter(|it| it.starts_with(header_start)) {
                *first = header.into();
            }
            Ok(lines)
        }
        Err(TextError::Empty) => Ok(vec![header.into()]),
        Err(TextError::Unreadable(error)) if error.kind() == ErrorKind::NotFound => {
            Ok(vec![header.into()])
        }
        Err(fault) => Err(format!("{}: {fault}", file.display())),
    }
}

/// A number as a cell: ten significant digits, which is more than any result is known to, and small and
/// large ones with an exponent. One that is infinite or no number is an empty cell, which every reader of
/// tables understands.
pub(super) fn cell(number: f64) -> String {
    if !number.is_finite() {
        return String::new();
    }
    let rounded: f64 = format!("{number:.9e}").parse().unwrap_or(number);
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

/// Signs with which a spreadsheet begins a formula, as they are typed and in full width.
const FORMULA_SIGNS: [char; 8] = ['=', '+', '-', '@', '＝', '＋', '－', '＠'];

/// A text that a user has written, as a cell of one line: in quotes where it has a comma, a semicolon or a
/// quote (RFC 4180). An apostrophe before the sign of a formula makes a spreadsheet show the text instead of
/// computing it. The text after a semicolon has its own, because some spreadsheets begin a new cell there.
pub(super) fn text_cell(text: &str) -> String {
    let printed = text.replace(char::is_control, " ");
    let parts = printed.trim().split(';').map(|part| {
        let part = part.trim();
        match part.starts_with(FORMULA_SIGNS) {
            true => format!("'{part}"),
            false => part.to_owned(),
        }
    });
    let line = parts.collect::<Vec<_>>().join("; ");
    if line.contains([',', ';', '"']) {
        format!("\"{}\"", line.replace('"', "\"\""))
    } else {
        line
    }
}

/// The text of a cell that [`text_cell`] has written.
pub(super) fn text_of_cell(cell: &str) -> String {
    let inside = cell.strip_prefix('"').and_then(|it| it.strip_suffix('"'));
    inside.map_or_else(|| cell.to_owned(), |inside| inside.replace("\"\"", "\""))
}

/// The time now, in UTC and to the second, as RFC 3339 writes it.
pub(crate) fn time_now() -> String {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    time_in_utc(now.unwrap_or_default())
}

/// A time in UTC and to the second, as RFC 3339 writes it, e.g. `2026-03-01T09:05:00Z`.
#[must_use]
pub fn time_in_utc(since_1970: Duration) -> String {
    let seconds = since_1970.as_secs() % 86_400;
    let [hours, minutes, seconds] = [seconds / 3600, seconds / 60 % 60, seconds % 60];
    format!("{}T{hours:02}:{minutes:02}:{seconds:02}Z", date(since_1970))
}
