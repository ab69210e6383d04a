//! From the text of a preset, and what overrides it, to a scene.

use std::collections::BTreeMap;

use toml::{Table, Value};

use super::error::{Refusal, SceneError};
use super::fields::{FIELDS, Kind, field};
use super::limits::{given, shortened};
use super::{SCHEMA, Scene};

/// One field that the command line sets over the preset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    /// The option that sets it, e.g. `--set` or `--spin`, for messages.
    pub option: &'static str,
    /// Dotted key.
    pub key: String,
    /// Value: TOML, or a bare word or text where the field takes one.
    pub value: String,
}

impl Override {
    /// Reads the `KEY=VALUE` of `--set`.
    ///
    /// # ErrorSummary
    /// There is no equals sign, or nothing before it.
    pub fn assignment(text: &str) -> Result<Self, SceneError> {
        match text.split_once('=') {
            Some((key, value)) if !key.trim().is_empty() => {
                Ok(Self::new("--set", key.trim(), value.trim()))
            }
            _ => Err(SceneError::NotAnAssignment {
                given: shortened(text),
            }),
        }
    }

    /// What a short form such as `--spin VALUE` stands for.
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

/// Makes a scene of a preset's TOML `text` and the overrides, the later ones winning. `origin`
/// names the preset in messages. Fields that are not mentioned take their defaults.
///
/// # ErrorSummary
/// One sentence that names where the fault is written, the key, the value and what is allowed.
pub fn load(origin: &str, text: &str, overrides: &[Override]) -> Result<Scene, SceneError> {
    let table: Table = toml::from_str(text).map_err(|error| syntax(origin, text, &error))?;
    // First of all: to a preset of another version, every other complaint would be beside the
    // point.
    match table.get("schema") {
        Some(schema @ Value::Integer(number)) if *number != i64::from(SCHEMA) => {
            return Err(SceneError::Schema {
                origin: origin.into(),
                given: given(schema),
            });
        }
        _ => {}
    }
    let mut fields = BTreeMap::new();
    for (key, value) in table {
        match value {
            Value::Table(inner) if is_table(&key) => {
                for (name, value) in inner {
                    insert(&mut fields, (origin, 0), &[&key, &name], value)?;
                }
            }
            value => insert(&mut fields, (origin, 0), &[&key], value)?,
        }
    }
    for (index, Override { option, key, value }) in overrides.iter().enumerate() {
        let value = field(key).map_or_else(
            || Value::String(value.clone()),
            |field| parse(field.kind, value),
        );
        insert(
            &mut fields,
            (option, index + 1),
            &key.split('.').collect::<Vec<_>>(),
            value,
        )?;
    }
    let scene = scene(&fields);
    scene
        .check()
        .map_err(|refusal| refused(&fields, origin, refusal))?;
    Ok(scene)
}

/// Checks one value's key and type and keeps it, replacing an earlier one.
fn insert<'a>(
    fields: &mut BTreeMap<&'static str, Given<'a>>,
    (origin, order): (&'a str, usize),
    path: &[&str],
    value: Value,
) -> Result<(), SceneError> {
    // A quoted key with a dot in it is one segment in TOML and no field of ours.
    let key = path.join(".");
    let found = field(&key).filter(|field| field.key.split('.').eq(path.iter().copied()));
    let Some(field) = found else {
        let origin = origin.into();
        return Err(
            match FIELDS
                .iter()
                .find(|field| is_table(&key) && field.key.starts_with(&format!("{key}.")))
            {
                Some(example) => SceneError::NotAField {
                    origin,
                    key,
                    given: given(&value),
                    example: example.key,
                },
                None => SceneError::UnknownKey {
                    origin,
                    hint: hint(&key),
                    key: shortened(&key),
                },
            },
        );
    };
    let value = coerce_integers(field.kind, value);
    field
        .check_type(&value)
        .map_err(|refusal| SceneError::Refused {
            origin: origin.into(),
            refusal: Box::new(refusal),
        })?;
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

/// The defaults with these values in their places.
fn scene(fields: &BTreeMap<&'static str, Given>) -> Scene {
    let mut table = Table::try_from(Scene::default())
        .expect("a scene is made of numbers, words and tables only");
    for (key, Given { value, .. }) in fields {
        let place = match key.split_once('.') {
            None => table.get_mut(*key),
            Some((outer, inner)) => table.get_mut(outer).and_then(|outer| outer.get_mut(inner)),
        };
        *place.expect("every key of the field table is a field of the scene") = value.clone();
    }
    table
        .try_into()
        .expect("every value was checked against the field table")
}

/// The refusal with the origin of the field; where one that narrows its range was set after it,
/// that one is to blame.
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
    refusal.blamed = to_blame.map(|(key, Given { value, .. })| Box::new((key, given(value))));
    SceneError::Refused {
        origin: written.map_or(preset, |given| given.origin).into(),
        refusal: Box::new(refusal),
    }
}

/// Whether some field's key starts with this table's name.
fn is_table(name: &str) -> bool {
    FIELDS.iter().any(|field| {
        field
            .key
            .split_once('.')
            .is_some_and(|(table, _)| table == name)
    })
}

/// A value from the command line: TOML where it is TOML, otherwise the words themselves.
fn parse(kind: Kind, text: &str) -> Value {
    let value = text.parse::<Value>().ok();
    match (kind, value) {
        (Kind::Text | Kind::Choice(_), value @ Some(Value::String(_))) => value,
        (Kind::Text | Kind::Choice(_), _) => None,
        // `.9` and `1.` are numbers to everybody but TOML.
        (Kind::Float(_), None) => text.parse().ok().map(Value::Float),
        // Brackets mean something to shells, so `0,0,.5` serves as well as `[0, 0, 0.5]`.
        (Kind::Velocity, None) => {
            let components = text
                .trim_start_matches('[')
                .trim_end_matches(']')
                .split(',');
            components
                .map(|component| component.trim().parse().ok().map(Value::Float))
                .collect::<Option<Vec<_>>>()
                .map(Value::Array)
        }
        (_, value) => value,
    }
    .unwrap_or_else(|| Value::String(text.into()))
}

/// Whole numbers are numbers too, where a number is asked for.
pub(super) fn coerce_integers(kind: Kind, value: Value) -> Value {
    match (kind, value) {
        (Kind::Float(_), Value::Integer(number)) => Value::Float(number as f64),
        (Kind::Velocity, Value::Array(values)) => Value::Array(
            values
                .into_iter()
                .map(|value| coerce_integers(Kind::Float(super::Range::FINITE), value))
                .collect(),
        ),
        (_, value) => value,
    }
}

/// A fault of TOML with the line and column where it was noticed.
pub(super) fn syntax(origin: &str, text: &str, error: &toml::de::Error) -> SceneError {
    let at = error.span().map_or(0, |span| span.start.min(text.len()));
    let before = String::from_utf8_lossy(&text.as_bytes()[..at]);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    SceneError::Syntax {
        origin: origin.into(),
        line: 1 + before.matches('\n').count(),
        column: 1 + before[line_start..].chars().count(),
        message: one_line(error.message()),
    }
}

fn one_line(message: &str) -> String {
    message
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect::<Vec<_>>()
        .join(", ")
}

/// What to write instead of an unknown key: the field with the nearest name, else the fields of the
/// table meant.
fn hint(key: &str) -> String {
    let table = key.split('.').next().unwrap_or_default();
    match nearest(key) {
        Some(field) => format!("did you mean {field}?"),
        None if is_table(table) => {
            let names = FIELDS
                .iter()
                .filter_map(|field| field.key.strip_prefix(table)?.strip_prefix('.'));
            format!("{table} has {}", names.collect::<Vec<_>>().join(", "))
        }
        None => "`lightfall presets show 2` lists them all".into(),
    }
}

/// The field whose name, in full or after the dot and with or without its unit, differs least from
/// this one; none if every one differs in more than a third of the letters.
fn nearest(key: &str) -> Option<&'static str> {
    const MAX_LENGTH: usize = 60;
    if key.len() > MAX_LENGTH {
        return None;
    }
    let wanted = key.to_lowercase();
    let wanted_name = wanted.rsplit('.').next().unwrap_or_default();
    let distance = |field: &str| {
        let name = field.rsplit('.').next().unwrap_or_default();
        let bare = name
            .trim_end_matches("_deg")
            .trim_end_matches("_k")
            .trim_end_matches("_ev");
        // In half letters; a wrong table or a forgotten unit counts as one.
        let by_name = edits(wanted_name, name).min(edits(wanted_name, bare));
        (2 * edits(&wanted, field)).min(2 * by_name + 1)
    };
    let (least, field) = FIELDS
        .iter()
        .map(|field| (distance(field.key), field.key))
        .min()?;
    (least <= 1 + 2 * (wanted_name.chars().count() / 3)).then_some(field)
}

/// Levenshtein's distance: the least number of letters to insert, delete or replace.
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
