//! The table `set` of a keyframe: fields of the scene, and which of them no keyframe may set.

use super::error::Fault;
use super::format::NAMES;
use super::keyframe::{TABLE, Values};
use crate::scene::field::Field;
use crate::scene::fields::field;
use crate::scene::from_toml::{flattened, given};
use crate::scene::hint::hint;
use crate::scene::value::{Value, shortened};

/// Reads the table `set` of the keyframe of this number: fields as `"hole.spin" = 0.5`, in quotes or
/// without.
pub(super) fn read_set(number: usize, value: Option<toml::Value>) -> Result<Values, Fault> {
    let table = match value {
        None => return Ok(Values::new()),
        Some(toml::Value::Table(table)) => table,
        Some(other) => {
            return Err(Fault::Value {
                table: TABLE,
                number,
                key: "set",
                given: Some(given(&other)),
                allowed: "a table of fields of the scene, such as { \"hole.spin\" = 0.5 }".into(),
            });
        }
    };
    let mut values = Values::new();
    for (key, value) in flattened(table) {
        let (field, value) = read_field(number, &key, &value)?;
        if values.insert(field, value).is_some() {
            // TOML takes "hole.spin" in quotes and hole.spin without them for two keys.
            return Err(refused(number, &key, "it is there twice".into()));
        }
    }
    Ok(values)
}

fn read_field(
    number: usize,
    key: &str,
    value: &toml::Value,
) -> Result<(&'static str, Value), Fault> {
    let Some(field) = field(key) else {
        let why = format!("there is no such field; {}", hint(key));
        return Err(refused(number, key, why));
    };
    if let Some(why) = why_not_set(field) {
        return Err(refused(number, key, why));
    }
    let read = field.read_in_range(value);
    let value = read.map_err(|refusal| Fault::SetValue {
        number,
        key: format!("set.{}", field.key),
        given: refusal.given,
        allowed: refusal.allowed,
    })?;
    Ok((field.key, value))
}

fn refused(number: usize, key: &str, why: String) -> Fault {
    Fault::SetKey {
        number,
        key: format!("set.{}", shortened(key)),
        why,
    }
}

/// Why keyframes do not set a field; `None` if they may.
fn why_not_set(field: &Field) -> Option<String> {
    let own = NAMES
        .into_iter()
        .find(|(name, _)| field_of(name) == field.key);
    if let Some((name, _)) = own {
        return Some(format!("a keyframe itself names it, as {name}"));
    }
    let why = match field.key {
        "schema" | "name" | "title" => "no picture shows it",
        "picture.width"
        | "picture.height"
        | "picture.grid_width"
        | "picture.grid_height"
        | "camera.projection" => "all pictures of a journey have one size and one projection",
        "sky.picture" => "the sky has one picture in the whole journey, that of the scene",
        "picture.bypass" => "the window and --cells decide it for the whole journey",
        _ => return None,
    };
    Some(why.into())
}

/// The key of the field that a keyframe's own name leads.
fn field_of(name: &str) -> String {
    match (name, name.strip_prefix("disk_")) {
        ("observer", _) => "observer.kind".into(),
        ("velocity", _) => "observer.velocity".into(),
        (_, Some(of_disk)) => format!("disk.{of_disk}"),
        _ => format!("camera.{name}"),
    }
}
