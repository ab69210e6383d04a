//! From the text of a journey to the journey.

use super::Journey;
use super::caption::{allowed_line, line, read_captions};
use super::clock::Clock;
use super::error::{Fault, JourneyError};
use super::format::MAX_KEYFRAMES;
use super::key_line::line_of;
use super::keyframe::{Keyframe, TABLE, Values};
use super::read_stop::read_stops;
use super::tracks::{Tracks, component};
use crate::scene::ObserverKind;
use crate::scene::fields::field;
use crate::scene::from_toml::{given, table};
use crate::scene::hint::is_table;
use crate::scene::presets::{self, Preset};
use crate::scene::value::{Value, shortened};
use toml::Table;

/// Makes a journey of its TOML `text`. `origin` names it in messages.
///
/// # Errors
/// One sentence that names the file, the keyframe or caption, what was given and what is allowed.
pub fn load(origin: &str, text: &str) -> Result<Journey, JourneyError> {
    let journey = table(text).map_err(Fault::from).and_then(journey);
    journey.map_err(|mut fault| {
        if let Fault::StopKey {
            line, number, key, ..
        } = &mut fault
        {
            *line = line_of(text, ["stop", key], *number);
        }
        JourneyError {
            origin: origin.into(),
            fault,
        }
    })
}

/// The journey that a TOML table describes.
fn journey(table: Table) -> Result<Journey, Fault> {
    let [mut title, mut teaches, mut ending] = [const { String::new() }; 3];
    let mut preset = None;
    let [mut frames, mut captions, mut stops] = [const { Vec::new() }; 3];
    let is_list_of_tables = |values: &[toml::Value]| values.iter().all(toml::Value::is_table);
    for (key, value) in table {
        match (key.as_str(), value) {
            ("schema", toml::Value::Integer(_)) => {}
            ("title", value @ toml::Value::String(_)) if is_title(&value) => {
                title = value.as_str().unwrap_or_default().into();
            }
            ("teaches", value) => teaches = read_line("teaches", &value)?,
            ("ending", value) => ending = read_line("ending", &value)?,
            ("preset", value) => preset = Some(read_preset(&value)?),
            ("keyframe", toml::Value::Array(values)) if is_list_of_tables(&values) => {
                frames = tables(values);
            }
            ("caption", toml::Value::Array(values)) if is_list_of_tables(&values) => {
                captions = tables(values);
            }
            ("stop", toml::Value::Array(values)) if is_list_of_tables(&values) => {
                stops = tables(values);
            }
            (key, _) if is_table(key) => return Err(Fault::FieldOfScenes { key: key.into() }),
            (_, value) => {
                return Err(Fault::Top {
                    key: shortened(&key),
                    given: given(&value),
                });
            }
        }
    }
    let keyframes = read_keyframes(frames)?;
    let values: Vec<Values> = keyframes.iter().map(|frame| frame.values.clone()).collect();
    let in_rain: Vec<Values> = keyframes.iter().map(Keyframe::values_in_rain).collect();
    check_velocities(values.iter())?;
    check_velocities(in_rain.iter())?;
    let [start, end] = [keyframes[0].time, keyframes[keyframes.len() - 1].time];
    let kind = |frame: &Keyframe| match frame.values.get("observer")? {
        Value::Word(word) => Some((frame.time - start, ObserverKind::from_word(word)?)),
        _ => None,
    };
    let numbers = |name: &str| {
        let number = |frame: &Keyframe| {
            let value = frame.values.get(name)?.number()?;
            Some((frame.time - start, value))
        };
        keyframes.iter().filter_map(number).collect()
    };
    let tracks = |values: &[Values]| {
        let times = keyframes.iter().map(|frame| frame.time - start);
        Tracks::through(&times.zip(values).collect::<Vec<_>>())
    };
    Ok(Journey {
        title,
        teaches,
        ending,
        preset,
        captions: read_captions(captions, [start, end])?,
        stops: read_stops(stops, [start, end])?,
        duration: end - start,
        tracks: tracks(&values),
        tracks_in_rain: tracks(&in_rain),
        kinds: keyframes.iter().filter_map(kind).collect(),
        clock: Clock {
            rates: numbers("disk_rate"),
            times: numbers("disk_time"),
        },
        keyframes,
    })
}

fn tables(values: Vec<toml::Value>) -> Vec<Table> {
    values
        .into_iter()
        .filter_map(|value| match value {
            toml::Value::Table(table) => Some(table),
            _ => None,
        })
        .collect()
}

/// The line of text of a key at the top level.
fn read_line(key: &'static str, value: &toml::Value) -> Result<String, Fault> {
    line(value).ok_or_else(|| Fault::Line {
        key,
        given: given(value),
        allowed: allowed_line(),
    })
}

/// Whether a text can be the title of a journey: whether it can be a scene's.
fn is_title(text: &toml::Value) -> bool {
    field("title").is_some_and(|field| field.read(text).is_ok())
}

/// The built-in preset that a text or an integer names.
fn read_preset(value: &toml::Value) -> Result<&'static Preset, Fault> {
    let preset = match value {
        toml::Value::String(name) => presets::find(name),
        toml::Value::Integer(number) => presets::find(&number.to_string()),
        _ => None,
    };
    let given = given(value);
    preset.ok_or(Fault::Preset { given })
}

fn read_keyframes(frames: Vec<Table>) -> Result<Vec<Keyframe>, Fault> {
    let count = frames.len();
    if !(2..=MAX_KEYFRAMES).contains(&count) {
        return Err(Fault::Count { count });
    }
    let mut keyframes: Vec<Keyframe> = Vec::with_capacity(count);
    for (index, frame) in frames.into_iter().enumerate() {
        let before = keyframes.last().map(|last| last.time);
        keyframes.push(Keyframe::read(index + 1, frame, before)?);
    }
    Ok(keyframes)
}

/// Checks that the velocity stays below that of light between keyframes, too: each component stays
/// between those of two keyframes, so all three at their largest must be slower than light.
fn check_velocities<'a>(keyframes: impl Iterator<Item = &'a Values> + Clone) -> Result<(), Fault> {
    let named = keyframes
        .enumerate()
        .filter_map(|(i, values)| Some((i + 1, values.get("velocity")?)));
    for ((_, start), (number, end)) in named.clone().zip(named.skip(1)) {
        let size = |velocity, axis| component(velocity, axis).unwrap_or_default().abs();
        let largest = |axis| f64::max(size(start, axis), size(end, axis));
        if (0..3).map(|axis| largest(axis).powi(2)).sum::<f64>() >= 1.0 {
            let before = start.quoted();
            return Err(Fault::Value {
                table: TABLE,
                number,
                key: "velocity",
                given: end.quoted(),
                allowed: format!(
                    "nearer to that of the keyframe before, {before}: on the way there it would reach 1 c"
                ),
            });
        }
    }
    Ok(())
}
