//! The columns of a list of stars, found from its header.

use super::CatalogueError;
use super::error::shortened;
use super::format::{COLUMNS, HOURS};
use csv::StringRecord;

/// A kind of list, by the names of its columns in the order of [`COLUMNS`]. A column may have
/// several names, of which a header has one.
struct Source {
    columns: [&'static [&'static str]; 5],
    /// Columns of which a header of this kind has at least one, beside the first three.
    marks: &'static [&'static str],
    is_in_hours: bool,
    colour: Colour,
    /// The name of the Sun, if the list has it.
    sun: Option<&'static str>,
    /// What the program says of a list of this kind.
    remark: Option<&'static str>,
}

/// What the column of colours holds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Colour {
    /// B-V; the brightness is V.
    BV,
    /// BP-RP; the brightness is Gaia's G.
    BpRp,
}

const OWN: Source = Source {
    columns: [&["ra_deg"], &["dec_deg"], &["v_mag"], &["b_v"], &["name"]],
    marks: &[],
    is_in_hours: false,
    colour: Colour::BV,
    sun: None,
    remark: None,
};

/// The HYG database, versions 1 to 4, and AT-HYG. Their first star is the Sun.
const HYG: Source = Source {
    columns: [
        &["ra"],
        &["dec"],
        &["mag"],
        &["ci", "colorindex"],
        &["proper", "propername"],
    ],
    marks: &["hip", "proper", "propername", "ci", "colorindex", "absmag"],
    is_in_hours: true,
    colour: Colour::BV,
    sun: Some("Sol"),
    remark: Some(
        "the columns are those of the HYG database: right ascensions are in hours, and the Sun is left out",
    ),
};

/// Gaia's archive, `gaia_source` of DR2 and DR3.
const GAIA: Source = Source {
    columns: [&["ra"], &["dec"], &["phot_g_mean_mag"], &["bp_rp"], &[]],
    marks: &["phot_g_mean_mag"],
    is_in_hours: false,
    colour: Colour::BpRp,
    sun: None,
    remark: Some("the columns are those of Gaia: V follows from G and BP-RP"),
};

/// Where the columns of a list are.
pub(super) struct Layout {
    source: &'static Source,
    /// Where each column is.
    places: [Option<usize>; 5],
    /// Whether right ascensions are in hours.
    pub(super) is_in_hours: bool,
}

impl Layout {
    /// The layout of a list whose first line is a star.
    pub(super) fn without_header() -> Self {
        Self {
            source: &OWN,
            places: std::array::from_fn(Some),
            is_in_hours: false,
        }
    }

    /// The layout that a header gives, or `None` if the record is a star's.
    pub(super) fn of_header(
        origin: &str,
        line: impl Fn() -> u64,
        record: &StringRecord,
    ) -> Result<Option<Self>, CatalogueError> {
        let names: Vec<String> = record.iter().map(str::to_lowercase).collect();
        let has = |name: &&str| names.iter().any(|other| other == name);
        if COLUMNS.iter().chain([&HOURS]).any(has) {
            let hours = names.iter().position(|name| name == HOURS);
            let mut layout = Self::of_columns(&OWN, &names);
            layout.is_in_hours = layout.places[0].is_none() && hours.is_some();
            layout.places[0] = layout.places[0].or(hours);
            let missing = layout.places[..3].iter().position(Option::is_none);
            return match missing {
                None => Ok(Some(layout)),
                Some(column) => Err(CatalogueError::Column {
                    origin: origin.to_owned(),
                    line: line(),
                    column: COLUMNS[column],
                }),
            };
        }
        for source in [&GAIA, &HYG] {
            let layout = Self::of_columns(source, &names);
            let has_three = layout.places[..3].iter().all(Option::is_some);
            if has_three && source.marks.iter().any(has) {
                return Ok(Some(layout));
            }
        }
        let is_word = |field: &String| field.starts_with(|c: char| c.is_ascii_alphabetic());
        if names.len() > 1 && names.iter().all(is_word) {
            return Err(CatalogueError::Header {
                origin: origin.to_owned(),
                line: line(),
                given: shortened(&record.iter().collect::<Vec<_>>().join(",")),
            });
        }
        Ok(None)
    }

    fn of_columns(source: &'static Source, names: &[String]) -> Self {
        let places = source.columns.map(|column| {
            let is_it = |name: &String| column.contains(&name.as_str());
            names.iter().position(is_it)
        });
        Self {
            source,
            places,
            is_in_hours: source.is_in_hours,
        }
    }

    pub(super) fn place(&self, column: usize) -> Option<usize> {
        self.places[column]
    }

    /// The name of a column in this list.
    pub(super) fn name(&self, column: usize) -> &'static str {
        match self.source.columns[column] {
            _ if column == 0 && self.is_in_hours != self.source.is_in_hours => HOURS,
            [name, ..] => name,
            [] => COLUMNS[column],
        }
    }

    pub(super) fn colour(&self) -> Colour {
        self.source.colour
    }

    pub(super) fn is_sun(&self, name: &str) -> bool {
        self.source.sun == Some(name)
    }

    /// See [`Catalogue::remarks`](super::Catalogue::remarks). `max_ra` is in the list's own unit.
    pub(super) fn remarks(&self, stars: usize, left_out: usize, max_ra: f64) -> Vec<String> {
        let mut remarks: Vec<String> = self.source.remark.into_iter().map(Into::into).collect();
        if left_out > 0 && self.source.sun.is_none() {
            remarks.push(format!(
                "{left_out} of {} lines are left out, because they have no {}",
                stars + left_out,
                self.name(2)
            ));
        }
        if stars > 1 && max_ra < 24.0 && !self.is_in_hours {
            remarks.push(
                "all right ascensions are below 24 and are read as degrees; if they are hours, call their column ra_hours"
                    .into(),
            );
        }
        remarks
    }
}

/// What separates the fields of a text: semicolons or tabs, if its first line that is not a
/// comment has enough of them for three fields; otherwise commas.
pub(super) fn delimiter(text: &str) -> u8 {
    let first = text
        .lines()
        .find(|line| !line.trim().is_empty() && !line.starts_with('#'))
        .unwrap_or_default();
    [b';', b'\t']
        .into_iter()
        .find(|mark| first.bytes().filter(|byte| byte == mark).count() >= 2)
        .unwrap_or(b',')
}
