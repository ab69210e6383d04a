//! The line of a key in a text in TOML, for messages.

use super::located::line_number;
use toml::de::{DeTable, DeValue};

/// A dotted key of the whole text, or of the table of this name and number, from 1.
pub(super) type Place<'a> = (Option<(&'a str, usize)>, &'a str);

/// The line of a key, from 1. Of a key that is missing, the line where its table begins. None if there is
/// neither.
pub(super) fn line_of(text: &str, (table, key): Place<'_>) -> Option<usize> {
    let document = DeTable::parse(text).ok()?;
    let whole = document.get_ref();
    let Some((name, number)) = table else {
        return Some(line_number(text, start_of(whole, key)?));
    };
    let DeValue::Array(tables) = whole.get(name)?.get_ref() else {
        return None;
    };
    let DeValue::Table(inside) = tables.get(number.checked_sub(1)?)?.get_ref() else {
        return None;
    };
    // A keyframe has the same keys once more in its table `rain`.
    let own = start_of(inside, key);
    let rain = inside.iter().find(|(key, _)| key.get_ref() == "rain");
    let in_rain = rain.and_then(|(_, value)| match value.get_ref() {
        DeValue::Table(rain) => start_of(rain, key),
        _ => None,
    });
    match (own, in_rain) {
        (Some(at), None) | (None, Some(at)) => Some(line_number(text, at)),
        // Which of the two it is, the fault does not say.
        (Some(_), Some(_)) | (None, None) => {
            match inside.iter().map(|(key, _)| key.span().start).min() {
                Some(first) => {
                    head_above(text, name, first).or_else(|| Some(line_number(text, first)))
                }
                None => head_of(text, name, number),
            }
        }
    }
}

/// Where a dotted key begins, or as much of it as the table has. A part of it may be one key, in quotes.
fn start_of(table: &DeTable<'_>, key: &str) -> Option<usize> {
    let (mut inside, mut at, mut rest) = (table, None, key);
    loop {
        if let Some((key, _)) = inside.iter().find(|(key, _)| key.get_ref() == rest) {
            return Some(key.span().start);
        }
        let Some((name, after)) = rest.split_once('.') else {
            return at;
        };
        let Some((key, value)) = inside.iter().find(|(key, _)| key.get_ref() == name) else {
            return at;
        };
        at = Some(key.span().start);
        let DeValue::Table(table) = value.get_ref() else {
            return at;
        };
        (inside, rest) = (table, after);
    }
}

/// Whether a line is a head `[[name]]`.
fn is_head(line: &str, name: &str) -> bool {
    let inside = line.trim_start().strip_prefix("[[");
    inside.is_some_and(|rest| rest.trim_start().starts_with(name))
}

/// The line of the nearest head `[[name]]` above a place.
fn head_above(text: &str, name: &str, at: usize) -> Option<usize> {
    let above: Vec<&str> = text.get(..at)?.lines().collect();
    let place = above.iter().rposition(|line| is_head(line, name))?;
    Some(place + 1)
}

/// The line of the head `[[name]]` of this number, from 1: that of a table without any key.
fn head_of(text: &str, name: &str, number: usize) -> Option<usize> {
    let lines = text.lines().enumerate();
    let mut heads = lines.filter(|(_, line)| is_head(line, name));
    let (place, _) = heads.nth(number.checked_sub(1)?)?;
    Some(place + 1)
}
