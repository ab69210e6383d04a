//! Rays in and traces out, as CSV: the language of `lightfall trace`.
//!
//! A ray is a line `er,etheta,ephi`, a looking direction on the observer's axes (outward, toward
//! growing theta, toward growing phi) of any length but zero. A trace is a line of [`HEADER`], with
//! an empty field for what there is not.

use std::fmt::Debug;
use std::io::{self, BufRead, Read, Write};

use glam::DVec3;
use thiserror::Error;

use crate::optics::trace::Trace;

/// The columns of a ray.
const COLUMNS: [&str; 3] = ["er", "etheta", "ephi"];

/// The columns of a trace.
pub const HEADER: [&str; 12] = [
    "outcome", "sky_x", "sky_y", "sky_z", "hit1_r", "hit1_phi", "hit1_g", "hit2_r", "hit2_phi",
    "hit2_g", "steps", "residual",
];

/// Most bytes a line may have: three numbers of any notation fit many times over, and a file
/// without line ends does not fill the memory.
const MAX_LINE_BYTES: u64 = 4096;

/// Why a line does not give a ray.
#[derive(Debug, Error)]
pub enum RaysError {
    /// The line does not have three values.
    #[error(
        "{name}: line {line}: \"{given}\" is refused: a ray has three values, er,etheta,ephi, and here are {count}"
    )]
    Columns {
        /// The file.
        name: String,
        /// Line, from 1.
        line: u64,
        /// What is there.
        given: String,
        /// How many values that is.
        count: usize,
    },
    /// A value is not a finite number.
    #[error("{name}: line {line}: {column} = \"{given}\" is refused: it must be a finite number")]
    Number {
        /// The file.
        name: String,
        /// Line, from 1.
        line: u64,
        /// Which of the three.
        column: &'static str,
        /// What is there.
        given: String,
    },
    /// All three values are zero.
    #[error(
        "{name}: line {line}: 0,0,0 is refused: it has no direction, and a ray may have any length but zero"
    )]
    Zero {
        /// The file.
        name: String,
        /// Line, from 1.
        line: u64,
    },
    /// The line goes on and on.
    #[error(
        "{name}: line {line} is longer than {MAX_LINE_BYTES} bytes; a ray is a line er,etheta,ephi"
    )]
    Endless {
        /// The file.
        name: String,
        /// Line, from 1.
        line: u64,
    },
    /// The file cannot be read further.
    #[error("{name}: line {line} cannot be read: {error}")]
    Read {
        /// The file.
        name: String,
        /// Line, from 1.
        line: u64,
        /// What the system says.
        error: io::Error,
    },
}

/// The rays of a file, one by one, as unit vectors. Ends after the first error.
///
/// Lines are split here and not by the `csv` crate, which takes a quote left open for a field that
/// reaches to the end of the file, however far that is.
pub struct RayReader<R> {
    reader: R,
    name: String,
    line: u64,
    header_may_come: bool,
    ended: bool,
}

impl<R: BufRead> RayReader<R> {
    /// Reads rays from `reader`, which errors call `name`.
    pub fn new(reader: R, name: impl Into<String>) -> Self {
        Self {
            reader,
            name: name.into(),
            line: 0,
            header_may_come: true,
            ended: false,
        }
    }

    /// The next line that is not blank, or none at the end.
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
                return Err(RaysError::Endless {
                    name: self.name.clone(),
                    line: self.line,
                });
            }
            let text = String::from_utf8_lossy(&bytes);
            // Spreadsheets begin their files with a byte order mark.
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
        // Divided by the largest component first: squares of 1e300 overflow, those of 1e-300
        // vanish.
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

/// What a file holds, short enough for a sentence.
fn shortened(text: &str) -> String {
    text.chars().take(40).flat_map(char::escape_debug).collect()
}

/// A value without the blanks and quotes that other programs write around it.
fn unquoted(value: &str) -> &str {
    let value = value.trim();
    value
        .strip_prefix('"')
        .and_then(|value| value.strip_suffix('"'))
        .unwrap_or(value)
}

/// Writes traces, in order, under their header.
pub struct TraceWriter<W: Write> {
    csv: csv::Writer<W>,
}

impl<W: Write> TraceWriter<W> {
    /// Starts with the header.
    ///
    /// # Errors
    /// The writer's own.
    pub fn new(writer: W) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_record(HEADER).map_err(io_error)?;
        Ok(Self { csv })
    }

    /// Writes one trace.
    ///
    /// # Errors
    /// The writer's own.
    pub fn write(&mut self, trace: &Trace) -> io::Result<()> {
        let sky = trace.sky.map(|sky| sky.to_array());
        let hits = trace.hits.map(|hit| hit.map(|hit| [hit.r, hit.phi, hit.g]));
        let numbers = [sky, hits[0], hits[1]]
            .map(|numbers| numbers.map_or_else(Default::default, |n| n.map(digits)));
        let last = [digits(trace.steps), digits(trace.residual)];
        let fields = [trace.outcome.word()].into_iter().chain(
            numbers
                .as_flattened()
                .iter()
                .chain(&last)
                .map(String::as_str),
        );
        self.csv.write_record(fields).map_err(io_error)
    }

    /// Hands on all that is written. Without it, an error of the last lines would pass unseen.
    ///
    /// # Errors
    /// The writer's own.
    pub fn finish(mut self) -> io::Result<()> {
        self.csv.flush()
    }
}

/// The writer's own error, which says whether the pipe is closed: `csv` would hide its kind.
fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}

/// The shortest digits that give the number back: Rust's `Debug` of a float.
fn digits(number: impl Debug) -> String {
    format!("{number:?}")
}

/// Whether an error says that nobody reads any more, as with `lightfall trace ... | head`: no fault
/// of ours.
pub fn is_closed_pipe(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::BrokenPipe
}
