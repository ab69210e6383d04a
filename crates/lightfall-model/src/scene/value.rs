//! The value of one field, and which Rust type keeps it in a [`Scene`](super::Scene).

use std::fmt;

use super::range::{Kind, Range, number};
use crate::words::Words;

/// The value of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Float(f64),
    /// A whole number.
    Integer(i64),
    /// True or false.
    Boolean(bool),
    /// One of the words of a choice.
    Word(&'static str),
    /// One line of text.
    Text(String),
    /// The components of a velocity: outward, toward growing theta, toward growing phi; units of c.
    Velocity([f64; 3]),
    /// Two numbers: to the right and upward.
    Pair([f64; 2]),
}

impl Value {
    /// The number of a float or an integer.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Float(number) => Some(*number),
            Self::Integer(number) => Some(*number as f64),
            _ => None,
        }
    }

    /// The value as one short line, for a message.
    pub(super) fn quoted(&self) -> String {
        match self {
            Self::Float(x) => number(*x),
            Self::Integer(n) => n.to_string(),
            Self::Boolean(on) => on.to_string(),
            Self::Word(word) => quoted(word),
            Self::Text(text) => quoted(text),
            Self::Velocity(components) => format!("[{}]", components.map(number).join(", ")),
            Self::Pair(numbers) => format!("[{}]", numbers.map(number).join(", ")),
        }
    }
}

impl fmt::Display for Value {
    /// The value as TOML writes it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        toml::Value::from(self.clone()).fmt(f)
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Float(number)
    }
}

/// A type that a field of a scene can have.
pub(super) trait FieldValue: Sized {
    /// The kind of the field; numbers may have any finite value until the table narrows them.
    const KIND: Kind;

    /// The field's value.
    fn to_value(&self) -> Value;

    /// The type's value; none if `value` is of another kind or does not fit.
    fn from_value(value: Value) -> Option<Self>;
}

macro_rules! field_value {
    ($type:ty, $kind:expr, $Variant:ident) => {
        impl FieldValue for $type {
            const KIND: Kind = $kind;

            fn to_value(&self) -> Value {
                Value::$Variant(self.clone().into())
            }

            fn from_value(value: Value) -> Option<Self> {
                match value {
                    Value::$Variant(value) => value.try_into().ok(),
                    _ => None,
                }
            }
        }
    };
}

field_value!(f64, Kind::Float(Range::FINITE), Float);
field_value!(u32, Kind::Integer(Range::FINITE), Integer);
field_value!(bool, Kind::Boolean, Boolean);
field_value!(String, Kind::Text, Text);
field_value!([f64; 3], Kind::Velocity, Velocity);
field_value!([f64; 2], Kind::Pair, Pair);

impl<T: Words> FieldValue for T {
    const KIND: Kind = Kind::Choice(T::CHOICES);

    fn to_value(&self) -> Value {
        Value::Word(self.word())
    }

    fn from_value(value: Value) -> Option<Self> {
        match value {
            Value::Word(word) => T::from_word(word),
            _ => None,
        }
    }
}

/// Text between quotes, on one line and short enough to read.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// Text on one line and short enough to read.
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
