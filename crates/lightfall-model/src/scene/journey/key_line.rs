//! The line of a key in the text of a journey, for messages.

use toml::de::{DeTable, DeValue};

/// The line, from 1, of a dotted key in the table of this number, from 1, among those with a name.
/// None if the text has no such key, or is no TOML.
pub(super) fn line_of(text: &str, [table, key]: [&str; 2], number: usize) -> Option<usize> {
    let document = DeTable::parse(text).ok()?;
    let tables = document.get_ref().get(table)?.get_ref();
    let DeValue::Array(tables) = tables else {
        return None;
    };
    let mut inside = tables.get(number.checked_sub(1)?)?.get_ref();
    let mut at = None;
    for name in key.split('.') {
        let DeValue::Table(table) = inside else {
            break;
        };
        let (key, value) = table.iter().find(|(key, _)| key.get_ref() == name)?;
        at = Some(key.span().start);
        inside = value.get_ref();
    }
    let before = text.as_bytes().get(..at?)?;
    Some(1 + before.iter().filter(|byte| **byte == b'\n').count())
}
