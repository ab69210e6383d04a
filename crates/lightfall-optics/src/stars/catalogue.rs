//! A catalogue of stars: the built-in one, and those of users.

mod error;
mod format;

pub use error::CatalogueError;
pub use format::{MAX_NAME_CHARS, MAX_STARS};

use super::frame::celestial_direction;
use super::photometry::{SOLAR_B_V, Star, temperature_from_b_v};
use csv::{ByteRecord, ReaderBuilder, Trim};
use format::COLUMNS;
use std::borrow::Cow;
use std::sync::LazyLock;

/// The catalogue that the program brings along. The notice next to it names the source.
const BUILT_IN: &str = include_str!("../../../../assets/sky/stars.csv");

/// A star with a name, for labels.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedStar {
    /// Its proper name.
    pub name: String,
    /// The star, which the catalogue's list has too.
    pub star: Star,
}

/// A catalogue of stars, brightest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Catalogue {
    stars: Vec<Star>,
    names: Vec<NamedStar>,
}

impl Catalogue {
    /// The stars of the Bright Star Catalogue, complete to about V = 6. It is read at the first
    /// call.
    pub fn built_in() -> &'static Self {
        &BRIGHT_STARS
    }

    /// Reads a catalogue from CSV, as UTF-8. Errors call it `origin`.
    ///
    /// Each line is a star: right ascension and declination (J2000, degrees), V, and, where they
    /// are known, B-V and a name. A star without B-V has the colour of the Sun; B-V outside -0.4 to
    /// 2.5 counts as the nearer of the two. A header with the names `ra_deg`, `dec_deg`, `v_mag`,
    /// `b_v` and `name` may give another order and columns beside these, which are not read. Lines
    /// that begin with # are comments.
    ///
    /// # Errors
    /// A column is missing, a field has a value that it cannot have, or there are no stars or more
    /// than [`MAX_STARS`].
    pub fn from_csv(origin: &str, text: &[u8]) -> Result<Self, CatalogueError> {
        // Spreadsheet programs write a byte order mark at the start.
        let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        let mut csv = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .trim(Trim::All)
            .from_reader(text);
        let mut places: [Option<usize>; 5] = std::array::from_fn(Some);
        let mut record = ByteRecord::new();
        let (mut stars, mut names) = (Vec::new(), Vec::new());
        let mut header_may_come = true;
        loop {
            let more =
                csv.read_byte_record(&mut record)
                    .map_err(|error| CatalogueError::NotCsv {
                        origin: origin.to_owned(),
                        reason: error.to_string(),
                    })?;
            if !more {
                break;
            }
            if record.len() == 1 && record[0].is_empty() {
                continue;
            }
            let row = Row {
                origin,
                text,
                record: &record,
                places,
            };
            row.check_separator()?;
            if std::mem::take(&mut header_may_come) && row.is_header() {
                places = row.places_of_columns()?;
                continue;
            }
            if stars.len() == MAX_STARS {
                let (origin, line) = (origin.to_owned(), row.line());
                return Err(CatalogueError::TooMany { origin, line });
            }
            let star = row.star()?;
            stars.push(star);
            if let Some(name) = row.name()? {
                names.push(NamedStar { name, star });
            }
        }
        if stars.is_empty() {
            let origin = origin.to_owned();
            return Err(CatalogueError::Empty { origin });
        }
        stars.sort_by(|a, b| a.magnitude.total_cmp(&b.magnitude));
        names.sort_by(|a, b| a.star.magnitude.total_cmp(&b.star.magnitude));
        Ok(Self { stars, names })
    }

    /// The stars, brightest first.
    pub fn stars(&self) -> &[Star] {
        &self.stars
    }

    /// The stars that have a name, brightest first.
    pub fn names(&self) -> &[NamedStar] {
        &self.names
    }

    /// The number of stars that are brighter than `magnitude` or as bright.
    pub fn count(&self, magnitude: f64) -> usize {
        self.stars
            .partition_point(|star| star.magnitude <= magnitude as f32)
    }
}

struct Row<'a> {
    origin: &'a str,
    text: &'a [u8],
    record: &'a ByteRecord,
    /// Where each of [`COLUMNS`] is.
    places: [Option<usize>; 5],
}

impl Row<'_> {
    /// The number of the line, from 1. The CSV reader has that of the blank lines and comments
    /// before it.
    fn line(&self) -> u64 {
        let Some(position) = self.record.position() else {
            return 0;
        };
        let rest = self
            .text
            .get(position.byte() as usize..)
            .unwrap_or_default();
        let skipped = rest
            .split(|byte| *byte == b'\n')
            .take_while(|line| line.starts_with(b"#") || line.trim_ascii().is_empty());
        position.line() + skipped.count() as u64
    }

    /// A line without commas that has other separators is refused as such: what its only field must
    /// be would lead the reader astray.
    fn check_separator(&self) -> Result<(), CatalogueError> {
        let only = self.record.get(0).filter(|_| self.record.len() == 1);
        for (mark, separator) in [(b';', "semicolons"), (b'\t', "tabs")] {
            if only.is_some_and(|field| field.contains(&mark)) {
                let (origin, line) = (self.origin.to_owned(), self.line());
                return Err(CatalogueError::Separator {
                    origin,
                    line,
                    separator,
                });
            }
        }
        Ok(())
    }

    /// A header has the name of a column.
    fn is_header(&self) -> bool {
        let is_column = |field: &[u8]| {
            let mut columns = COLUMNS.iter();
            columns.any(|column| field.eq_ignore_ascii_case(column.as_bytes()))
        };
        self.record.iter().any(is_column)
    }

    fn places_of_columns(&self) -> Result<[Option<usize>; 5], CatalogueError> {
        let places = COLUMNS.map(|column| {
            self.record
                .iter()
                .position(|name| name.eq_ignore_ascii_case(column.as_bytes()))
        });
        for (column, place) in COLUMNS.into_iter().zip(places).take(3) {
            if place.is_none() {
                return Err(CatalogueError::Column {
                    origin: self.origin.to_owned(),
                    line: self.line(),
                    column,
                });
            }
        }
        Ok(places)
    }

    /// The text of a column; empty where the line or the file does not have it.
    fn text(&self, column: usize) -> &[u8] {
        self.places[column]
            .and_then(|place| self.record.get(place))
            .unwrap_or_default()
    }

    fn number(&self, column: usize, low: f64, high: f64) -> Result<f64, CatalogueError> {
        number(self.text(column))
            .filter(|number| (low..=high).contains(number))
            .ok_or_else(|| self.refusal(column, format!("a number from {low} to {high}")))
    }

    fn star(&self) -> Result<Star, CatalogueError> {
        let ra = self.number(0, 0.0, 360.0)?;
        let dec = self.number(1, -90.0, 90.0)?;
        let magnitude = self.number(2, -30.0, 30.0)?;
        let b_v = match self.text(3) {
            b"" => SOLAR_B_V,
            text => number(text)
                .ok_or_else(|| self.refusal(3, "a number, or empty if it is not known".into()))?,
        };
        Ok(Star {
            direction: celestial_direction(ra, dec).as_vec3(),
            magnitude: magnitude as f32,
            temperature: temperature_from_b_v(b_v) as f32,
        })
    }

    fn name(&self) -> Result<Option<String>, CatalogueError> {
        let name = String::from_utf8_lossy(self.text(4));
        if name.chars().nth(MAX_NAME_CHARS).is_some() {
            let allowed = format!("a name of at most {MAX_NAME_CHARS} characters");
            return Err(self.refusal(4, allowed));
        }
        Ok(Some(name)
            .filter(|name| !name.is_empty())
            .map(Cow::into_owned))
    }

    fn refusal(&self, column: usize, allowed: String) -> CatalogueError {
        let text = String::from_utf8_lossy(self.text(column));
        CatalogueError::Field {
            origin: self.origin.to_owned(),
            line: self.line(),
            column: COLUMNS[column],
            given: text.chars().take(40).flat_map(char::escape_debug).collect(),
            allowed,
        }
    }
}

fn number(text: &[u8]) -> Option<f64> {
    let number: f64 = std::str::from_utf8(text).ok()?.parse().ok()?;
    number.is_finite().then_some(number)
}

static BRIGHT_STARS: LazyLock<Catalogue> = LazyLock::new(|| {
    Catalogue::from_csv("stars.csv", BUILT_IN.as_bytes())
        .expect("assets/sky/stars.csv is compiled in and a test reads it")
});
