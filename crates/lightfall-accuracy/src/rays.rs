//! Rays in and traces out, as CSV: the language of `lightfall trace`.
//!
//! A ray is a line `er,etheta,ephi`, a looking direction on the observer's axes (outward, toward
//! increasing theta, toward increasing phi) of any nonzero length. A trace is a line with the
//! columns of [`HEADER`]; missing values are empty fields.

use std::fmt::Debug;
use std::io::{self, BufRead, Read, Write};

use glam::DVec3;
use serde::Serialize;
use thiserror::Error;

use crate::inspection::Inspection;
use lightfall_model::reason::reason;
use lightfall_optics::trace::{Hit, Outcome, Trace};

/// The columns of a ray.
const COLUMNS: [&str; 3] = ["er", "etheta", "ephi"];

/// The columns of a trace.
pub const HEADER: [&str; 14] = [
    "outcome", "sky_x", "sky_y", "sky_z", "hit1_r", "hit1_phi", "hit1_g", "hit2_r", "hit2_phi",
    "hit2_g", "steps", "residual", "hit1_t", "hit2_t",
];

/// The columns that [`TraceWriter::with_numbers`] adds: numbers of the f64 reference's ray, as in
/// [`Inspection`].
pub const NUMBERS: [&str; 7] = [
    "impact_parameter",
    "lambda",
    "eta",
    "deflection",
    "half_turns",
    "closest_r",
    "sky_g",
];

/// Maximum length of a line, in bytes. Three numbers in any notation need far less, and a file
/// without line ends does not fill the memory.
const MAX_LINE_BYTES: u64 = 4096;

/// Why a line does not give a ray.
#[derive(Debug, Error)]
#[error("{name}: line {line}{fault}")]
pub struct RaysError {
    name: String,
    line: u64,
    fault: Fault,
}

/// What is wrong with a line, as the end of a sentence.
#[derive(Debug, Error)]
enum Fault {
    /// The line does not have three values. The hint says what has probably gone wrong; it begins
    /// with a semicolon unless it is empty.
    #[error(
        ": \"{given}\" is refused: a ray has three values, er,etheta,ephi, and here are {count}{hint}"
    )]
    Columns {
        given: String,
        count: usize,
        hint: &'static str,
    },
    #[error(": {column} = \"{given}\" is refused: it must be a finite number")]
    Number { column: &'static str, given: String },
    #[error(": 0,0,0 is refused: it has no direction, and a ray may have any length but zero")]
    Zero,
    #[error(" is longer than {MAX_LINE_BYTES} bytes; a ray is a line er,etheta,ephi")]
    TooLong,
    #[error(" cannot be read: {}", reason(.0))]
    Read(io::Error),
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
    fn next_line(&mut self) -> Result<Option<String>, Fault> {
        let mut bytes = Vec::new();
        loop {
            self.line += 1;
            bytes.clear();
            let mut limited = self.reader.by_ref().take(MAX_LINE_BYTES);
            let count = limited.read_until(b'\n', &mut bytes).map_err(Fault::Read)?;
            if count == 0 {
                return Ok(None);
            }
            if count as u64 == MAX_LINE_BYTES && bytes.last() != Some(&b'\n') {
                return Err(Fault::TooLong);
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

    fn next_ray(&mut self) -> Result<Option<DVec3>, Fault> {
        while let Some(text) = self.next_line()? {
            let values: Vec<&str> = text.split(',').map(unquoted).collect();
            if std::mem::take(&mut self.header_may_come) && values == COLUMNS {
                continue;
            }
            return ray(&text, &values).map(Some);
        }
        Ok(None)
    }
}

impl<R: BufRead> Iterator for RayReader<R> {
    type Item = Result<DVec3, RaysError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.ended {
            return None;
        }
        let next = self.next_ray().map_err(|fault| RaysError {
            name: self.name.clone(),
            line: self.line,
            fault,
        });
        let next = next.transpose();
        self.ended = !matches!(next, Some(Ok(_)));
        next
    }
}

/// The unit vector of a line's values.
fn ray(line: &str, values: &[&str]) -> Result<DVec3, Fault> {
    if values.len() != COLUMNS.len() {
        return Err(Fault::Columns {
            given: shortened(line),
            count: values.len(),
            hint: hint(line),
        });
    }
    let mut ray = DVec3::ZERO;
    for (i, (column, text)) in COLUMNS.into_iter().zip(values).enumerate() {
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        ray[i] = number.ok_or_else(|| Fault::Number {
            column,
            given: shortened(text),
        })?;
    }
    // Dividing by the largest component first avoids overflow of large squares and underflow of
    // small ones.
    match ray.abs().max_element() {
        0.0 => Err(Fault::Zero),
        largest => Ok((ray / largest).normalize()),
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

/// A trace in the fields of `lightfall trace`.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[expect(
    missing_docs,
    reason = "`lightfall trace --help` says what each field means"
)]
pub struct Record {
    pub outcome: Outcome,
    pub sky_x: Option<f64>,
    pub sky_y: Option<f64>,
    pub sky_z: Option<f64>,
    pub hit1_r: Option<f64>,
    pub hit1_phi: Option<f64>,
    pub hit1_g: Option<f64>,
    pub hit2_r: Option<f64>,
    pub hit2_phi: Option<f64>,
    pub hit2_g: Option<f64>,
    pub steps: u32,
    pub residual: f64,
    pub hit1_t: Option<f64>,
    pub hit2_t: Option<f64>,
}

impl From<&Trace> for Record {
    fn from(trace: &Trace) -> Self {
        let [first, second] = trace.hits;
        let of = |hit: Option<Hit>, part: fn(Hit) -> f64| hit.map(part);
        Self {
            outcome: trace.outcome,
            sky_x: trace.sky.map(|sky| sky.x),
            sky_y: trace.sky.map(|sky| sky.y),
            sky_z: trace.sky.map(|sky| sky.z),
            hit1_r: of(first, |hit| hit.r),
            hit1_phi: of(first, |hit| hit.phi),
            hit1_g: of(first, |hit| hit.g),
            hit2_r: of(second, |hit| hit.r),
            hit2_phi: of(second, |hit| hit.phi),
            hit2_g: of(second, |hit| hit.g),
            steps: trace.steps,
            residual: trace.residual,
            hit1_t: first.and_then(|hit| hit.delay),
            hit2_t: second.and_then(|hit| hit.delay),
        }
    }
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

    /// As [`new`](Self::new), with the columns [`NUMBERS`] after the others.
    ///
    /// # Errors
    /// The writer's error.
    pub fn with_numbers(writer: W) -> io::Result<Self> {
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_record(HEADER.iter().chain(&NUMBERS))
            .map_err(io_error)?;
        Ok(Self { csv })
    }

    /// Writes one trace.
    ///
    /// # Errors
    /// The writer's error.
    pub fn write(&mut self, trace: &Trace) -> io::Result<()> {
        self.csv.write_record(fields(trace)).map_err(io_error)
    }

    /// Writes one trace and the numbers of its ray.
    ///
    /// # Errors
    /// The writer's error.
    pub fn write_with_numbers(&mut self, trace: &Trace, ray: &Inspection) -> io::Result<()> {
        let numbers = [
            ray.impact_parameter,
            ray.lambda,
            ray.eta,
            ray.deflection,
            Some(ray.half_turns),
            Some(ray.closest_r),
            ray.sky_g,
        ];
        let numbers = numbers.map(|value| value.map_or_else(String::new, digits));
        let line = fields(trace).into_iter().chain(numbers);
        self.csv.write_record(line).map_err(io_error)
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

/// The fields of a trace, in the order of [`HEADER`].
fn fields(trace: &Trace) -> [String; HEADER.len()] {
    let record = Record::from(trace);
    let number = |number: Option<f64>| number.map_or_else(String::new, digits);
    [
        record.outcome.word().to_owned(),
        number(record.sky_x),
        number(record.sky_y),
        number(record.sky_z),
        number(record.hit1_r),
        number(record.hit1_phi),
        number(record.hit1_g),
        number(record.hit2_r),
        number(record.hit2_phi),
        number(record.hit2_g),
        digits(record.steps),
        digits(record.residual),
        number(record.hit1_t),
        number(record.hit2_t),
    ]
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
