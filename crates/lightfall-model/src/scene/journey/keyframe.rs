//! One keyframe of a journey: its values, each checked by the field that it will be written to.

use super::ease::Ease;
use super::error::Fault;
use super::format::{MAX_SECONDS, NAMES, NOT_IN_RAIN, field_like};
use super::set::read_set;
use crate::scene::from_toml::{float, given};
use crate::scene::value::{Value, shortened};
use std::collections::BTreeMap;
use toml::Table;

/// What the table of a keyframe is called.
pub(super) const TABLE: &str = "keyframe";

/// The values of a keyframe by their names.
pub(super) type Values = BTreeMap<&'static str, Value>;

/// One keyframe, each value checked.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Keyframe {
    /// When it is, in seconds.
    pub(super) time: f64,
    /// How each quantity that it names changes until the next keyframe that names it.
    pub(super) ease: Ease,
    /// What it names.
    pub(super) values: Values,
    /// The fields of the scene that its table `set` names, by their keys.
    pub(super) set: Values,
    /// What differs for an observer that falls freely.
    pub(super) in_rain: Values,
}

impl Keyframe {
    /// Reads the keyframe of this number, counted from 1, after one at the time `before`.
    pub(super) fn read(
        number: usize,
        mut frame: Table,
        before: Option<f64>,
    ) -> Result<Self, Fault> {
        let unknown = |key: &str| Fault::UnknownKey {
            number,
            key: key.into(),
        };
        let time = time(number, frame.remove("time").as_ref(), before)?;
        let ease = ease(number, frame.remove("ease").as_ref())?;
        let set = read_set(number, frame.remove("set"))?;
        let in_rain = match frame.remove("rain") {
            Some(toml::Value::Table(in_rain)) => in_rain,
            Some(_) => return Err(unknown("value rain")),
            None => Table::new(),
        };
        if let Some(key) = NOT_IN_RAIN.iter().find(|key| in_rain.contains_key(**key)) {
            return Err(unknown(&format!("rain.{key}")));
        }
        Ok(Self {
            time,
            ease,
            set,
            values: checked(number, &frame)?,
            in_rain: checked(number, &in_rain)?,
        })
    }

    /// The values for an observer that falls freely.
    pub(super) fn values_in_rain(&self) -> Values {
        let mut values = self.values.clone();
        values.extend(self.in_rain.clone());
        values
    }
}

/// The time of a keyframe, which comes after the one before.
fn time(number: usize, time: Option<&toml::Value>, before: Option<f64>) -> Result<f64, Fault> {
    let seconds = time.and_then(float);
    let later = |seconds: f64| before.is_none_or(|last| seconds > last);
    if let Some(seconds) = seconds
        && (0.0..=MAX_SECONDS).contains(&seconds)
        && later(seconds)
    {
        return Ok(seconds);
    }
    let allowed = match before {
        Some(last) if !seconds.is_some_and(later) => {
            format!("a number of seconds above {last}, the time of the keyframe before")
        }
        _ => format!("a number of seconds from 0 to {MAX_SECONDS}"),
    };
    Err(Fault::Value {
        table: TABLE,
        number,
        key: "time",
        given: time.map(given),
        allowed,
    })
}

/// The ease of a keyframe.
fn ease(number: usize, value: Option<&toml::Value>) -> Result<Ease, Fault> {
    let Some(value) = value else {
        return Ok(Ease::Smooth);
    };
    let word = value.as_str().and_then(Ease::from_word);
    word.ok_or_else(|| Fault::Value {
        table: TABLE,
        number,
        key: "ease",
        given: Some(given(value)),
        allowed: format!("one of {}", Ease::WORDS.join(", ")),
    })
}

/// The values of a keyframe, each by its name.
fn checked(number: usize, frame: &Table) -> Result<Values, Fault> {
    let mut values = Values::new();
    for (key, value) in frame {
        let Some((name, like)) = NAMES.into_iter().find(|(name, _)| name == key) else {
            let key = shortened(key);
            return Err(Fault::UnknownKey { number, key });
        };
        let field = field_like(like);
        let read = field.read_in_range(value);
        let value = read.map_err(|refusal| Fault::Value {
            table: TABLE,
            number,
            key: name,
            given: Some(refusal.given),
            allowed: refusal.allowed,
        })?;
        values.insert(name, value);
    }
    Ok(values)
}
