//! Texts that are TOML, and have other fields or values than their reader asks for.

use super::head::{name_in_head, one_table, several_tables};
use super::tokens::Tokens;
use super::{Located, TomlFault, first_line, shown};
use crate::scene::nearest_name;
use std::ops::Range;
use toml::de::{DeTable, DeValue, Error};

/// What is wrong with a text that was read as TOML and then refused with this error.
pub(super) fn told(text: &str, document: &DeTable<'_>, error: &Error) -> TomlFault {
    let span = error.span().unwrap_or_default();
    let at = text.floor_char_boundary(span.start);
    let name = name_at(document, &span);
    let message = error.message();
    if let Some(rest) = message.strip_prefix("missing field ") {
        let field = in_backticks(rest).next().unwrap_or(rest);
        return match name {
            Some(table) => TomlFault::at(text, at, format!("{table} has no field `{field}`")),
            None => TomlFault(Located {
                line: None,
                what: format!("the field `{field}` is missing"),
            }),
        };
    }
    TomlFault::at(text, at, said(text, &span, name, message))
}

fn said(text: &str, span: &Range<usize>, name: Option<String>, message: &str) -> String {
    if let Some(rest) = message.strip_prefix("unknown field ") {
        return unknown_field(rest);
    }
    let at = text.floor_char_boundary(span.start);
    let head = name_in_head(Tokens::new(text).line(at));
    let expected = message.rsplit_once(", expected ");
    let expected = expected.map(|(_, expected)| expected);
    match head {
        Some((head, true)) => return several_tables(head),
        Some((head, false)) if expected == Some("a sequence") => return one_table(head),
        _ => {}
    }
    let given = text.get(span.clone()).unwrap_or_default();
    let refused = |allowed: &str| {
        let given = first_line(given);
        match &name {
            Some(name) => format!("{name} = {given} is refused: it must be {allowed}"),
            None => format!("{given} is refused: it must be {allowed}"),
        }
    };
    if let Some(rest) = message.strip_prefix("unknown variant ") {
        return refused(&one_of(rest));
    }
    // Whole numbers of more than 64 bits, in the words of the parser for each size.
    let too_large = ["overflow", "too large", "any valid TOML value"];
    if too_large.iter().any(|words| message.contains(*words)) {
        return refused("a smaller number");
    }
    if message.starts_with("wanted ") {
        return refused("a word in quotes");
    }
    let is_of_type = ["invalid type", "invalid value", "invalid length"];
    match expected {
        Some(expected) if is_of_type.iter().any(|start| message.starts_with(*start)) => {
            refused(&in_words(expected))
        }
        // What the reader of the field says itself.
        _ => match (message.strip_prefix("it must be "), &name) {
            (Some(allowed), _) => refused(allowed),
            (None, Some(name)) => format!("{name}: {message}"),
            (None, None) => message.into(),
        },
    }
}

/// What is said of an unknown field, from the parser's words behind `unknown field`: its name, and the names
/// that are known.
fn unknown_field(rest: &str) -> String {
    let mut names = in_backticks(rest);
    let given = names.next().unwrap_or_default();
    let known: Vec<&str> = names.collect();
    match nearest_name(given, &known) {
        Some(meant) => format!("unknown field `{given}`; did you mean `{meant}`?"),
        None => format!(
            "unknown field {}; known are {}",
            shown(given),
            known.join(", ")
        ),
    }
}

/// The words of a choice, from the parser's words behind `unknown variant`: the given one, and the known ones.
fn one_of(rest: &str) -> String {
    let mut words = in_backticks(rest);
    let given = words.next().unwrap_or_default();
    let known: Vec<&str> = words.collect();
    let hint = nearest_name(given, &known).map(|meant| format!("; did you mean {meant}?"));
    format!("one of {}{}", known.join(", "), hint.unwrap_or_default())
}

fn in_backticks(words: &str) -> impl Iterator<Item = &str> {
    words.split('`').skip(1).step_by(2)
}

/// What a value must be, from the name of its type.
fn in_words(expected: &str) -> String {
    match expected {
        "f32" | "f64" => "a number".into(),
        "u8" | "u16" | "u32" | "u64" | "usize" | "i8" | "i16" | "i32" | "i64" | "isize" => {
            "a whole number".into()
        }
        "a boolean" => "true or false".into(),
        "a string" => "a text in quotes".into(),
        "a sequence" => "a list between `[` and `]`".into(),
        "a map" => "a table of fields".into(),
        _ if expected.starts_with("struct ") => "a table of fields".into(),
        _ => match expected.strip_prefix("an array of length ") {
            Some(length) => format!("a list of {length} values between `[` and `]`"),
            None => expected.into(),
        },
    }
}

/// The name of the field or of the table with this place, such as `start.r` or `goal 2: hold`. Tables of a list
/// and values of one count from 1.
fn name_at(table: &DeTable<'_>, span: &Range<usize>) -> Option<String> {
    table.iter().find_map(|(key, value)| {
        let name = key.get_ref();
        let inside = match value.get_ref() {
            DeValue::Table(inside) => name_at(inside, span).map(|rest| format!("{name}.{rest}")),
            DeValue::Array(items) => items.iter().enumerate().find_map(|(index, item)| {
                let numbered = format!("{name} {}", index + 1);
                let inside = match item.get_ref() {
                    DeValue::Table(inside) => name_at(inside, span),
                    _ => None,
                };
                match inside {
                    Some(rest) => Some(format!("{numbered}: {rest}")),
                    None => (item.span() == *span).then_some(numbered),
                }
            }),
            _ => None,
        };
        let is_here = [key.span(), value.span()].contains(span);
        inside.or_else(|| is_here.then(|| name.to_string()))
    })
}
