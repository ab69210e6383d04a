//! From the text of a journey to the journey.

use super::caption::{Caption, read_captions};
use super::clock::Clock;
use super::error::JourneyError;
use super::format::MAX_KEYFRAMES;
use super::keyframe::{Keyframe, Values};
use super::{ANGLES, Journey, Track, Tracks};
use crate::scene::error::SceneError;
use crate::scene::fields::field;
use crate::scene::from_toml::{given, syntax};
use crate::scene::presets::{self, Preset};
use crate::scene::value::{Value, shortened};
use crate::scene::{ObserverKind, SCHEMA};
use toml::Table;

/// Makes a journey of its TOML `text`. `origin` names it in messages.
///
/// # Errors
/// One sentence that names the file, the keyframe or caption, what was given and what is allowed.
pub fn load(origin: &str, text: &str) -> Result<Journey, JourneyError> {
    let table: Table = toml::from_str(text).map_err(|error| syntax(origin, text, &error))?;
    let (mut title, mut preset) = (String::new(), None);
    let (mut frames, mut captions) = (Vec::new(), Vec::new());
    for (key, value) in table {
        match (key.as_str(), value) {
            ("schema", toml::Value::Integer(number)) if number == i64::from(SCHEMA) => {}
            ("schema", value @ toml::Value::Integer(_)) => {
                return Err(SceneError::Schema {
                    origin: origin.into(),
                    given: given(&value),
                }
                .into());
            }
            ("title", value @ toml::Value::String(_)) if is_title(&value) => {
                title = value.as_str().unwrap_or_default().into();
            }
            ("preset", value) => preset = Some(read_preset(origin, &value)?),
            ("keyframe", toml::Value::Array(values))
                if values.iter().all(toml::Value::is_table) =>
            {
                frames = tables(values);
            }
            ("caption", toml::Value::Array(values)) if values.iter().all(toml::Value::is_table) => {
                captions = tables(values);
            }
            (_, value) => {
                return Err(JourneyError::Top {
                    origin: origin.into(),
                    key: shortened(&key),
                    given: given(&value),
                });
            }
        }
    }
    let keyframes = read_keyframes(origin, frames)?;
    for values in [Keyframe::values, Keyframe::values_in_rain] {
        check_velocities(
            origin,
            keyframes.iter().map(|frame| values(frame).get("velocity")),
        )?;
    }
    let span = [keyframes[0].time, keyframes[keyframes.len() - 1].time];
    let captions = read_captions(origin, captions, span)?;
    Ok(Journey {
        title,
        preset,
        ..journey(&keyframes, captions)
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

/// Whether a text can be the title of a journey: whether it can be a scene's.
fn is_title(text: &toml::Value) -> bool {
    field("title").is_some_and(|field| field.read(text).is_ok())
}

/// The built-in preset that a text or an integer names.
fn read_preset(origin: &str, value: &toml::Value) -> Result<&'static Preset, JourneyError> {
    let preset = match value {
        toml::Value::String(name) => presets::find(name),
        toml::Value::Integer(number) => presets::find(&number.to_string()),
        _ => None,
    };
    preset.ok_or_else(|| JourneyError::Preset {
        origin: origin.into(),
        given: given(value),
    })
}

fn read_keyframes(origin: &str, frames: Vec<Table>) -> Result<Vec<Keyframe>, JourneyError> {
    if !(2..=MAX_KEYFRAMES).contains(&frames.len()) {
        return Err(JourneyError::Count {
            origin: origin.into(),
            count: frames.len(),
        });
    }
    let mut keyframes: Vec<Keyframe> = Vec::with_capacity(frames.len());
    for (index, frame) in frames.into_iter().enumerate() {
        let before = keyframes.last().map(|last| last.time);
        keyframes.push(Keyframe::read(origin, index + 1, frame, before)?);
    }
    Ok(keyframes)
}

/// Checks that the velocity stays below that of light between keyframes, too: each component stays
/// between those of two keyframes, so all three at their largest must be slower than light.
fn check_velocities<'a>(
    origin: &str,
    velocities: impl Iterator<Item = Option<&'a Value>> + Clone,
) -> Result<(), JourneyError> {
    let named = velocities
        .enumerate()
        .filter_map(|(i, velocity)| Some((i + 1, velocity?)));
    for ((_, start), (number, end)) in named.clone().zip(named.skip(1)) {
        let largest = |axis| component(start, axis).abs().max(component(end, axis).abs());
        if (0..3).map(|axis| largest(axis).powi(2)).sum::<f64>() >= 1.0 {
            let before = start.quoted();
            return Err(JourneyError::Value {
                origin: origin.into(),
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

fn component(velocity: &Value, axis: usize) -> f64 {
    match velocity {
        Value::Velocity(components) => components[axis],
        _ => 0.0,
    }
}

/// The journey along these keyframes, without a title and a preset.
fn journey(keyframes: &[Keyframe], captions: Vec<Caption>) -> Journey {
    let start = keyframes[0].time;
    let kind = |frame: &Keyframe| match frame.values().get("observer")? {
        Value::Word(word) => Some((frame.time - start, ObserverKind::from_word(word)?)),
        _ => None,
    };
    let numbers = |name: &str| {
        let number = |frame: &Keyframe| {
            let value = frame.values().get(name)?.number()?;
            Some((frame.time - start, value))
        };
        keyframes.iter().filter_map(number).collect()
    };
    let of = |values: fn(&Keyframe) -> &Values| {
        tracks(
            &keyframes
                .iter()
                .map(|frame| (frame.time - start, values(frame)))
                .collect::<Vec<_>>(),
        )
    };
    Journey {
        title: String::new(),
        preset: None,
        captions,
        duration: keyframes[keyframes.len() - 1].time - start,
        times: keyframes.iter().map(|frame| frame.time).collect(),
        tracks: of(Keyframe::values),
        tracks_in_rain: of(Keyframe::values_in_rain),
        kinds: keyframes.iter().filter_map(kind).collect(),
        clock: Clock {
            rates: numbers("disk_rate"),
            times: numbers("disk_time"),
        },
    }
}

fn tracks(keyframes: &[(f64, &Values)]) -> Tracks {
    let track = |of: &dyn Fn(&Values) -> Option<f64>| {
        Track::through(
            &keyframes
                .iter()
                .filter_map(|(time, values)| Some((*time, of(values)?)))
                .collect::<Vec<_>>(),
        )
    };
    let number = |values: &Values, name: &str| values.get(name).and_then(Value::number);
    Tracks {
        radius: track(&|values| number(values, "r").map(f64::ln)),
        angles: ANGLES.map(|(name, _)| track(&|values| number(values, name))),
        field_of_view: track(&|values| number(values, "fov_deg")),
        velocity: [0, 1, 2]
            .map(|axis| track(&|values| Some(component(values.get("velocity")?, axis)))),
        disk_tilt: track(&|values| number(values, "disk_tilt_deg")),
        disk_node: track(&|values| number(values, "disk_node_deg")),
    }
}
