//! Rays in and traces out, as CSV: the language of `lightfall trace`.
//!
//! A ray is a line `er,etheta,ephi`, a looking direction on the observer's axes (outward, toward
//! increasing theta, toward increasing phi) of any nonzero length. A trace is a line with the
//! columns of [`HEADER`]; missing values are empty fields.

use std::fmt::Debug;
use std::io::{self, BufRead, Read, Write};

use glam::DVec3;
use thiserror::Error;

use lightfall_optics::trace::{Hit, Trace};

/// The columns of a ray.
const COLUMNS: [&str; 3] = ["er", "etheta", "ephi"];

/// The columns of a trace.
pub const HEADER: [&str; 14] = [
    "outcome", "sky_x", "sky_y", "sky_z", "hit1_r", "hit1_phi", "hit1_g", "hit2_r", "hit2_phi",
    "hit2_g", "steps", "residual", "hit1_t", "hit2_t",
];

/// Maximum length of a line, in bytes. Three numbers in any notation need far less, and a file
/// without line ends does not fill the memory.
const MAX_LINE_BYTES: u64 = 4096;

/// Why a line does not give a ray.
#[derive(Debug, Error)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum RaysError {
    /// The line does not have three values.
    #[error(
        "{name}: line {line}: \"{given}\" is refused: a ray has three values, er,etheta,ephi, and here are {count}{hint}"
    )]
    Columns {
        name: String,
        line: u64,
        given: String,
        count: usize,
        /// What has probably gone wrong; begins with a semicolon unless it is empty.
        hint: &'static str,
    },
    /// A value is not a finite number.
    #[error("{name}: line {line}: {column} = \"{given}\" is refused: it must be a finite number")]
    Number {
        name: String,
        line: u64,
        column: &'static str,
        given: String,
    },
    /// All three values are zero.
    #[error(
        "{name}: line {line}: 0,0,0 is refused: it has no direction, and a ray may have any length but zero"
    )]
    Zero { name: String, line: u64 },
    /// The line is longer than any ray.
    #[error(
        "{name}: line {line} is longer than {MAX_LINE_BYTES} bytes; a ray is a line er,etheta,ephi"
    )]
    TooLong { name: String, line: u64 },
    /// The file cannot be read any further.
    #[error("{name}: line {line} cannot be read: {error}")]
    Read {
        name: String,
        line: u64,
        error: io::Error,
    },
}

/// An iterator over the rays of a file, as unit vectors. It ends after the first error.
///
/// Lines are not split by the `csv` crate because it takes an unclosed quote as a field that
/// extends to the end of the file, however long that is.
pub struct RayReader<R> {
    reader: R,
    name: String,
    line: u64,
    header_may_come: bool,
    ended: bool,
}

impl<R: BufRead> RayReader<R> {
    /// Reads rays from `reader`. Errors call it `name`.
    pub fn new(reader: R, name: impl Into<String>) -> Self {
        Self {
            reader,
            name: name.into(),
            line: 0,
            header_may_come: true,
            ended: false,
        }
    }

    /// The next line that is not blank, or `None` at the end.
    fn next_line(&mut self) -> Result<Option<String>, RaysError> {
        let mut bytes = Vec::new();
        loop {
            self.line += 1;
            bytes.clear();
            let read = self
                .reader
                .by_ref()
                .take(MAX_LINE_BYTES)
                .read_until(b'\n', &mut bytes);
            let count = read.map_err(|error| RaysError::Read {
                name: self.name.clone(),
                line: self.line,
                error,
            })?;
            if count == 0 {
                return Ok(None);
            }
            if count as u64 == MAX_LINE_BYTES && bytes.last() != Some(&b'\n') {
                return Err(RaysError::TooLong {
                    name: self.name.clone(),
                    line: self.line,
                });
            }
            let text = String::from_utf8_lossy(&bytes);
            // Spreadsheet programs write a byte order mark at the start.
            let text = if self.line == 1 {
                text.trim_start_matches('\u{feff}')
            } else {
                &text
            };
            if !text.trim().is_empty() {
                return Ok(Some(text.trim().to_owned()));
            }
        }
    }

    fn next_ray(&mut self) -> Result<Option<DVec3>, RaysError> {
        while let Some(text) = self.next_line()? {
            let values: Vec<&str> = text.split(',').map(unquoted).collect();
            if std::mem::take(&mut self.header_may_come) && values == COLUMNS {
                continue;
            }
            return self.ray(&text, &values).map(Some);
        }
        Ok(None)
    }

    fn ray(&self, text: &str, values: &[&str]) -> Result<DVec3, RaysError> {
        let (name, line) = (|| self.name.clone(), self.line);
        if values.len() != COLUMNS.len() {
            return Err(RaysError::Columns {
                name: name(),
                line,
                given: shortened(text),
                count: values.len(),
                hint: hint(text),
            });
        }
        let mut ray = DVec3::ZERO;
        for (i, (column, text)) in COLUMNS.into_iter().zip(values).enumerate() {
            ray[i] = text
                .parse()
                .ok()
                .filter(|number: &f64| number.is_finite())
                .ok_or_else(|| RaysError::Number {
                    name: name(),
                    line,
                    column,
                    given: shortened(text),
                })?;
        }
        // Dividing by the largest component first avoids overflow of large squares and underflow of
        // small ones.
        match ray.abs().max_element() {
            0.0 => Err(RaysError::Zero { name: name(), line }),
            largest => Ok((ray / largest).normalize()),
        }
    }
}

impl<R: BufRead> Iterator for RayReader<R> {
    type Item = Result<DVec3, RaysError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let next = self.next_ray().transpose();
        self.ended = !matches!(next, Some(Ok(_)));
        next
    }
}

/// What has probably gone wrong with a line that does not have three values.
fn hint(text: &str) -> &'static str {
    if text.contains(';') {
        "; write commas between the values, and points in decimals"
    } else if unquoted(text).parse::<f64>().is_ok() {
        "; PowerShell splits an unquoted 0,-0.1,1 into lines: put it in quotes"
    } else {
        ""
    }
}

/// A text, shortened for an error message.
fn shortened(text: &str) -> String {
    text.chars().take(40).flat_map(char::escape_debug).collect()
}

/// A value without the surrounding blanks and quotes that other programs write.
fn unquoted(value: &str) -> &str {
    let value = value.trim();
    value
        .strip_prefix('"')
        .and_then(|value| value.strip_suffix('"'))
        .unwrap_or(value)
}

/// Writes a header and traces as CSV.
pub struct TraceWriter<W: Write> {
    csv: csv::Writer<W>,
}

impl<W: Write> TraceWriter<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// The writer's error.
    pub fn new(writer: W) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_record(HEADER).map_err(io_error)?;
        Ok(Self { csv })
    }

    /// Writes one trace.
    ///
    /// # Errors
    /// The writer's error.
    pub fn write(&mut self, trace: &Trace) -> io::Result<()> {
        let sky = trace.sky.map(|sky| sky.to_array());
        let hits = trace.hits.map(|hit| hit.map(|hit| [hit.r, hit.phi, hit.g]));
        let numbers = [sky, hits[0], hits[1]]
            .map(|numbers| numbers.map_or_else(Default::default, |n| n.map(digits)));
        let delay = |hit: Option<Hit>| {
            hit.and_then(|hit| hit.delay)
                .map_or_else(String::new, digits)
        };
        let last = [
            digits(trace.steps),
            digits(trace.residual),
            delay(trace.hits[0]),
            delay(trace.hits[1]),
        ];
        let fields = [trace.outcome.word()].into_iter().chain(
            numbers
                .as_flattened()
                .iter()
                .chain(&last)
                .map(String::as_str),
        );
        self.csv.write_record(fields).map_err(io_error)
    }

    /// Writes everything that is still buffered. Without this call, an error in the last lines
    /// would go unnoticed.
    ///
    /// # Errors
    /// The writer's error.
    pub fn finish(mut self) -> io::Result<()> {
        self.csv.flush()
    }
}

/// The writer's error with its kind, which says whether the pipe is closed. `csv` would hide it.
fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// The shortest digits that read back as the same number: Rust's `Debug` of a float.
fn digits(number: impl Debug) -> String {
    format!("{number:?}")
}

/// Whether an error says that the reader has closed the pipe, as in `lightfall trace ... | head`.
pub fn is_closed_pipe(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::BrokenPipe
}
