//! From TOML's values and faults to the scene's.

use super::SCHEMA;
use super::error::{Refusal, SceneFault};
use super::field::Field;
use super::hint::is_table;
use super::range::{Kind, number};
use super::toml_fault::TomlFault;
use super::value::{Value, quoted};
use toml::Table;

impl Field {
    /// A TOML value as a value of this field. Whole numbers are accepted where a number is asked
    /// for. The range of a float is not checked.
    ///
    /// # Errors
    /// The value is of another kind, or cannot be kept in the field.
    pub(super) fn read(&self, value: &toml::Value) -> Result<Value, Refusal> {
        let typed = match (self.kind, value) {
            (Kind::Float(_), value) => float(value).map(Value::Float),
            (Kind::Integer(_), toml::Value::Integer(number)) => Some(Value::Integer(*number)),
            (Kind::Boolean, toml::Value::Boolean(on)) => Some(Value::Boolean(*on)),
            (Kind::Choice(choices), toml::Value::String(given)) => {
                let choice = choices.iter().find(|choice| choice.word == given);
                choice.map(|choice| Value::Word(choice.word))
            }
            (Kind::Text, toml::Value::String(text)) => Some(Value::Text(text.clone())),
            (Kind::Velocity, toml::Value::Array(components)) => velocity(components),
            (Kind::Pair, toml::Value::Array(numbers)) => pair(numbers),
            _ => None,
        };
        let typed = typed.ok_or_else(|| self.refusal(given(value)))?;
        self.check_kind(&typed).map(|()| typed)
    }

    /// As [`Field::read`], for a value that must be in the field's range whatever the other fields are.
    ///
    /// # Errors
    /// As those of [`Field::read`], or the number is out of range.
    pub(super) fn read_in_range(&self, value: &toml::Value) -> Result<Value, Refusal> {
        let value = self.read(value)?;
        match value.number() {
            Some(number) if !self.kind.range().contains(number) => {
                Err(self.refusal(value.quoted()))
            }
            _ => Ok(value),
        }
    }
}

/// The entries of a table, each with its whole key: an entry of an inner table whose name is that of a table
/// of fields has both names, as in `hole.spin`.
pub(super) fn flattened(table: Table) -> Vec<(String, toml::Value)> {
    let mut entries = Vec::new();
    for (key, value) in table {
        match value {
            toml::Value::Table(inner) if is_table(&key) => {
                let inner = inner.into_iter();
                entries.extend(inner.map(|(name, value)| (format!("{key}.{name}"), value)));
            }
            value => entries.push((key, value)),
        }
    }
    entries
}

/// A number, written with or without a decimal point.
pub(super) fn float(value: &toml::Value) -> Option<f64> {
    match value {
        toml::Value::Float(number) => Some(*number),
        toml::Value::Integer(number) => Some(*number as f64),
        _ => None,
    }
}

fn velocity(components: &[toml::Value]) -> Option<Value> {
    let [r, theta, phi] = components else {
        return None;
    };
    Some(Value::Velocity([float(r)?, float(theta)?, float(phi)?]))
}

fn pair(numbers: &[toml::Value]) -> Option<Value> {
    let [right, up] = numbers else {
        return None;
    };
    Some(Value::Pair([float(right)?, float(up)?]))
}

impl From<Value> for toml::Value {
    fn from(value: Value) -> Self {
        match value {
            Value::Float(number) => Self::Float(number),
            Value::Integer(number) => Self::Integer(number),
            Value::Boolean(on) => Self::Boolean(on),
            Value::Word(word) => Self::String(word.into()),
            Value::Text(text) => Self::String(text),
            Value::Velocity(components) => Self::Array(components.map(Self::Float).into()),
            Value::Pair(numbers) => Self::Array(numbers.map(Self::Float).into()),
        }
    }
}

/// A TOML value as one short line, for a message.
pub(super) fn given(value: &toml::Value) -> String {
    match value {
        toml::Value::Float(x) => number(*x),
        toml::Value::String(text) => quoted(text),
        toml::Value::Table(_) => "{...}".into(),
        toml::Value::Array(values) if values.len() > 8 => format!("an array of {}", values.len()),
        toml::Value::Array(values) => format!(
            "[{}]",
            values.iter().map(given).collect::<Vec<_>>().join(", ")
        ),
        other => other.to_string(),
    }
}

/// The table that a text in TOML describes, of a preset or a journey.
///
/// # Errors
/// The text is not TOML, or of another version of the format.
pub(super) fn table(text: &str) -> Result<Table, SceneFault> {
    let table: Table = toml::from_str(text).map_err(|error| TomlFault::new(text, &error))?;
    // The version comes first: other fields may be correct in another version of the format.
    match table.get("schema") {
        Some(schema @ toml::Value::Integer(number)) if *number != i64::from(SCHEMA) => {
            let given = given(schema);
            Err(SceneFault::Schema { given })
        }
        _ => Ok(table),
    }
}
