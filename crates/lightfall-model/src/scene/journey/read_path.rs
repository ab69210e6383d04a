//! From a camera path in CSV to a journey.

use super::Journey;
use super::camera_rows::journey_along;
use super::error::meant;
use super::row::Row;
use crate::numbers::counted;
use crate::scene::camera_path::COLUMNS;
use crate::scene::located::Located;
use crate::scene::value::quoted;
use thiserror::Error;

/// Maximum number of rows of a camera path, that of the frames of one run.
const MAX_ROWS: usize = 130_000;

/// Columns that belong together.
const GROUPS: [&[&str]; 5] = [
    &["r", "theta_deg", "phi_deg"],
    &["x", "y", "z"],
    &["yaw_deg", "pitch_deg", "roll_deg"],
    &["qw", "qx", "qy", "qz"],
    &["vx", "vy", "vz"],
];

/// Why a text is no camera path, in one sentence with the file and the line.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{origin}: {fault}")]
pub struct CameraPathError {
    origin: String,
    fault: Located<PathFault>,
}

/// What is wrong with a camera path.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub(super) enum PathFault {
    /// A column that no camera path has.
    #[error(
        "{given} is no column of a camera path; {meant}its first line names columns of {}, with commas between them",
        COLUMNS.join(",")
    )]
    UnknownColumn { given: String, meant: String },
    /// A column that is named twice.
    #[error("the column {column} is there twice")]
    Twice { column: &'static str },
    /// A column without which there is no place or no time.
    #[error("the column {missing} is missing: {wanted}")]
    MissingColumn {
        missing: &'static str,
        wanted: String,
    },
    /// A row with another number of fields.
    #[error(
        "the row has {}, and the first line names {columns} columns; commas stand between fields, and numbers \
         have decimal points",
        counted(*count, "field")
    )]
    Fields { count: usize, columns: usize },
    /// A value that its column cannot have.
    #[error("{column} = {given} is refused: it must be {allowed}")]
    Value {
        column: String,
        given: String,
        allowed: String,
    },
    /// Too few or too many rows.
    #[error(
        "a camera path is a line of column names and from 2 to {MAX_ROWS} rows below it, and this one has {}",
        counted(*count, "row")
    )]
    Rows { count: usize },
}

/// Makes a journey of a camera path in CSV. `origin` names it in messages. A path that counts frames and
/// not seconds has `fps` of them in a second.
///
/// Where a row has both, `time_s` counts and not `frame`, `r,theta_deg,phi_deg` and not `x,y,z`, and the
/// angles and not the quaternion. Without either of the last two the camera looks at the hole. Empty lines
/// and lines that begin with # are skipped.
///
/// # Errors
/// One sentence that names the file, the line, the column, what was given and what is allowed.
pub fn load_camera_path(origin: &str, text: &str, fps: f64) -> Result<Journey, CameraPathError> {
    let error = |line: Option<usize>, fault: PathFault| CameraPathError {
        origin: origin.into(),
        fault: Located { line, what: fault },
    };
    let text = text.trim_start_matches('\u{feff}');
    let lines = text.lines().enumerate();
    let mut lines = lines
        .map(|(index, line)| (index + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((first, names)) = lines.next() else {
        return Err(error(None, PathFault::Rows { count: 0 }));
    };
    let header = Header::read(names).map_err(|fault| error(Some(first), fault))?;
    let mut rows: Vec<Row> = Vec::new();
    for (line, text) in lines {
        if rows.len() == MAX_ROWS {
            let count = MAX_ROWS + 1;
            return Err(error(Some(line), PathFault::Rows { count }));
        }
        let row = Row::read(&header, (line, text), fps, rows.last());
        rows.push(row.map_err(|fault| error(Some(line), fault))?);
    }
    if rows.len() < 2 {
        let count = rows.len();
        return Err(error(None, PathFault::Rows { count }));
    }
    let by_quaternion = header.has("qw") && !header.has("yaw_deg");
    Ok(journey_along(&rows, by_quaternion))
}

/// The columns that the first line names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Header {
    columns: Vec<&'static str>,
}

impl Header {
    fn read(line: &str) -> Result<Self, PathFault> {
        let mut columns = Vec::new();
        for name in split(line) {
            let Some(column) = COLUMNS.into_iter().find(|column| *column == name) else {
                return Err(PathFault::UnknownColumn {
                    given: quoted(name),
                    meant: meant(name, &COLUMNS),
                });
            };
            if columns.contains(&column) {
                return Err(PathFault::Twice { column });
            }
            columns.push(column);
        }
        let header = Self { columns };
        header.check()?;
        Ok(header)
    }

    /// Checks that the columns give a time and a place.
    fn check(&self) -> Result<(), PathFault> {
        for group in GROUPS {
            let missing = group.iter().copied().find(|column| !self.has(column));
            if let Some(missing) = missing
                && group.iter().any(|column| self.has(column))
            {
                let wanted = format!("{} belong together", group.join(","));
                return Err(PathFault::MissingColumn { missing, wanted });
            }
        }
        if !self.has("frame") && !self.has("time_s") {
            return Err(PathFault::MissingColumn {
                missing: "time_s",
                wanted: "a camera path needs time_s, or the numbers of frames in frame".into(),
            });
        }
        if !self.has("r") && !self.has("x") {
            return Err(PathFault::MissingColumn {
                missing: "r",
                wanted: "a camera path needs r,theta_deg,phi_deg or x,y,z".into(),
            });
        }
        Ok(())
    }

    /// Whether there is a column of this name.
    pub(super) fn has(&self, column: &str) -> bool {
        self.place(column).is_some()
    }

    /// Which field of a row belongs to the column, counted from 0.
    pub(super) fn place(&self, column: &str) -> Option<usize> {
        self.columns.iter().position(|name| *name == column)
    }

    /// The fields of a row, one for each column.
    pub(super) fn fields<'a>(&self, line: &'a str) -> Result<Vec<&'a str>, PathFault> {
        let fields: Vec<&str> = split(line).collect();
        let (count, columns) = (fields.len(), self.columns.len());
        if count == columns {
            Ok(fields)
        } else {
            Err(PathFault::Fields { count, columns })
        }
    }
}

/// The fields of a line, without spaces and quotes around them.
fn split(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|field| {
        let field = field.trim();
        let inside = field.strip_prefix('"');
        let inside = inside.and_then(|inside| inside.strip_suffix('"'));
        inside.unwrap_or(field).trim()
    })
}
