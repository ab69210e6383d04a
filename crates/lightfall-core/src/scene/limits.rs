//! The limits of a scene: each field inside its range, and the rules that tie one field to another.

use std::ops::Bound::{self, Excluded, Included};

use toml::Value;

use super::error::{Because, Refusal};
use super::fields::{EDGE, FIELDS, Field, Kind, MAX_TEXT_CHARS, POLAR, Range, number};
use super::{Effects, ObserverKind, Scene};
use crate::geometry::kerr::Kerr;
use crate::geometry::observer::min_infall_radius;
use crate::geometry::sphere::polar_sin_cos;

impl Scene {
    /// Checks every field against its range and against the fields it depends on.
    ///
    /// # ErrorSummary
    /// The first field, in the order of the table, whose value is not allowed. That a circular
    /// orbit is in the disk's plane is not asked here but where the observer's matrix is made.
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
                    blamed: None,
                });
            }
        }
        Ok(())
    }

    /// The range of a field beside the other fields of this scene, and which of them narrow it.
    /// Fields that are not numbers have no range of their own: [`Range::FINITE`].
    pub fn range(&self, field: &Field) -> (Range, Option<Because>) {
        let (Kind::Float(range) | Kind::Integer(range)) = field.kind else {
            return (Range::FINITE, None);
        };
        match field.key {
            "camera.r" => {
                let (low, because) = self.nearest_place();
                (Range { low, ..range }, Some(because))
            }
            "disk.inner" if EDGE.contains(self.disk.outer) => {
                let reason = format!("disk.outer is {}", number(self.disk.outer));
                let because = Because {
                    keys: vec!["disk.outer"],
                    reason,
                };
                (
                    Range {
                        high: Excluded(self.disk.outer),
                        ..range
                    },
                    Some(because),
                )
            }
            "disk.outer" if self.disk.enabled => {
                let isco = Kerr {
                    spin: self.hole.spin,
                }
                .isco();
                let reason = format!(
                    "the innermost stable circular orbit at hole.spin = {}",
                    number(self.hole.spin)
                );
                let because = Because {
                    keys: vec!["hole.spin", "disk.enabled"],
                    reason,
                };
                (
                    Range {
                        low: Excluded(isco),
                        ..range
                    },
                    Some(because),
                )
            }
            "picture.grid_width" => grid_range("picture.width", self.picture.width),
            "picture.grid_height" => grid_range("picture.height", self.picture.height),
            _ => (range, None),
        }
    }

    /// How near to the hole the camera may be: as near as its observer can exist.
    fn nearest_place(&self) -> (Bound<f64>, Because) {
        let (kerr, theta_deg) = (
            Kerr {
                spin: self.hole.spin,
            },
            self.camera.theta_deg,
        );
        let at_spin = format!("at hole.spin = {}", number(self.hole.spin));
        let mut keys = vec!["hole.spin", "observer.kind"];
        let horizon = Excluded(kerr.horizon());
        let (low, reason) = match self.observer.kind {
            ObserverKind::Static if self.hole.spin != 0.0 && POLAR.contains(theta_deg) => {
                keys.push("camera.theta_deg");
                let limit = kerr.static_limit(polar_sin_cos(theta_deg.to_radians()).1);
                let theta_deg = number(theta_deg);
                let reason = format!(
                    "nothing is at rest in the ergosphere, which {at_spin} and camera.theta_deg = {theta_deg} reaches so far; \
                     observers zamo and rain go deeper"
                );
                (Excluded(limit), reason)
            }
            ObserverKind::Static | ObserverKind::Zamo => (
                horizon,
                format!("outside the horizon {at_spin}; observer rain goes on inside"),
            ),
            ObserverKind::Orbit => (
                Excluded(kerr.photon_orbit_prograde()),
                format!("outside the prograde photon orbit {at_spin}"),
            ),
            ObserverKind::Rain => match self.effects.missing_inside() {
                missing if missing.is_empty() => (
                    Included(min_infall_radius(kerr)),
                    format!("nine tenths of the way between the horizons {at_spin}"),
                ),
                missing => {
                    let reason = format!(
                        "outside the horizon {at_spin}, where {} is false",
                        missing.join(", ")
                    );
                    keys.extend(missing);
                    (horizon, reason)
                }
            },
        };
        (low, Because { keys, reason })
    }

    /// Every field with its value, in the order of the table.
    pub fn values(&self) -> impl Iterator<Item = (&'static Field, Value)> {
        let table =
            toml::Table::try_from(self).expect("a scene is made of numbers, words and tables only");
        FIELDS.iter().map(move |field| {
            let (first, rest) = field.key.split_once('.').unwrap_or((field.key, ""));
            let value = table.get(first).and_then(|value| {
                if rest.is_empty() {
                    Some(value)
                } else {
                    value.get(rest)
                }
            });
            (
                field,
                value
                    .expect("every key of the table is a field of the scene")
                    .clone(),
            )
        })
    }
}

/// Most pixels of the HDR picture that a presentation cell averages along each axis;
/// pixelate.wgsl's loops are bounded by it.
const PIXELS_PER_CELL: u32 = 64;

/// A presentation cell is at least one pixel of the HDR picture, so that the reduction averages and
/// never invents.
fn grid_range(key: &'static str, side: u32) -> (Range, Option<Because>) {
    let least = f64::from(side.div_ceil(PIXELS_PER_CELL)).max(1.0);
    let most = f64::from(side);
    let because = Because {
        keys: vec![key],
        reason: format!("{key} is {side}"),
    };
    (
        Range {
            low: Included(least),
            high: Included(most),
        },
        Some(because),
    )
}

impl Effects {
    /// Those that are off and are told apart by an observer who stays outside the horizon.
    fn missing_inside(&self) -> Vec<&'static str> {
        let needed = [
            ("effects.lensing", self.lensing),
            ("effects.doppler", self.doppler),
            ("effects.gravitational_shift", self.gravitational_shift),
            ("effects.aberration", self.aberration),
        ];
        needed
            .into_iter()
            .filter(|(_, there)| !there)
            .map(|(key, _)| key)
            .collect()
    }
}

impl Field {
    /// Checks that a value has the field's type and can be kept in it; the range of a float is left
    /// to [`Scene::check`], which knows the other fields.
    pub(super) fn check_type(&self, value: &Value) -> Result<(), Refusal> {
        let fits = match (self.kind, value) {
            (Kind::Float(_), Value::Float(_)) => true,
            (Kind::Integer(range), Value::Integer(number)) => range.contains(*number as f64),
            (Kind::Boolean, Value::Boolean(_)) => true,
            (Kind::Choice(choices), Value::String(word)) => choices.contains(&word.as_str()),
            (Kind::Text, Value::String(text)) => {
                text.chars().count() <= MAX_TEXT_CHARS && !text.chars().any(char::is_control)
            }
            (Kind::Velocity, Value::Array(components)) => {
                let squares = components
                    .iter()
                    .map(|component| component.as_float().map_or(f64::NAN, |v| v * v));
                components.len() == 3 && squares.sum::<f64>() < 1.0
            }
            _ => false,
        };
        if fits {
            return Ok(());
        }
        Err(Refusal {
            key: self.key,
            given: given(value),
            allowed: self.allowed(),
            because: None,
            blamed: None,
        })
    }
}

/// A value as one short line, for a message.
pub(super) fn given(value: &Value) -> String {
    match value {
        Value::Float(x) => number(*x),
        Value::String(text) => quoted(text),
        Value::Table(_) => "{...}".into(),
        Value::Array(values) if values.len() > 8 => format!("an array of {}", values.len()),
        Value::Array(values) => format!(
            "[{}]",
            values.iter().map(given).collect::<Vec<_>>().join(", ")
        ),
        other => other.to_string(),
    }
}

/// Text between quotes, on one line and not too long to read.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// Text on one line and not too long to read.
pub(super) fn shortened(text: &str) -> String {
    const MAX_LENGTH: usize = 60;
    let mut short: String = text
        .chars()
        .take(MAX_LENGTH)
        .flat_map(char::escape_debug)
        .collect();
    if text.chars().nth(MAX_LENGTH).is_some() {
        short.push_str("...");
    }
    short
}
