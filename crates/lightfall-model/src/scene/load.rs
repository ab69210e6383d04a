//! From the text of a preset and its overrides to a scene.

use std::collections::BTreeMap;

use super::error::{Refusal, SceneError, SceneFault};
use super::fields::{FIELDS, field};
use super::from_toml::{given, table};
use super::hint::{hint, is_table};
use super::range::Kind;
use super::value::{Value, shortened};
use super::{MAX_FILE_SIDE, Scene, resized};

/// One field that the command line sets in place of the preset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    /// The option that sets it, e.g. `--set` or `--spin`, for messages.
    pub option: &'static str,
    /// Dotted key.
    pub key: String,
    /// Value: TOML, or a bare word or text if the field takes one.
    pub value: String,
}

impl Override {
    /// Reads the `KEY=VALUE` of `--set`.
    ///
    /// # Errors
    /// There is no equals sign, or nothing before it.
    pub fn assignment(text: &str) -> Result<Self, SceneError> {
        match text.split_once('=') {
            Some((key, value)) if !key.trim().is_empty() => {
                Ok(Self::new("--set", key.trim(), value.trim()))
            }
            _ => {
                let given = shortened(text);
                Err(SceneError::new(
                    "--set",
                    SceneFault::NotAnAssignment { given },
                ))
            }
        }
    }

    /// The override that a short form such as `--spin VALUE` stands for.
    pub fn new(option: &'static str, key: &str, value: &str) -> Self {
        Self {
            option,
            key: key.into(),
            value: value.into(),
        }
    }
}

/// A value and where it was written.
struct Given<'a> {
    origin: &'a str,
    /// Which override it was, from 1; the preset comes before all of them.
    order: usize,
    value: Value,
}

/// Makes a scene from a preset's TOML `text` and the overrides, of which a later one replaces an
/// earlier one. `origin` names the preset in messages. Fields that are not mentioned have their
/// defaults. An override of the exposure switches the preset's automatic exposure off, and one of the
/// picture's size adapts its grid, as [`resized`] does.
///
/// # Errors
/// One sentence that names where the fault is written, its line, the key, the value and what is allowed.
pub fn load(origin: &str, text: &str, overrides: &[Override]) -> Result<Scene, SceneError> {
    read(origin, text, overrides).map_err(|error| error.in_text(origin, text))
}

fn read(origin: &str, text: &str, overrides: &[Override]) -> Result<Scene, SceneError> {
    let table = table(text).map_err(|fault| SceneError::new(origin, fault))?;
    let mut fields = BTreeMap::new();
    let is_empty = !table.is_empty() && table.values().all(is_empty_table);
    // The first error is reported once all other fields are known: its range depends on them.
    let mut errors = Vec::new();
    for (key, value) in table {
        match value {
            toml::Value::Table(inner) if is_table(&key) => {
                for (name, value) in inner {
                    errors.extend(insert(&mut fields, (origin, 0), &[&key, &name], value).err());
                }
            }
            value => errors.extend(insert(&mut fields, (origin, 0), &[&key], value).err()),
        }
    }
    if is_empty && errors.is_empty() {
        return Err(SceneError::new(origin, SceneFault::NoField));
    }
    for (index, Override { option, key, value }) in overrides.iter().enumerate() {
        let value = field(key).map_or_else(
            || toml::Value::String(value.clone()),
            |field| parse(field.kind, value),
        );
        let path = key.split('.').collect::<Vec<_>>();
        errors.extend(insert(&mut fields, (option, index + 1), &path, value).err());
    }
    let mut scene = scene(&fields);
    if let Some(error) = errors.into_iter().next() {
        return Err(with_range_of(error, &scene));
    }
    let order = |key: &str| fields.get(key).map_or(0, |given| given.order);
    if order("picture.exposure_ev") > 0 && order("picture.automatic_exposure") == 0 {
        scene.picture.automatic_exposure = false;
    }
    let any_given = |sides: [&str; 2]| sides.iter().any(|side| order(side) > 0);
    let size = scene.picture.size();
    if any_given(["picture.width", "picture.height"])
        && !any_given(["picture.grid_width", "picture.grid_height"])
        && size.min_element() >= 1
        && size.max_element() <= MAX_FILE_SIDE
    {
        scene.picture = resized(&scene.picture, size);
    }
    scene
        .check()
        .map_err(|refusal| refused(&fields, origin, refusal))?;
    Ok(scene)
}

/// Whether a value is a table without contents, such as a lone `[camera]`.
fn is_empty_table(value: &toml::Value) -> bool {
    value.as_table().is_some_and(toml::Table::is_empty)
}

/// A refusal of a value that is no number names the same range as that of a number out of range.
fn with_range_of(mut error: SceneError, scene: &Scene) -> SceneError {
    if let SceneFault::Refused(refusal) = &mut error.fault.what
        && let Some(field) = field(refusal.key)
    {
        let (range, because) = scene.range(field);
        refusal.allowed = field.allowed_in(range);
        refusal.because = because;
    }
    error
}

/// Reads one value by the field with its key and keeps it, replacing an earlier one.
fn insert<'a>(
    fields: &mut BTreeMap<&'static str, Given<'a>>,
    (origin, order): (&'a str, usize),
    path: &[&str],
    value: toml::Value,
) -> Result<(), SceneError> {
    // A quoted key with a dot in it is one segment in TOML, and no field has such a name.
    let key = path.join(".");
    let found = field(&key).filter(|field| field.key.split('.').eq(path.iter().copied()));
    let Some(field) = found else {
        return Err(SceneError::new(origin, no_field(key, &value)));
    };
    let value = field
        .read(&value)
        .map_err(|refusal| SceneError::new(origin, Box::new(refusal).into()))?;
    fields.insert(
        field.key,
        Given {
            origin,
            order,
            value,
        },
    );
    Ok(())
}

/// Why a key is not the key of a field.
fn no_field(key: String, value: &toml::Value) -> SceneFault {
    let mut fields = FIELDS.iter().filter(|_| is_table(&key));
    match fields.find(|field| field.key.starts_with(&format!("{key}."))) {
        Some(example) => SceneFault::NotAField {
            key,
            given: given(value),
            example: example.key,
        },
        None => SceneFault::UnknownKey {
            hint: hint(&key),
            key: shortened(&key),
        },
    }
}

/// The defaults with these values in their places.
fn scene(fields: &BTreeMap<&'static str, Given>) -> Scene {
    let mut scene = Scene::default();
    for (key, given) in fields {
        let field = field(key).expect("only keys of fields were kept");
        field
            .set(&mut scene, given.value.clone())
            .expect("every value was read by its field");
    }
    scene
}

/// The refusal with the origin of the field. If a field that narrows its range was set after it,
/// that field is blamed.
fn refused(
    fields: &BTreeMap<&'static str, Given>,
    preset: &str,
    mut refusal: Refusal,
) -> SceneError {
    let own = fields.get(refusal.key);
    let narrowing = refusal.because.iter().flat_map(|because| &because.keys);
    let last = narrowing
        .filter_map(|key| Some((*key, fields.get(key)?)))
        .max_by_key(|(_, given)| given.order);
    let to_blame = last.filter(|(_, given)| own.is_none_or(|own| given.order > own.order));
    let written = to_blame.map(|(_, given)| given).or(own);
    refusal.blamed = to_blame.map(|(key, Given { value, .. })| Box::new((key, value.quoted())));
    let origin = written.map_or(preset, |given| given.origin);
    SceneError::new(origin, Box::new(refusal).into())
}

/// A value from the command line: TOML if it can be read as such, otherwise the words themselves.
fn parse(kind: Kind, text: &str) -> toml::Value {
    use toml::Value::{Array, Float, String};
    let value = text.parse::<toml::Value>().ok();
    match (kind, value) {
        (Kind::Text | Kind::Choice(_), value @ Some(String(_))) => value,
        (Kind::Text | Kind::Choice(_), _) => None,
        // People write `.9` and `1.`, which TOML does not accept.
        (Kind::Float(_), None) => text.parse().ok().map(Float),
        // Shells interpret brackets, so `0,0,.5` is accepted as well as `[0, 0, 0.5]`.
        (Kind::Velocity | Kind::Pair, None) => {
            let components = text
                .trim_start_matches('[')
                .trim_end_matches(']')
                .split(',');
            components
                .map(|component| component.trim().parse().ok().map(Float))
                .collect::<Option<Vec<_>>>()
                .map(Array)
        }
        (_, value) => value,
    }
    .unwrap_or_else(|| String(text.into()))
}
