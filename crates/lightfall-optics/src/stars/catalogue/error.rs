//! What can be wrong with a catalogue of stars, each in one sentence.

use super::format::{COLUMNS, MAX_STARS};
use thiserror::Error;

/// Why a text is not a catalogue of stars. `origin` is its file; lines count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum CatalogueError {
    /// The header lacks a column.
    #[error(
        "{origin}: line {line}: the header has no column {column}; it needs ra_deg or ra_hours, dec_deg and v_mag, and may have b_v and name"
    )]
    Column {
        origin: String,
        line: u64,
        column: &'static str,
    },
    /// The header has no name that tells the units of its columns.
    #[error(
        "{origin}: line {line}: the header \"{given}\" is not known; call the columns ra_deg or ra_hours, dec_deg, v_mag, b_v and name (the headers of the HYG database and of Gaia's archive are read as they are)"
    )]
    Header {
        origin: String,
        line: u64,
        given: String,
    },
    /// A field has a value that it cannot have.
    #[error("{origin}: line {line}: {column} = \"{given}\" is refused: it must be {allowed}")]
    Field {
        origin: String,
        line: u64,
        column: &'static str,
        given: String,
        allowed: String,
    },
    /// A field goes on in the next line: its quotation mark is not closed.
    #[error(
        "{origin}: line {line}: a quotation mark is not closed: \"{given}\"; a field ends in the line in which it begins"
    )]
    Quote {
        origin: String,
        line: u64,
        given: String,
    },
    /// There are more stars than a catalogue may have.
    #[error(
        "{origin}: line {line} is one star too many: a catalogue has at most {MAX_STARS} stars"
    )]
    TooMany { origin: String, line: u64 },
    /// There is no star.
    #[error(
        "{origin} has no star; a star is a line {}, the last two of which may be left out",
        COLUMNS.join(",")
    )]
    Empty { origin: String },
    /// The text cannot be split into fields.
    #[error("{origin} cannot be read as CSV: {reason}")]
    NotCsv { origin: String, reason: String },
}

/// A text, shortened for an error message.
pub(super) fn shortened(text: &str) -> String {
    text.chars().take(40).flat_map(char::escape_debug).collect()
}
