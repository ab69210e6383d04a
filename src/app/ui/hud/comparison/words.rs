//! The differences between two scenes in words.

use crate::app::controls::sections::field_in_words;
use lightfall_core::numbers::four_digits;
use lightfall_core::scene::{FIELDS, Method, Scene, Value};

/// Tables that both sides of a comparison share.
const SHARED_TABLES: [&str; 3] = ["camera", "probe", "picture"];

/// Fields that both sides share, or that say nothing about the picture.
const SHARED_FIELDS: [&str; 3] = ["schema", "title", "disk.time"];

/// The settings in which two compared scenes differ, each as in the first and as in the second.
#[must_use]
pub fn differences(a: &Scene, b: &Scene) -> Vec<[String; 2]> {
    let compared = FIELDS.iter().filter(|field| {
        let table = field.key.split('.').next().unwrap_or_default();
        !SHARED_TABLES.contains(&table) && !SHARED_FIELDS.contains(&field.key)
    });
    compared
        .filter(|field| field.get(a) != field.get(b))
        .map(|field| [a, b].map(|scene| setting(field.key, field.unit, &field.get(scene), scene)))
        .collect()
}

/// A setting in a few words, for example `lensing off`.
fn setting(key: &str, unit: &str, value: &Value, scene: &Scene) -> String {
    let value = match (key, value) {
        ("name", _) => return scene.name.clone(),
        ("observer.kind", _) => scene.observer.kind.properties().motion.into(),
        ("method", _) if scene.method == Method::Auto => {
            format!("auto ({})", Method::BEST.word())
        }
        (_, Value::Boolean(true)) => "on".into(),
        (_, Value::Boolean(false)) => "off".into(),
        (_, Value::Word(word)) => (*word).into(),
        (_, Value::Velocity(velocity)) => format!("{} c", velocity.map(four_digits).join(", ")),
        (_, value) => {
            let number = value
                .number()
                .map_or_else(|| value.to_string(), four_digits);
            format!("{number} {unit}").trim_end().to_owned()
        }
    };
    format!("{} {value}", field_in_words(key))
}
