//! From TOML's values and faults to the scene's.

use super::SCHEMA;
use super::error::{Refusal, SceneFault};
use super::field::Field;
use super::range::{Kind, number};
use super::value::{Value, quoted};
use crate::numbers::number_with_comma;
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
    let table: Table = toml::from_str(text).map_err(|error| syntax(text, &error))?;
    // The version comes first: other fields may be correct in another version of the format.
    match table.get("schema") {
        Some(schema @ toml::Value::Integer(number)) if *number != i64::from(SCHEMA) => {
            let given = given(schema);
            Err(SceneFault::Schema { given })
        }
        _ => Ok(table),
    }
}

/// A fault of TOML with the line and column where it was noticed.
pub(super) fn syntax(text: &str, error: &toml::de::Error) -> SceneFault {
    let at = error.span().map_or(0, |span| span.start.min(text.len()));
    let before = String::from_utf8_lossy(&text.as_bytes()[..at]);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let message = one_line(error.message());
    let line = text[line_start..].lines().next().unwrap_or_default();
    SceneFault::Syntax {
        line: 1 + before.matches('\n').count(),
        column: 1 + before[line_start..].chars().count(),
        message: match meant(line) {
            Some(meant) => format!("{message} ({meant})"),
            None => message,
        },
    }
}

/// What was probably meant by a line that is no TOML: a number with a decimal comma, or `no` for false.
fn meant(line: &str) -> Option<String> {
    let value = line.split_once('=').map(|(_, value)| value.trim());
    let number = value.and_then(|value| number_with_comma(value, |_| true));
    if let Some(number) = number {
        return Some(format!("did you mean {number}?"));
    }
    let word = value?.split('#').next().unwrap_or_default().trim();
    let is_switch = ["yes", "no", "on", "off", "true", "false"].contains(&&*word.to_lowercase());
    if is_switch && !["true", "false"].contains(&word) {
        return Some("write true or false, in small letters".into());
    }
    // In a table on one line.
    let is_part = |c: char| c.is_ascii_digit() || "+-.,".contains(c);
    line.match_indices('=').find_map(|(at, _)| {
        let is_quoted = line[..at].matches('"').count() % 2 == 1;
        let value = line[at + 1..].trim_start();
        let end = value.find(|c: char| !is_part(c)).unwrap_or(value.len());
        let number = value[..end].trim_end_matches(',');
        let with_point = number.replacen(',', ".", 1);
        let is_number = number.contains(',') && with_point.parse::<f64>().is_ok();
        (is_number && !is_quoted).then(|| format!("write {with_point} with a point"))
    })
}

fn one_line(message: &str) -> String {
    message
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect::<Vec<_>>()
        .join(", ")
}
