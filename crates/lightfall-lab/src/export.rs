//! Reports as CSV and JSON, for programs.

use super::circumstances::Circumstances;
use lightfall_optics::trace::Outcome;
use serde::Serialize;

/// A report as CSV: the circumstances in lines that begin with `#`, a header, and one line per row.
pub fn csv(circumstances: &Circumstances, rows: &[impl Serialize]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let flat = rows
        .iter()
        .map(|row| serde_json::to_value(row).unwrap_or_default());
    for (i, row) in flat.enumerate() {
        let mut fields = Vec::new();
        for (key, value) in row.as_object().into_iter().flatten() {
            flatten(key, value, &mut fields);
        }
        if i == 0 {
            writer
                .write_record(fields.iter().map(|(key, _)| key))
                .expect("writing to a vector cannot fail");
        }
        writer
            .write_record(fields.iter().map(|(_, value)| value))
            .expect("writing to a vector cannot fail");
    }
    circumstances.marked('#') + &String::from_utf8_lossy(&writer.into_inner().unwrap_or_default())
}

/// A field's name and value as text. A list, which has one element per outcome, becomes several
/// fields.
fn flatten(key: &str, value: &serde_json::Value, fields: &mut Vec<(String, String)>) {
    match value {
        serde_json::Value::Array(values) => {
            for (i, value) in values.iter().enumerate() {
                flatten(
                    &format!(
                        "{key}_{}",
                        Outcome::ALL.get(i).map_or("more", |outcome| outcome.word())
                    ),
                    value,
                    fields,
                );
            }
        }
        serde_json::Value::Null => fields.push((key.into(), String::new())),
        serde_json::Value::String(text) => fields.push((key.into(), text.clone())),
        other => fields.push((key.into(), other.to_string())),
    }
}

/// A report as JSON. Infinite values and NaN become null.
pub fn json(circumstances: &Circumstances, rows: &[impl Serialize]) -> String {
    let whole = serde_json::json!({ "circumstances": circumstances, "rows": rows });
    serde_json::to_string_pretty(&whole).unwrap_or_default() + "\n"
}
