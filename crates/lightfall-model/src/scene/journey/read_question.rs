//! The question of a stop: a table, each of whose faults is told.

use super::error::Fault;
use super::load::noted;
use super::read_stop::refused;
use crate::scene::Question;
use crate::scene::from_toml::float;
use crate::scene::nearest_name;
use crate::scene::value::shortened;

/// The key of a stop's question.
const TABLE_OF_QUESTION: &str = "question";
/// The largest number of characters of a question, and of a unit.
const MAX_QUESTION_CHARS: usize = 400;
const MAX_UNIT_CHARS: usize = 20;

/// Reads the question of the stop of this number.
pub(super) fn read_question(number: usize, value: toml::Value) -> Result<Question, Vec<Fault>> {
    const ALLOWED: &str =
        "a table with text, answer and tolerance, and unit or hint if there is one";
    let toml::Value::Table(mut table) = value else {
        let allowed = ALLOWED.into();
        return Err(vec![refused(
            number,
            TABLE_OF_QUESTION,
            Some(&value),
            allowed,
        )]);
    };
    let mut faults = Vec::new();
    const KEYS: [&str; 5] = ["text", "answer", "tolerance", "unit", "hint"];
    let [text, answer, tolerance, unit, hint] = KEYS.map(|key| table.remove(key));
    faults.extend(table.keys().map(|key| Fault::StopKey {
        number,
        key: format!("question.{}", shortened(key)),
        hint: match nearest_name(key, &KEYS) {
            Some(meant) => format!("did you mean question.{meant}?"),
            None => format!("a question is {ALLOWED}"),
        },
    }));
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
    let finite = |key, value: Option<&toml::Value>, above: f64, allowed: &str| {
        let number_given = value.and_then(float);
        let number_given = number_given.filter(|x| x.is_finite() && *x > above);
        number_given.ok_or_else(|| refused(number, key, value, allowed.into()))
    };
    let optional = |key, value: Option<&toml::Value>, most| match value {
        None => Ok(String::new()),
        value => line(key, value, most),
    };
    let text = line("question.text", text.as_ref(), MAX_QUESTION_CHARS);
    let text = noted(text, &mut faults);
    let any = f64::NEG_INFINITY;
    let answer = finite("question.answer", answer.as_ref(), any, "a finite number");
    let answer = noted(answer, &mut faults);
    let positive = "a finite number above 0";
    let tolerance = finite("question.tolerance", tolerance.as_ref(), 0.0, positive);
    let tolerance = noted(tolerance, &mut faults);
    let unit = optional("question.unit", unit.as_ref(), MAX_UNIT_CHARS);
    let unit = noted(unit, &mut faults);
    let hint = optional("question.hint", hint.as_ref(), MAX_QUESTION_CHARS);
    let hint = noted(hint, &mut faults);
    match (text, answer, tolerance) {
        (Some(text), Some(answer), Some(tolerance)) if faults.is_empty() => Ok(Question {
            text,
            answer,
            tolerance,
            unit: unit.unwrap_or_default(),
            hint: hint.unwrap_or_default(),
        }),
        _ => Err(faults),
    }
}
