//! Tables of results, which a class can hand in: files of comma-separated values that appear whole or not
//! at all.

use lightfall_platform::storage::{self, TextError};
use std::io::ErrorKind;
use std::path::Path;

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

/// A text as a cell: in quotes where it has a comma, a quote or a line break (RFC 4180).
pub(super) fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
