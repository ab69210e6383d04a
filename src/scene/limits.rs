//! The limits of a scene: each field inside its range, and the rules that tie one field to another.

use std::ops::Bound::{Excluded, Included};

use toml::Value;

use super::error::{Because, Refusal};
use super::fields::{EDGE, FIELDS, Field, Kind, LONGEST_TEXT, Range, number};
use super::{ObserverKind, Scene};
use crate::physics::{kerr::Kerr, timelike::innermost};

impl Scene {
    /// Checks every field against its range and against the fields it depends on.
    ///
    /// # Errors
    /// The first field, in the order of the table, whose value is not allowed. Whether an observer of the chosen kind
    /// can exist at the camera's place is not asked here but where the observer's matrix is made.
    pub fn check(&self) -> Result<(), Refusal> {
        for (field, value) in self.values() {
            field.check_type(&value)?;
            let (range, because) = self.range(field);
            let inside = match &value {
                Value::Float(number) => range.contains(*number),
                Value::Integer(number) => range.contains(*number as f64),
                _ => true,
            };
            if !inside {
                return Err(Refusal {
                    key: field.key,
                    given: given(&value),
                    allowed: field.allowed_in(range),
                    because,
                });
            }
        }
        Ok(())
    }

    /// The range of a field beside the other fields of this scene, and which of them narrows it. Fields that are not
    /// numbers have no range of their own: [`Range::FINITE`].
    pub fn range(&self, field: &Field) -> (Range, Option<Because>) {
        let (Kind::Float(range) | Kind::Integer(range)) = field.kind else { return (Range::FINITE, None) };
        let because = |key, reason| Some(Because { key, reason });
        match field.key {
            "camera.r" => {
                let (kerr, spin) = (Kerr { spin: self.hole.spin }, number(self.hole.spin));
                if self.observer.kind == ObserverKind::Rain {
                    let reason = format!("nine tenths of the way between the horizons at hole.spin = {spin}");
                    return (Range { low: Included(innermost(kerr)), ..range }, because("hole.spin", reason));
                }
                let reason = format!("outside the horizon at hole.spin = {spin}");
                (Range { low: Excluded(kerr.horizon()), ..range }, because("hole.spin", reason))
            }
            "disk.inner" if EDGE.contains(self.disk.outer) => {
                let reason = format!("disk.outer is {}", number(self.disk.outer));
                (Range { high: Excluded(self.disk.outer), ..range }, because("disk.outer", reason))
            }
            "picture.grid_width" => grid_range("picture.width", self.picture.width),
            "picture.grid_height" => grid_range("picture.height", self.picture.height),
            _ => (range, None),
        }
    }

    /// Every field with its value, in the order of the table.
    pub fn values(&self) -> impl Iterator<Item = (&'static Field, Value)> {
        let table = toml::Table::try_from(self).expect("a scene is made of numbers, words and tables only");
        FIELDS.iter().map(move |field| {
            let (first, rest) = field.key.split_once('.').unwrap_or((field.key, ""));
            let value = table.get(first).and_then(|value| if rest.is_empty() { Some(value) } else { value.get(rest) });
            (field, value.expect("every key of the table is a field of the scene").clone())
        })
    }
}

/// Most pixels of the HDR picture that a presentation cell averages along each axis; pixelate.wgsl's loops are bounded by
/// it.
const PIXELS_PER_CELL: u32 = 64;

/// A presentation cell is at least one pixel of the HDR picture, so that the reduction averages and never invents.
fn grid_range(key: &'static str, side: u32) -> (Range, Option<Because>) {
    let least = f64::from(side.div_ceil(PIXELS_PER_CELL)).max(1.0);
    let most = f64::from(side);
    (Range { low: Included(least), high: Included(most) }, Some(Because { key, reason: format!("{key} is {side}") }))
}

impl Field {
    /// Checks that a value has the field's type and can be kept in it; the range of a float is left to
    /// [`Scene::check`], which knows the other fields.
    pub(super) fn check_type(&self, value: &Value) -> Result<(), Refusal> {
        let fits = match (self.kind, value) {
            (Kind::Float(_), Value::Float(_)) => true,
            (Kind::Integer(range), Value::Integer(number)) => range.contains(*number as f64),
            (Kind::Boolean, Value::Boolean(_)) => true,
            (Kind::Choice(choices), Value::String(word)) => choices.contains(&word.as_str()),
            (Kind::Text, Value::String(text)) => {
                text.chars().count() <= LONGEST_TEXT && !text.chars().any(char::is_control)
            }
            (Kind::Velocity, Value::Array(components)) => {
                let squares = components.iter().map(|component| component.as_float().map_or(f64::NAN, |v| v * v));
                components.len() == 3 && squares.sum::<f64>() < 1.0
            }
            _ => false,
        };
        if fits {
            return Ok(());
        }
        Err(Refusal { key: self.key, given: given(value), allowed: self.allowed(), because: None })
    }
}

/// A value as one short line, for a message.
pub(super) fn given(value: &Value) -> String {
    match value {
        Value::Float(x) => number(*x),
        Value::String(text) => quoted(text),
        Value::Table(_) => "{...}".into(),
        Value::Array(values) if values.len() > 8 => format!("an array of {}", values.len()),
        Value::Array(values) => format!("[{}]", values.iter().map(given).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

/// Text between quotes, on one line and not too long to read.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// Text on one line and not too long to read.
pub(super) fn shortened(text: &str) -> String {
    const LONGEST: usize = 60;
    let mut short: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if text.chars().nth(LONGEST).is_some() {
        short.push_str("...");
    }
    short
}
