//! Reports read back from their CSV files.

use super::circumstances::Circumstances;
use lightfall_optics::trace::Outcome;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// A report that was read from a CSV file.
#[derive(Clone, Debug, PartialEq)]
pub struct Report<T> {
    /// The circumstances, by name.
    pub head: Head,
    /// The rows.
    pub rows: Vec<T>,
}

/// The lines in front of a report's table: `# name: value`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Head(BTreeMap<String, String>);

impl Head {
    fn read(text: &str) -> Self {
        let lines = text.lines().map_while(|line| line.strip_prefix('#'));
        let named = lines.filter_map(|line| line.split_once(':'));
        Self(
            named
                .map(|(name, value)| (name.trim().into(), value.trim().into()))
                .collect(),
        )
    }

    /// The value with this name, if the report has one.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
    }

    /// The difference of the report's conditions from these, in words. `None` if they are the same,
    /// so that its rows belong to the same run.
    pub fn difference(&self, circumstances: &Circumstances) -> Option<String> {
        circumstances.conditions().find_map(|(name, here)| {
            let there = self.get(name).unwrap_or("unknown");
            (there != here).then(|| format!("{name} was {there} and is {here}"))
        })
    }

    /// The time of a run that only traces straight lines, in milliseconds, if the report has it.
    pub fn floor_ms(&self) -> Option<f64> {
        let number = self.get("floor_ms")?.split(' ').next()?;
        number.parse().ok()
    }
}

impl<T: DeserializeOwned> Report<T> {
    /// Reads what [`csv`](super::export::csv) writes.
    ///
    /// # Errors
    /// A sentence that names the line.
    pub fn read(text: &str) -> Result<Self, String> {
        let head = Head::read(text);
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let columns = reader.headers().map_err(|error| error.to_string())?.clone();
        let row = |record: Result<csv::StringRecord, csv::Error>| {
            let record = record.map_err(|error| error.to_string())?;
            let line = record.position().map_or(0, csv::Position::line);
            let mut row = Map::new();
            for (column, field) in columns.iter().zip(&record) {
                unflatten(column, field, &mut row);
            }
            serde_json::from_value(Value::Object(row))
                .map_err(|error| format!("line {line}: {error}"))
        };
        let rows = reader.records().map(row).collect::<Result<_, _>>()?;
        Ok(Self { head, rows })
    }
}

/// Adds a field to its row. Several fields, one for each outcome, become one list.
fn unflatten(column: &str, field: &str, row: &mut Map<String, Value>) {
    let by_outcome = column
        .rsplit_once('_')
        .filter(|(_, word)| Outcome::ALL.iter().any(|outcome| outcome.word() == *word));
    match by_outcome {
        None => {
            row.insert(column.into(), value(field));
        }
        Some((name, _)) => {
            let list = row.entry(name).or_insert_with(|| Value::Array(Vec::new()));
            if let Value::Array(list) = list {
                list.push(value(field));
            }
        }
    }
}

/// The value that a field's text stands for. Floating-point numbers are exactly those written.
fn value(field: &str) -> Value {
    let number = || {
        let number: f64 = field.parse().ok()?;
        serde_json::Number::from_f64(number).map(Value::Number)
    };
    match field {
        "" => Value::Null,
        "true" | "false" => Value::Bool(field == "true"),
        _ => field
            .parse::<u64>()
            .map(Value::from)
            .ok()
            .or_else(number)
            .unwrap_or_else(|| Value::String(field.into())),
    }
}

/// Reads a number that is NaN where the report has none.
pub(super) fn or_nan<'de, D: Deserializer<'de>>(field: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(field)?.unwrap_or(f64::NAN))
}

/// Reads an error that is infinite where the report has none, because a ray was given up.
pub(super) fn or_infinite<'de, D: Deserializer<'de>>(field: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(field)?.unwrap_or(f64::INFINITY))
}
