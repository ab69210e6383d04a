//! In what two scenes differ, in a player's words.

use crate::app::ui::panel::sections::SECTIONS;
use lightfall_core::numbers::four_digits;
use lightfall_core::scene::{FIELDS, Method, ObserverKind, Scene, Value};

/// Names of fields whose label on the panel does not suit a sentence. Other fields have their label.
const NAMES: [(&str, &str); 5] = [
    ("hole.spin", "spin"),
    ("observer.kind", "observer"),
    ("effects.lensing", "lensing"),
    ("disk.enabled", "disk"),
    ("sky.mode", "sky"),
];

/// Groups whose fields need no group name in front of them.
const OBVIOUS_GROUPS: [&str; 3] = ["effects", "quality", "observer"];

/// Groups that both sides of a comparison share.
const SHARED_GROUPS: [&str; 3] = ["camera", "probe", "picture"];

/// Fields that both sides share, or that say nothing about the picture.
const SHARED_FIELDS: [&str; 3] = ["schema", "title", "disk.time"];

/// The settings in which two compared scenes differ, each as it is in the first and in the second.
#[must_use]
pub fn differences(a: &Scene, b: &Scene) -> Vec<[String; 2]> {
    let compared = FIELDS.iter().filter(|field| {
        let group = field.key.split('.').next().unwrap_or_default();
        !SHARED_GROUPS.contains(&group) && !SHARED_FIELDS.contains(&field.key)
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
        ("observer.kind", _) => motion(scene.observer.kind).into(),
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
    format!("{} {value}", name(key))
}

/// How an observer moves.
fn motion(kind: ObserverKind) -> &'static str {
    kind.properties().motion
}

fn name(key: &str) -> String {
    if let Some((_, name)) = NAMES.iter().find(|(known, _)| *known == key) {
        return (*name).into();
    }
    let (group, field) = key.split_once('.').unwrap_or(("", key));
    let mut rows = SECTIONS.iter().flat_map(|section| section.rows);
    let field = match rows.find(|row| row.key == key) {
        Some(row) if row.label.starts_with("Doppler") => row.label.into(),
        Some(row) => row.label.to_lowercase(),
        None => field.replace('_', " "),
    };
    if group.is_empty() || OBVIOUS_GROUPS.contains(&group) {
        field
    } else {
        format!("{group} {field}")
    }
}
