//! Values that are no numbers, switches or texts in quotes as TOML writes them.

use super::shown;
use toml::de::DeTable;

/// The quotes that programs for writing put in place of straight ones.
const TYPOGRAPHIC: [char; 9] = ['“', '”', '„', '‟', '«', '»', '‘', '’', '‚'];

/// What is wrong with the value of a field, and what was meant. None for a value without a fault. The name
/// of the field, if it is known, is repeated.
pub(super) fn told(name: Option<&str>, value: &str) -> Option<String> {
    let is_fine = DeTable::parse(&format!("x = {value}")).is_ok();
    let first = value.chars().next().filter(|_| !is_fine)?;
    let written = |value: &str| match name {
        Some(name) => shown(&format!("{name} = {value}")),
        None => shown(value),
    };
    let given = written(value);
    if TYPOGRAPHIC.contains(&first) {
        let bare = value.trim_matches(TYPOGRAPHIC);
        let meant = written(&in_quotes(bare));
        return Some(format!(
            "{given} has the quotes of printed texts: write straight ones, {meant}"
        ));
    }
    if let Some(meant) = switch(value) {
        return Some(format!(
            "{given} is refused: write true or false, in small letters; did you mean `{meant}`?"
        ));
    }
    if value.contains(" //") {
        return Some(format!("{given} is refused: a remark begins with `#`"));
    }
    if let Some(said) = number(value, &given) {
        return Some(said);
    }
    if first.is_alphabetic() {
        let bare = value.trim_end_matches(['"', '\'']);
        let meant = written(&in_quotes(bare));
        return Some(format!(
            "{given} is a text without quotes, or with one only: write {meant}"
        ));
    }
    Some(format!(
        "{given} is refused: a value is a number, true or false, or a text in quotes"
    ))
}

/// A text in the quotes that it does not have inside.
fn in_quotes(text: &str) -> String {
    match text.contains('"') {
        true => format!("'{text}'"),
        false => format!("\"{text}\""),
    }
}

/// The switch that was probably meant by a word.
pub(super) fn switch(word: &str) -> Option<bool> {
    match word.to_lowercase().as_str() {
        "true" | "yes" | "on" => Some(true),
        "false" | "no" | "off" => Some(false),
        _ => None,
    }
}

/// What is wrong with a value that begins with a number.
fn number(value: &str, given: &str) -> Option<String> {
    let is_part = |c: char| c.is_ascii_digit() || "+-._ ".contains(c);
    let end = value.find(|c: char| !is_part(c)).unwrap_or(value.len());
    let (number, unit) = value.split_at(end);
    let digits: String = number.chars().filter(|c| !" _".contains(*c)).collect();
    let meant: f64 = digits.parse().ok()?;
    match unit.chars().next() {
        None => Some(format!(
            "{given} is no number as it is written here: did you mean {meant}?"
        )),
        Some(c) if c.is_alphabetic() || "°%".contains(c) => Some(format!(
            "{given} is neither a number nor a text in quotes: write the number without its unit, in the unit of the \
             field, or the text as `{}`",
            in_quotes(value)
        )),
        Some(_) => None,
    }
}
