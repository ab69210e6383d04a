//! From the text of a journey to the journey.

use super::{ANGLES, Journey, Track, Tracks};
use crate::scene::error::{Refusal, SceneError};
use crate::scene::fields::{Field, Kind, Range, field};
use crate::scene::limits::{given, shortened};
use crate::scene::load::{coerce_integers, syntax};
use crate::scene::{ObserverKind, SCHEMA};
use serde::Deserialize;
use thiserror::Error;
use toml::{Table, Value};

/// Most keyframes of a journey.
const MAX_KEYFRAMES: usize = 1000;
/// Longest journey, in seconds.
const MAX_LENGTH: f64 = 86_400.0;

/// What a keyframe may have: its name there, and the field of a scene that says what it may be.
/// Angles may be of any number of turns here.
const NAMES: [(&str, &str); 9] = [
    ("r", "camera.r"),
    ("theta_deg", "camera.theta_deg"),
    ("phi_deg", ""),
    ("yaw_deg", ""),
    ("pitch_deg", ""),
    ("roll_deg", ""),
    ("fov_deg", "camera.fov_deg"),
    ("observer", "observer.kind"),
    ("velocity", "observer.velocity"),
];

const ANY_ANGLE: Field = Field {
    key: "",
    kind: Kind::Float(Range::FINITE),
    unit: "of degrees",
    about: "",
};

/// Why a text is no journey. `origin` is its file; keyframes count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum JourneyError {
    /// The text is not TOML, or of another version.
    #[error(transparent)]
    Text(#[from] SceneError),
    /// Something at the top that does not belong there, or is of the wrong type.
    #[error(
        "{origin}: {key} = {given} is refused: a journey has schema = 1, title = \"...\" and tables [[keyframe]]"
    )]
    Top {
        /// Where it was written.
        origin: String,
        /// The key.
        key: String,
        /// Its value.
        given: String,
    },
    /// Too few or too many keyframes.
    #[error(
        "{origin}: a journey has from 2 to {MAX_KEYFRAMES} tables [[keyframe]], and here are {count}"
    )]
    Count {
        /// Where it was written.
        origin: String,
        /// How many there are.
        count: usize,
    },
    /// A keyframe without its time, or not after the one before.
    #[error("{origin}: keyframe {number}: time = {given} is refused: it must be {allowed}")]
    Time {
        /// Where it was written.
        origin: String,
        /// Which keyframe.
        number: usize,
        /// What was given.
        given: String,
        /// What it may be.
        allowed: String,
    },
    /// A keyframe with something it cannot have.
    #[error(
        "{origin}: keyframe {number}: there is no {key}; a keyframe has time, any of {}, and a table rain of those but \
             the observer for who falls from rest at infinity",
        names()
    )]
    UnknownKey {
        /// Where it was written.
        origin: String,
        /// Which keyframe.
        number: usize,
        /// The name.
        key: String,
    },
    /// A value of the wrong type or out of range.
    #[error("{origin}: keyframe {number}: {key} = {given} is refused: it must be {allowed}")]
    Value {
        /// Where it was written.
        origin: String,
        /// Which keyframe.
        number: usize,
        /// The name.
        key: &'static str,
        /// What was given.
        given: String,
        /// What it may be.
        allowed: String,
    },
}

fn names() -> String {
    NAMES.map(|(name, _)| name).join(", ")
}

/// Makes a journey of its TOML `text`. `origin` names it in messages.
///
/// # ErrorSummary
/// One sentence that names the file, the keyframe, what was given and what is allowed.
pub fn load(origin: &str, text: &str) -> Result<Journey, JourneyError> {
    let table: Table = toml::from_str(text).map_err(|error| syntax(origin, text, &error))?;
    let (mut title, mut frames) = (String::new(), Vec::new());
    for (key, value) in table {
        match (key.as_str(), value) {
            ("schema", Value::Integer(number)) if number == i64::from(SCHEMA) => {}
            ("schema", value @ Value::Integer(_)) => {
                return Err(SceneError::Schema {
                    origin: origin.into(),
                    given: given(&value),
                }
                .into());
            }
            ("title", Value::String(text))
                if field("title").is_some_and(|f| f.check_type(&text.clone().into()).is_ok()) =>
            {
                title = text;
            }
            ("keyframe", Value::Array(values)) if values.iter().all(Value::is_table) => {
                frames = values
                    .into_iter()
                    .filter_map(|value| value.as_table().cloned())
                    .collect();
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
    if !(2..=MAX_KEYFRAMES).contains(&frames.len()) {
        return Err(JourneyError::Count {
            origin: origin.into(),
            count: frames.len(),
        });
    }
    let mut keyframes: Vec<Keyframe> = Vec::with_capacity(frames.len());
    for (index, frame) in frames.into_iter().enumerate() {
        keyframes.push(keyframe(
            origin,
            index + 1,
            frame,
            keyframes.last().map(|last| last.time),
        )?);
    }
    check_velocities(
        origin,
        keyframes.iter().map(|frame| frame.values.get("velocity")),
    )?;
    check_velocities(
        origin,
        keyframes
            .iter()
            .map(|frame| frame.values_in_rain.get("velocity")),
    )?;
    Ok(journey(title, &keyframes))
}

/// One keyframe, each value checked.
struct Keyframe {
    time: f64,
    values: Table,
    /// The same, with what is otherwise in rain.
    values_in_rain: Table,
}

fn keyframe(
    origin: &str,
    number: usize,
    mut frame: Table,
    before: Option<f64>,
) -> Result<Keyframe, JourneyError> {
    let origin = || origin.to_owned();
    let time = frame
        .remove("time")
        .map(|time| coerce_integers(Kind::Float(Range::FINITE), time));
    let seconds = time.as_ref().and_then(Value::as_float).unwrap_or(f64::NAN);
    let allowed = match before {
        Some(last) if seconds.is_nan() || seconds <= last => {
            format!("a number of seconds above {last}, that of the keyframe before")
        }
        _ => format!("a number of seconds from 0 to {MAX_LENGTH}"),
    };
    if !(0.0..=MAX_LENGTH).contains(&seconds) || before.is_some_and(|last| seconds <= last) {
        let given = time.as_ref().map_or("nothing".into(), given);
        return Err(JourneyError::Time {
            origin: origin(),
            number,
            given,
            allowed,
        });
    }
    let in_rain = match frame.remove("rain") {
        Some(Value::Table(in_rain)) => in_rain,
        Some(_) => {
            return Err(JourneyError::UnknownKey {
                origin: origin(),
                number,
                key: "value rain".into(),
            });
        }
        None => Table::new(),
    };
    if in_rain.contains_key("observer") {
        return Err(JourneyError::UnknownKey {
            origin: origin(),
            number,
            key: "rain.observer".into(),
        });
    }
    let values = checked(&origin(), number, frame)?;
    let mut values_in_rain = values.clone();
    values_in_rain.extend(checked(&origin(), number, in_rain)?);
    Ok(Keyframe {
        time: seconds,
        values,
        values_in_rain,
    })
}

/// The values of a keyframe, each by its name.
fn checked(origin: &str, number: usize, frame: Table) -> Result<Table, JourneyError> {
    let origin = || origin.to_owned();
    let mut values = Table::new();
    for (key, value) in frame {
        let Some((name, like)) = NAMES.into_iter().find(|(name, _)| *name == key) else {
            return Err(JourneyError::UnknownKey {
                origin: origin(),
                number,
                key: shortened(&key),
            });
        };
        let field = field(like).unwrap_or(&ANY_ANGLE);
        let value = coerce_integers(field.kind, value);
        let inside = match (field.kind, value.as_float()) {
            (Kind::Float(range), Some(number)) => range.contains(number),
            _ => true,
        };
        let refusal = |given| JourneyError::Value {
            origin: origin(),
            number,
            key: name,
            given,
            allowed: field.allowed(),
        };
        field
            .check_type(&value)
            .map_err(|Refusal { given, .. }| refusal(given))?;
        if !inside {
            return Err(refusal(given(&value)));
        }
        values.insert(key, value);
    }
    Ok(values)
}

/// Each component stays between those of two keyframes, but all three at their largest must still
/// be slower than light.
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
            let before = given(start);
            let allowed = format!(
                "nearer to that of the keyframe before, {before}: on the way there it would reach 1 c"
            );
            let (origin, given) = (origin.into(), given(end));
            return Err(JourneyError::Value {
                origin,
                number,
                key: "velocity",
                given,
                allowed,
            });
        }
    }
    Ok(())
}

fn component(velocity: &Value, axis: usize) -> f64 {
    velocity
        .as_array()
        .and_then(|all| all.get(axis))
        .and_then(Value::as_float)
        .unwrap_or(0.0)
}

fn journey(title: String, keyframes: &[Keyframe]) -> Journey {
    let start = keyframes[0].time;
    let kind = |frame: &Keyframe| {
        let kind = ObserverKind::deserialize(frame.values.get("observer")?.clone()).ok()?;
        Some((frame.time - start, kind))
    };
    let of = |values: fn(&Keyframe) -> &Table| {
        tracks(
            &keyframes
                .iter()
                .map(|frame| (frame.time - start, values(frame)))
                .collect::<Vec<_>>(),
        )
    };
    Journey {
        title,
        duration: keyframes[keyframes.len() - 1].time - start,
        times: keyframes.iter().map(|frame| frame.time).collect(),
        tracks: of(|frame| &frame.values),
        tracks_in_rain: of(|frame| &frame.values_in_rain),
        kinds: keyframes.iter().filter_map(kind).collect(),
    }
}

fn tracks(keyframes: &[(f64, &Table)]) -> Tracks {
    let track = |of: &dyn Fn(&Table) -> Option<f64>| {
        Track::through(
            &keyframes
                .iter()
                .filter_map(|(time, values)| Some((*time, of(values)?)))
                .collect::<Vec<_>>(),
        )
    };
    let number = |values: &Table, name: &str| values.get(name).and_then(Value::as_float);
    Tracks {
        radius: track(&|values| number(values, "r").map(f64::ln)),
        angles: ANGLES.map(|(name, _)| track(&|values| number(values, name))),
        field_of_view: track(&|values| number(values, "fov_deg")),
        velocity: [0, 1, 2]
            .map(|axis| track(&|values| Some(component(values.get("velocity")?, axis)))),
    }
}
