//! A catalogue of stars: the built-in one, and those of users.

mod error;
mod format;
mod layout;
mod row;

pub use error::CatalogueError;
use error::shortened;
pub use format::{MAX_NAME_CHARS, MAX_STARS};

use super::photometry::Star;
use csv::{ReaderBuilder, StringRecord, Trim};
use layout::Layout;
use row::Row;
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

/// The file that a catalogue was read from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StarFile {
    /// Its name, without folders.
    pub name: String,
    /// The SHA-256 of its bytes, as 64 hexadecimal digits.
    pub sha256: String,
}

/// A catalogue of stars, brightest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Catalogue {
    stars: Vec<Star>,
    names: Vec<NamedStar>,
    remarks: Vec<String>,
    /// The user's file that it was read from, where whoever read the file names it.
    pub file: Option<StarFile>,
}

impl Catalogue {
    /// The stars of the Bright Star Catalogue, complete to about V = 6. It is read at the first
    /// call.
    pub fn built_in() -> &'static Self {
        &BRIGHT_STARS
    }

    /// Reads a catalogue from CSV. Errors call it `origin`.
    ///
    /// Each line is a star: right ascension and declination (J2000, degrees), V, and, where they
    /// are known, B-V and a name. A star without B-V has the colour of the Sun; B-V outside -0.4 to
    /// 2.5 counts as the nearer of the two. A header with the names `ra_deg` or `ra_hours`,
    /// `dec_deg`, `v_mag`, `b_v` and `name` may give another order and columns beside these, which
    /// are not read; so may the headers of the HYG database and of Gaia's archive. Fields are
    /// separated by commas, semicolons or tabs, and decimals by points or commas. Lines that begin
    /// with # are comments.
    ///
    /// # Errors
    /// A column is missing, a field has a value that it cannot have, or there are no stars or more
    /// than [`MAX_STARS`].
    pub fn from_csv(origin: &str, text: &str) -> Result<Self, CatalogueError> {
        let mut csv = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .delimiter(layout::delimiter(text))
            .trim(Trim::All)
            .from_reader(text.as_bytes());
        let mut layout = None;
        let mut record = StringRecord::new();
        let mut catalogue = Self::default();
        let mut left_out = 0;
        let mut max_ra = 0.0_f64;
        loop {
            let more = csv
                .read_record(&mut record)
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
            let line = || row::line(text, &record);
            if let Some(field) = record.iter().find(|field| field.contains(['\n', '\r'])) {
                return Err(CatalogueError::Quote {
                    origin: origin.to_owned(),
                    line: line(),
                    given: shortened(field),
                });
            }
            let layout = match &layout {
                Some(known) => known,
                None => match Layout::of_header(origin, line, &record)? {
                    Some(found) => {
                        layout = Some(found);
                        continue;
                    }
                    None => layout.insert(Layout::without_header()),
                },
            };
            let row = Row {
                origin,
                text,
                record: &record,
                layout,
            };
            if row.is_left_out() {
                left_out += 1;
                continue;
            }
            if catalogue.stars.len() == MAX_STARS {
                let (origin, line) = (origin.to_owned(), line());
                return Err(CatalogueError::TooMany { origin, line });
            }
            let star = row.star()?;
            max_ra = max_ra.max(row.right_ascension()?);
            catalogue.stars.push(star);
            if let Some(name) = row.name()? {
                catalogue.names.push(NamedStar { name, star });
            }
        }
        let stars = catalogue.stars.len();
        if stars == 0 {
            let origin = origin.to_owned();
            return Err(CatalogueError::Empty { origin });
        }
        let by_magnitude = |a: &Star, b: &Star| a.magnitude.total_cmp(&b.magnitude);
        catalogue.stars.sort_by(by_magnitude);
        catalogue
            .names
            .sort_by(|a, b| by_magnitude(&a.star, &b.star));
        if let Some(layout) = layout {
            catalogue.remarks = layout.remarks(stars, left_out, max_ra);
        }
        Ok(catalogue)
    }

    /// The stars, brightest first.
    pub fn stars(&self) -> &[Star] {
        &self.stars
    }

    /// The stars that have a name, brightest first.
    pub fn names(&self) -> &[NamedStar] {
        &self.names
    }

    /// What a reader should know of the list: how its columns were understood, what was left out,
    /// and what is probably wrong. Each is a sentence without its full stop.
    #[must_use]
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// The number of stars that are brighter than `magnitude` or as bright.
    pub fn count(&self, magnitude: f64) -> usize {
        self.stars
            .partition_point(|star| star.magnitude <= magnitude as f32)
    }
}

/// See [`Catalogue::built_in`].
static BRIGHT_STARS: LazyLock<Catalogue> = LazyLock::new(|| {
    Catalogue::from_csv("stars.csv", BUILT_IN)
        .expect("assets/sky/stars.csv is compiled in and a test reads it")
});
