//! One field of a scene: its key, kind, unit, meaning and accessors.

use super::Scene;
use super::error::Refusal;
use super::range::{Kind, MAX_PAIR, MAX_TEXT_CHARS, Range};
use super::value::Value;
use crate::words::without_full_stop;

/// One leaf field of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Dotted key, as in `--set KEY=VALUE`.
    pub key: &'static str,
    /// What kind of value it takes, and from which range.
    pub kind: Kind,
    /// Unit, as it follows a number; empty for a number without one.
    pub unit: &'static str,
    /// What it means, in one line: the field's documentation.
    pub about: &'static str,
    /// Reads the field.
    read: fn(&Scene) -> Value,
    /// Writes the field; false if the value does not fit its type.
    write: fn(&mut Scene, Value) -> bool,
}

impl Field {
    /// A field whose doc comment is `doc`.
    pub(super) const fn new(
        (key, kind, unit, doc): (&'static str, Kind, &'static str, &'static str),
        read: fn(&Scene) -> Value,
        write: fn(&mut Scene, Value) -> bool,
    ) -> Self {
        let about = without_full_stop(doc);
        Self {
            key,
            kind,
            unit,
            about,
            read,
            write,
        }
    }

    /// The field's value in a scene.
    pub fn get(&self, scene: &Scene) -> Value {
        (self.read)(scene)
    }

    /// Sets the field in a scene. `Scene::check` then says whether the value goes with the other
    /// fields, and whether a float is in its range.
    ///
    /// # Errors
    /// The value is of another kind than the field, or cannot be kept in it.
    pub fn set(&self, scene: &mut Scene, value: Value) -> Result<(), Refusal> {
        self.check_kind(&value)?;
        let fits = (self.write)(scene, value);
        assert!(fits, "{} has another type than its row says", self.key);
        Ok(())
    }

    /// What the field takes, in words, e.g. `a number from 0 to 180 degrees`.
    pub fn allowed(&self) -> String {
        self.allowed_in(self.kind.range())
    }

    /// As [`Field::allowed`], with the range that the other fields of some scene leave it.
    pub(super) fn allowed_in(&self, range: Range) -> String {
        self.kind.in_words(range, self.unit)
    }

    /// Checks that a value is of the field's kind and can be kept in it. The range of a float is
    /// left to `Scene::check`, which knows the other fields.
    pub(super) fn check_kind(&self, value: &Value) -> Result<(), Refusal> {
        let fits = match (self.kind, value) {
            (Kind::Float(_), Value::Float(_)) | (Kind::Boolean, Value::Boolean(_)) => true,
            (Kind::Integer(range), Value::Integer(number)) => range.contains(*number as f64),
            (Kind::Choice(choices), Value::Word(word)) => {
                choices.iter().any(|choice| choice.word == *word)
            }
            (Kind::Text, Value::Text(text)) => {
                text.chars().count() <= MAX_TEXT_CHARS && !text.chars().any(char::is_control)
            }
            (Kind::Velocity, Value::Velocity(v)) => v.iter().map(|v| v * v).sum::<f64>() < 1.0,
            (Kind::Pair, Value::Pair(numbers)) => numbers.iter().all(|x| x.abs() <= MAX_PAIR),
            _ => false,
        };
        if fits {
            Ok(())
        } else {
            Err(self.refusal(value.quoted()))
        }
    }

    /// The refusal of a value, given in words, that the field cannot have in any scene.
    pub(super) fn refusal(&self, given: String) -> Refusal {
        Refusal {
            key: self.key,
            given,
            allowed: self.allowed(),
            because: None,
            blamed: None,
        }
    }
}
