//! From the tables `[[stop]]` of a journey's text to its stops.

use super::error::Fault;
use super::format::{MAX_STOP_CHARS, MAX_STOP_LINES, MAX_STOPS};
use super::load::{all_noted, noted, without};
use super::read_question::read_question;
use super::stop::{InspectorView, SideBySide, Stop, is_switched};
use crate::scene::fields::field;
use crate::scene::from_toml::{flattened, float, given};
use crate::scene::hint::{hint, nearest_name};
use crate::scene::value::{Value, shortened};
use toml::Table;

/// What the table of a stop is called.
pub(super) const TABLE: &str = "stop";

/// Reads the stops of a journey whose keyframes last from `span[0]` to `span[1]` seconds.
pub(super) fn read_stops(tables: Vec<Table>, span: [f64; 2]) -> Result<Vec<Stop>, Vec<Fault>> {
    if tables.len() > MAX_STOPS {
        let count = tables.len();
        return Err(vec![Fault::StopCount { count }]);
    }
    let mut faults = Vec::new();
    let mut stops: Vec<Stop> = Vec::with_capacity(tables.len());
    let mut before = None;
    for (index, table) in tables.into_iter().enumerate() {
        let at = table.get("at").and_then(float);
        stops.extend(all_noted(read(index + 1, table, before, span), &mut faults));
        // A stop with other faults has its time all the same.
        let within = at.filter(|at| (span[0]..=span[1]).contains(at));
        let later = within.filter(|at| before.is_none_or(|before| *at > before));
        before = later.or(before);
    }
    without(faults, stops)
}

/// Reads the stop of this number, counted from 1, after one at the time `before`.
fn read(
    number: usize,
    mut table: Table,
    before: Option<f64>,
    span: [f64; 2],
) -> Result<Stop, Vec<Fault>> {
    let mut faults = Vec::new();
    let at = table.remove("at");
    let at = noted(read_time(number, at.as_ref(), before, span), &mut faults);
    let switch = |key, value: Option<toml::Value>| match value {
        None => Ok(None),
        Some(toml::Value::Boolean(on)) => Ok(Some(on)),
        other => Err(refused(number, key, other.as_ref(), "true or false".into())),
    };
    let [caption, guides, side_by_side, inspector, question] =
        ["caption", "guides", "side_by_side", "inspector", "question"].map(|key| table.remove(key));
    let guides = noted(switch("guides", guides), &mut faults);
    let side_by_side = noted(read_side_by_side(number, side_by_side), &mut faults);
    let caption = noted(read_caption(number, caption), &mut faults);
    let fields = all_noted(read_fields(number, table), &mut faults);
    let inspector = noted(read_inspector(number, inspector), &mut faults);
    let question =
        question.and_then(|question| all_noted(read_question(number, question), &mut faults));
    match at {
        Some(at) if faults.is_empty() => Ok(Stop {
            time: at - span[0],
            at,
            caption: caption.unwrap_or_default(),
            fields: fields.unwrap_or_default(),
            guides: guides.flatten(),
            side_by_side: side_by_side.flatten(),
            inspector: inspector.flatten(),
            question,
        }),
        _ => Err(faults),
    }
}

/// The time of a stop after one at the time `before`.
fn read_time(
    number: usize,
    at: Option<&toml::Value>,
    before: Option<f64>,
    [start, end]: [f64; 2],
) -> Result<f64, Fault> {
    let given = at.and_then(float);
    let within = given.filter(|at| (start..=end).contains(at));
    let later = within.filter(|at| before.is_none_or(|before| *at > before));
    later.ok_or_else(|| {
        let allowed = match before {
            Some(before) if within.is_some() => {
                format!("above {before}, the time of the stop before")
            }
            _ => format!("a number of seconds from {start} to {end}, within the journey"),
        };
        let ends_before = given.is_some_and(|at| at > end);
        let remark = if ends_before {
            ": the last [[keyframe]] must be as late as the last [[stop]]"
        } else {
            ""
        };
        refused(number, "at", at, allowed + remark)
    })
}

/// The fault of a value of the stop of this number; `None` is missing.
pub(super) fn refused(
    number: usize,
    key: &'static str,
    value: Option<&toml::Value>,
    allowed: String,
) -> Fault {
    Fault::Value {
        table: TABLE,
        number,
        key,
        given: value.map(given),
        allowed,
    }
}

/// The caption's lines, without the empty ones around them.
fn read_caption(number: usize, value: Option<toml::Value>) -> Result<String, Fault> {
    let Some(value) = value else {
        return Ok(String::new());
    };
    let text = value.as_str().map(|text| text.replace("\r\n", "\n"));
    let text = text.map(|text| text.trim().to_owned());
    let fits = |text: &String| {
        let lines = text.split('\n').count();
        let is_printed = |c: char| c == '\n' || !c.is_control();
        lines <= MAX_STOP_LINES
            && text.chars().count() <= MAX_STOP_CHARS
            && text.chars().all(is_printed)
    };
    text.filter(fits).ok_or_else(|| {
        let allowed =
            format!("a text of at most {MAX_STOP_LINES} lines and {MAX_STOP_CHARS} characters");
        refused(number, "caption", Some(&value), allowed)
    })
}

/// Fields of the scene: single ones such as `view`, and those in a table such as `effects.doppler`.
fn read_fields(number: usize, table: Table) -> Result<Vec<(&'static str, Value)>, Vec<Fault>> {
    let (mut fields, mut faults) = (Vec::new(), Vec::new());
    for (key, value) in flattened(table) {
        fields.extend(noted(read_field(number, &key, &value), &mut faults));
    }
    without(faults, fields)
}

fn read_field(
    number: usize,
    key: &str,
    value: &toml::Value,
) -> Result<(&'static str, Value), Fault> {
    let unknown = |hint: String| Fault::StopKey {
        number,
        key: shortened(key),
        hint,
    };
    // A quoted key with a dot in it is no field.
    let found = field(key).filter(|_| key.matches('.').count() <= 1);
    let field = found.ok_or_else(|| unknown(hint_of_stop(key)))?;
    if !is_switched(field) {
        let hint = "no stop switches it; keyframes lead the camera, the observer and the disk's \
            tilt and clock"
            .into();
        return Err(unknown(hint));
    }
    let read = field.read_in_range(value);
    let value = read.map_err(|refusal| Fault::Value {
        table: TABLE,
        number,
        key: field.key,
        given: Some(refusal.given),
        allowed: refusal.allowed,
    })?;
    Ok((field.key, value))
}

/// The fault of the first stop that switches a field that keyframes set: a field has one leader.
pub(super) fn set_elsewhere(stops: &[Stop], is_set: impl Fn(&str) -> bool) -> Option<Fault> {
    let mut switched = stops.iter().enumerate().flat_map(|(index, stop)| {
        let fields = stop.fields.iter();
        fields.map(move |(key, _)| (index + 1, *key))
    });
    let (number, key) = switched.find(|(_, key)| is_set(key))?;
    Some(Fault::StopKey {
        number,
        key: key.into(),
        hint: "no stop switches it, because the table set of a [[keyframe]] leads it".into(),
    })
}

/// What to write instead of an unknown key of a stop.
fn hint_of_stop(key: &str) -> String {
    const OWN: [&str; 6] = [
        "at",
        "caption",
        "guides",
        "side_by_side",
        "inspector",
        "question",
    ];
    match nearest_name(key, &OWN) {
        // Keyframes and captions have a time, and a field of scenes has that name, too.
        _ if key == "time" => "did you mean at?".into(),
        Some(own) => format!("did you mean {own}?"),
        None => hint(key),
    }
}

/// The word for two whole pictures.
pub(super) const TWO_PICTURES: &str = "two-pictures";

fn read_side_by_side(
    number: usize,
    value: Option<toml::Value>,
) -> Result<Option<SideBySide>, Fault> {
    match value {
        None => Ok(None),
        Some(toml::Value::Boolean(false)) => Ok(Some(SideBySide::Off)),
        Some(toml::Value::Boolean(true)) => Ok(Some(SideBySide::Divided)),
        Some(toml::Value::String(word)) if word == TWO_PICTURES => {
            Ok(Some(SideBySide::TwoPictures))
        }
        other => {
            let allowed = format!("true, false or \"{TWO_PICTURES}\"");
            Err(refused(number, "side_by_side", other.as_ref(), allowed))
        }
    }
}

fn read_inspector(
    number: usize,
    value: Option<toml::Value>,
) -> Result<Option<InspectorView>, Fault> {
    const ALLOWED: &str = "true, false, { at = [x, y] } with shares of the picture's width and \
        height from 0 to 1, or { toward = [outward, theta, phi] } with a direction";
    let read = |value: &toml::Value| match value {
        toml::Value::Boolean(false) => Some(InspectorView::Closed),
        toml::Value::Boolean(true) => Some(InspectorView::Open),
        toml::Value::Table(table) if table.len() == 1 => {
            let (key, value) = table.iter().next()?;
            let numbers = value.as_array()?.iter().map(float);
            let numbers = numbers.collect::<Option<Vec<f64>>>()?;
            match (key.as_str(), numbers.as_slice()) {
                ("at", &[x, y]) if [x, y].iter().all(|x| (0.0..=1.0).contains(x)) => {
                    Some(InspectorView::Place([x, y]))
                }
                ("toward", &[r, theta, phi]) => {
                    let length = r.hypot(theta).hypot(phi);
                    (length > 0.0 && length.is_finite())
                        .then_some(InspectorView::Toward([r, theta, phi]))
                }
                _ => None,
            }
        }
        _ => None,
    };
    match value {
        None => Ok(None),
        Some(value) => match read(&value) {
            Some(inspected) => Ok(Some(inspected)),
            None => Err(refused(number, "inspector", Some(&value), ALLOWED.into())),
        },
    }
}
