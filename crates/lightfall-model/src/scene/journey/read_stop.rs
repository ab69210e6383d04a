//! From the tables `[[stop]]` of a journey's text to its stops.

use super::error::Fault;
use super::format::{MAX_STOP_CHARS, MAX_STOP_LINES, MAX_STOPS};
use super::stop::{InspectorView, SideBySide, Stop, is_switched};
use crate::scene::Question;
use crate::scene::fields::field;
use crate::scene::from_toml::{float, given};
use crate::scene::hint::{hint, is_table};
use crate::scene::value::{Value, shortened};
use toml::Table;

/// What the table of a stop is called.
pub(super) const TABLE: &str = "stop";
/// The largest number of characters of a question, and of a unit.
const MAX_QUESTION_CHARS: usize = 400;
const MAX_UNIT_CHARS: usize = 20;

/// Reads the stops of a journey whose keyframes last from `span[0]` to `span[1]` seconds.
pub(super) fn read_stops(tables: Vec<Table>, span: [f64; 2]) -> Result<Vec<Stop>, Fault> {
    if tables.len() > MAX_STOPS {
        let count = tables.len();
        return Err(Fault::StopCount { count });
    }
    let mut stops: Vec<Stop> = Vec::with_capacity(tables.len());
    for (index, table) in tables.into_iter().enumerate() {
        let before = stops.last().map(|last| last.at);
        stops.push(read(index + 1, table, before, span)?);
    }
    Ok(stops)
}

/// Reads the stop of this number, counted from 1, after one at the time `before`.
fn read(
    number: usize,
    mut table: Table,
    before: Option<f64>,
    [start, end]: [f64; 2],
) -> Result<Stop, Fault> {
    let at = table.remove("at");
    let within = |at: &f64| (start..=end).contains(at);
    let time = at.as_ref().and_then(float).filter(within);
    let time = time.filter(|at| before.is_none_or(|before| *at > before));
    let time = time.ok_or_else(|| {
        let allowed = match before {
            Some(before) if at.as_ref().and_then(float).is_some_and(|at| within(&at)) => {
                format!("above {before}, the time of the stop before")
            }
            _ => format!("a number of seconds from {start} to {end}, within the journey"),
        };
        refused(number, "at", at.as_ref(), allowed)
    })?;
    let switch = |key, value: Option<toml::Value>| match value {
        None => Ok(None),
        Some(toml::Value::Boolean(on)) => Ok(Some(on)),
        other => Err(refused(number, key, other.as_ref(), "true or false".into())),
    };
    let caption = table.remove("caption");
    let guides = switch("guides", table.remove("guides"))?;
    let side_by_side = read_side_by_side(number, table.remove("side_by_side"))?;
    let inspector = table.remove("inspector");
    let question = table.remove("question");
    Ok(Stop {
        time: time - start,
        at: time,
        caption: read_caption(number, caption)?,
        fields: read_fields(number, table)?,
        guides,
        side_by_side,
        inspector: read_inspector(number, inspector)?,
        question: question
            .map(|question| read_question(number, question))
            .transpose()?,
    })
}

fn refused(
    number: usize,
    key: &'static str,
    value: Option<&toml::Value>,
    allowed: String,
) -> Fault {
    Fault::Value {
        table: TABLE,
        number,
        key,
        given: value.map_or_else(|| "nothing".into(), given),
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
fn read_fields(number: usize, table: Table) -> Result<Vec<(&'static str, Value)>, Fault> {
    let mut fields = Vec::new();
    for (key, value) in table {
        match value {
            toml::Value::Table(inner) if is_table(&key) => {
                for (name, value) in inner {
                    fields.push(read_field(number, format!("{key}.{name}"), &value)?);
                }
            }
            value => fields.push(read_field(number, key, &value)?),
        }
    }
    Ok(fields)
}

fn read_field(
    number: usize,
    key: String,
    value: &toml::Value,
) -> Result<(&'static str, Value), Fault> {
    let unknown = |hint: String| Fault::StopKey {
        line: None,
        number,
        key: shortened(&key),
        hint,
    };
    // A quoted key with a dot in it is no field.
    let found = field(&key).filter(|_| key.matches('.').count() <= 1);
    let field = found.ok_or_else(|| unknown(hint(&key)))?;
    if !is_switched(field) {
        let hint = "no stop switches it; keyframes lead the camera, the observer and the disk's \
            tilt and clock"
            .into();
        return Err(unknown(hint));
    }
    let refused = |given| Fault::Value {
        table: TABLE,
        number,
        key: field.key,
        given,
        allowed: field.allowed(),
    };
    let value = field
        .read(value)
        .map_err(|refusal| refused(refusal.given))?;
    match value.number() {
        Some(number) if !field.kind.range().contains(number) => Err(refused(value.quoted())),
        _ => Ok((field.key, value)),
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

fn read_question(number: usize, value: toml::Value) -> Result<Question, Fault> {
    const ALLOWED: &str =
        "a table with text, answer and tolerance, and unit or hint if there is one";
    let toml::Value::Table(mut table) = value else {
        return Err(refused(
            number,
            TABLE_OF_QUESTION,
            Some(&value),
            ALLOWED.into(),
        ));
    };
    let [text, answer, tolerance, unit, hint] =
        ["text", "answer", "tolerance", "unit", "hint"].map(|key| table.remove(key));
    if let Some(key) = table.keys().next() {
        return Err(Fault::StopKey {
            line: None,
            number,
            key: format!("question.{}", shortened(key)),
            hint: format!("a question is {ALLOWED}"),
        });
    }
    let line = |key, value: Option<&toml::Value>, most: usize| {
        let text = value.and_then(toml::Value::as_str).map(str::trim);
        let fits = |text: &&str| {
            !text.is_empty() && text.chars().count() <= most && !text.chars().any(char::is_control)
        };
        text.filter(fits).map(str::to_owned).ok_or_else(|| {
            let allowed = format!("one line of text, from 1 to {most} characters long");
            refused(number, key, value, allowed)
        })
    };
    let finite = |key, value: Option<&toml::Value>, least: f64, allowed: &str| {
        let number_given = value.and_then(float);
        let number_given = number_given.filter(|x| x.is_finite() && *x >= least);
        number_given.ok_or_else(|| refused(number, key, value, allowed.into()))
    };
    Ok(Question {
        text: line("question.text", text.as_ref(), MAX_QUESTION_CHARS)?,
        answer: finite(
            "question.answer",
            answer.as_ref(),
            f64::MIN,
            "a finite number",
        )?,
        tolerance: finite(
            "question.tolerance",
            tolerance.as_ref(),
            0.0,
            "a finite number, not negative",
        )?,
        unit: match &unit {
            None => String::new(),
            unit => line("question.unit", unit.as_ref(), MAX_UNIT_CHARS)?,
        },
        hint: match &hint {
            None => String::new(),
            hint => line("question.hint", hint.as_ref(), MAX_QUESTION_CHARS)?,
        },
    })
}

/// The key of a stop's question.
const TABLE_OF_QUESTION: &str = "question";
