//! One line of a list of stars.

use super::super::frame::celestial_direction;
use super::super::photometry::{
    SOLAR_B_V, SOLAR_BP_RP, Star, temperature_from_b_v, temperature_from_bp_rp, v_from_gaia,
};
use super::error::{CatalogueError, shortened};
use super::format::MAX_NAME_CHARS;
use super::layout::{Colour, Layout};
use csv::StringRecord;

/// Degrees of an hour of right ascension.
const DEGREES_PER_HOUR: f64 = 15.0;

/// One line of the file.
pub(super) struct Row<'a> {
    pub(super) origin: &'a str,
    pub(super) text: &'a str,
    pub(super) record: &'a StringRecord,
    pub(super) layout: &'a Layout,
}

impl Row<'_> {
    /// Whether the line is not a star of the sky: HYG's Sun, or a source of Gaia without a
    /// magnitude.
    pub(super) fn is_left_out(&self) -> bool {
        match self.layout.colour() {
            Colour::BpRp => is_missing(self.field(2)),
            Colour::BV => self.layout.is_sun(self.field(4)),
        }
    }

    /// Right ascension in the list's own unit.
    pub(super) fn right_ascension(&self) -> Result<f64, CatalogueError> {
        self.number(0, 0.0, if self.layout.is_in_hours { 24.0 } else { 360.0 })
    }

    pub(super) fn star(&self) -> Result<Star, CatalogueError> {
        let mut ra = self.right_ascension()?;
        if self.layout.is_in_hours {
            ra *= DEGREES_PER_HOUR;
        }
        let dec = self.number(1, -90.0, 90.0)?;
        let magnitude = self.number(2, -30.0, 30.0)?;
        let colour =
            match self.field(3) {
                text if is_missing(text) => None,
                text => Some(number(text).ok_or_else(|| {
                    self.refusal(3, "a number, or empty if it is not known".into())
                })?),
            };
        let (magnitude, temperature) = match self.layout.colour() {
            Colour::BV => (magnitude, temperature_from_b_v(colour.unwrap_or(SOLAR_B_V))),
            Colour::BpRp => {
                let bp_rp = colour.unwrap_or(SOLAR_BP_RP);
                (v_from_gaia(magnitude, bp_rp), temperature_from_bp_rp(bp_rp))
            }
        };
        Ok(Star {
            direction: celestial_direction(ra, dec).as_vec3(),
            magnitude: magnitude as f32,
            temperature: temperature as f32,
        })
    }

    pub(super) fn name(&self) -> Result<Option<String>, CatalogueError> {
        let name = self.field(4);
        if name.chars().nth(MAX_NAME_CHARS).is_some() {
            let allowed = format!("a name of at most {MAX_NAME_CHARS} characters");
            return Err(self.refusal(4, allowed));
        }
        Ok(Some(name.to_owned()).filter(|name| !name.is_empty()))
    }

    /// The text of a column; empty where the line or the file does not have it.
    fn field(&self, column: usize) -> &str {
        self.layout
            .place(column)
            .and_then(|place| self.record.get(place))
            .unwrap_or_default()
    }

    fn number(&self, column: usize, low: f64, high: f64) -> Result<f64, CatalogueError> {
        number(self.field(column))
            .filter(|number| (low..=high).contains(number))
            .ok_or_else(|| self.refusal(column, format!("a number from {low} to {high}")))
    }

    fn refusal(&self, column: usize, allowed: String) -> CatalogueError {
        CatalogueError::Field {
            origin: self.origin.to_owned(),
            line: line(self.text, self.record),
            column: self.layout.name(column),
            given: shortened(self.field(column)),
            allowed,
        }
    }
}

/// The number of a record's line, from 1. The CSV reader has that of the blank lines and comments
/// before it.
pub(super) fn line(text: &str, record: &StringRecord) -> u64 {
    let Some(position) = record.position() else {
        return 0;
    };
    let rest = text
        .as_bytes()
        .get(position.byte() as usize..)
        .unwrap_or_default();
    let skipped = rest
        .split(|byte| *byte == b'\n')
        .take_while(|line| line.starts_with(b"#") || line.trim_ascii().is_empty());
    position.line() + skipped.count() as u64
}

/// A value that is not known. Gaia's bulk files write `null`.
fn is_missing(text: &str) -> bool {
    text.is_empty() || text.eq_ignore_ascii_case("null")
}

/// A finite number, with a decimal point or a decimal comma.
fn number(text: &str) -> Option<f64> {
    let number: f64 = text
        .parse()
        .ok()
        .or_else(|| text.replacen(',', ".", 1).parse().ok())?;
    number.is_finite().then_some(number)
}
