//! From the text of a journey to the journey.

use super::Journey;
use super::caption::{allowed_line, line, read_captions};
use super::clock::Clock;
use super::error::{Fault, JourneyError};
use super::field_tracks::FieldTracks;
use super::format::MAX_KEYFRAMES;
use super::keyframe::{Keyframe, TABLE, Values};
use super::read_stop::{read_stops, set_elsewhere};
use super::tracks::{Tracks, component, may_reach_light};
use crate::scene::ObserverKind;
use crate::scene::fields::field;
use crate::scene::from_toml::{float, given, table};
use crate::scene::hint::is_table;
use crate::scene::presets::{self, Preset};
use crate::scene::value::{Value, shortened};
use toml::Table;

/// Makes a journey of its TOML `text`. `origin` names it in messages.
///
/// # Errors
/// One sentence that names the file, the line, the keyframe or caption, what was given and what is allowed.
/// The error has those of further faults, too.
pub fn load(origin: &str, text: &str) -> Result<Journey, JourneyError> {
    let journey = table(text)
        .map_err(|fault| vec![Fault::from(fault)])
        .and_then(journey);
    journey.map_err(|faults| JourneyError::new(origin, text, faults))
}

/// What was read. A fault goes to the others, so that reading can go on.
pub(super) fn noted<T>(read: Result<T, Fault>, faults: &mut Vec<Fault>) -> Option<T> {
    read.map_err(|fault| faults.push(fault)).ok()
}

/// As [`noted`], for several faults.
pub(super) fn all_noted<T>(read: Result<T, Vec<Fault>>, faults: &mut Vec<Fault>) -> Option<T> {
    read.map_err(|several| faults.extend(several)).ok()
}

/// What was read, unless there were faults.
pub(super) fn without<T>(faults: Vec<Fault>, read: T) -> Result<T, Vec<Fault>> {
    if faults.is_empty() {
        Ok(read)
    } else {
        Err(faults)
    }
}

/// The journey that a TOML table describes, or what is wrong with it.
fn journey(table: Table) -> Result<Journey, Vec<Fault>> {
    let mut faults = Vec::new();
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
            ("teaches", value) => {
                teaches = noted(read_line("teaches", &value), &mut faults).unwrap_or_default();
            }
            ("ending", value) => {
                ending = noted(read_line("ending", &value), &mut faults).unwrap_or_default();
            }
            ("preset", value) => preset = noted(read_preset(&value), &mut faults),
            ("keyframe", toml::Value::Array(values)) if is_list_of_tables(&values) => {
                frames = tables(values);
            }
            ("caption", toml::Value::Array(values)) if is_list_of_tables(&values) => {
                captions = tables(values);
            }
            ("stop", toml::Value::Array(values)) if is_list_of_tables(&values) => {
                stops = tables(values);
            }
            ("keyframe" | "caption" | "stop", toml::Value::Table(_)) => {
                faults.push(Fault::OneTable { key: key.clone() });
            }
            // A preset has many of them.
            (key, _) if is_table(key) => {
                faults.push(Fault::FieldOfScenes { key: key.into() });
                return Err(faults);
            }
            (_, value) => faults.push(Fault::Top {
                key: shortened(&key),
                given: given(&value),
            }),
        }
    }
    let count = frames.len();
    // Captions and stops can be read where the times of the first and the last keyframe can.
    let time = |frame: Option<&Table>| frame?.get("time").and_then(float);
    let span = time(frames.first()).zip(time(frames.last()));
    let keyframes = all_noted(read_keyframes(frames), &mut faults);
    let span = span.filter(|(start, end)| start <= end);
    let captions =
        span.and_then(|(start, end)| all_noted(read_captions(captions, [start, end]), &mut faults));
    let stops =
        span.and_then(|(start, end)| all_noted(read_stops(stops, [start, end]), &mut faults));
    match (keyframes, captions, stops) {
        (Some(keyframes), Some(captions), Some(stops)) if faults.is_empty() => {
            let [values, in_rain] = values_of(&keyframes);
            let too_fast = [&values, &in_rain].map(|values| check_velocities(values.iter()));
            if let Some(fault) = too_fast.into_iter().find_map(Result::err) {
                return Err(vec![fault]);
            }
            let set = |key: &str| keyframes.iter().any(|frame| frame.set.contains_key(key));
            if let Some(fault) = set_elsewhere(&stops, set) {
                return Err(vec![fault]);
            }
            Ok(Journey {
                title,
                teaches,
                ending,
                preset,
                captions,
                stops,
                ..flown(keyframes, [values, in_rain])
            })
        }
        // Without a time there was a fault.
        _ if faults.is_empty() => Err(vec![Fault::Count { count }]),
        _ => Err(faults),
    }
}

/// The values of keyframes for every observer, and for one that falls freely.
fn values_of(keyframes: &[Keyframe]) -> [Vec<Values>; 2] {
    let values = keyframes.iter().map(|frame| frame.values.clone());
    let in_rain = keyframes.iter().map(Keyframe::values_in_rain);
    [values.collect(), in_rain.collect()]
}

/// A journey through keyframes, of which there are at least two, without words and stops.
fn flown(keyframes: Vec<Keyframe>, [values, in_rain]: [Vec<Values>; 2]) -> Journey {
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
        let frames = keyframes.iter().zip(values);
        let frames = frames.map(|(frame, values)| (frame.time - start, frame.ease, values));
        Tracks::through(&frames.collect::<Vec<_>>())
    };
    let set = keyframes
        .iter()
        .map(|frame| (frame.time - start, frame.ease, &frame.set));
    let fields = FieldTracks::through(&set.collect::<Vec<_>>());
    Journey {
        duration: end - start,
        tracks: tracks(&values),
        tracks_in_rain: tracks(&in_rain),
        fields,
        kinds: keyframes.iter().filter_map(kind).collect(),
        clock: Clock {
            rates: numbers("disk_rate"),
            times: numbers("disk_time"),
        },
        keyframes,
        ..Journey::empty()
    }
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

fn read_keyframes(frames: Vec<Table>) -> Result<Vec<Keyframe>, Vec<Fault>> {
    let count = frames.len();
    if !(2..=MAX_KEYFRAMES).contains(&count) {
        return Err(vec![Fault::Count { count }]);
    }
    let mut faults = Vec::new();
    let mut keyframes: Vec<Keyframe> = Vec::with_capacity(count);
    for (index, frame) in frames.into_iter().enumerate() {
        let before = keyframes.last().map(|last| last.time);
        keyframes.extend(noted(Keyframe::read(index + 1, frame, before), &mut faults));
    }
    without(faults, keyframes)
}

/// Checks that the velocity stays below that of light between keyframes, too.
fn check_velocities<'a>(keyframes: impl Iterator<Item = &'a Values> + Clone) -> Result<(), Fault> {
    let named = keyframes
        .enumerate()
        .filter_map(|(i, values)| Some((i + 1, values.get("velocity")?)));
    for ((_, start), (number, end)) in named.clone().zip(named.skip(1)) {
        let [from, to] = [start, end]
            .map(|velocity| [0, 1, 2].map(|axis| component(velocity, axis).unwrap_or_default()));
        if may_reach_light(from, to) {
            let before = start.quoted();
            return Err(Fault::Value {
                table: TABLE,
                number,
                key: "velocity",
                given: Some(end.quoted()),
                allowed: format!(
                    "nearer to that of the keyframe before, {before}: on the way there it would reach 1 c"
                ),
            });
        }
    }
    Ok(())
}
