//! Suggestions for unknown keys.

use super::fields::FIELDS;
use strsim::levenshtein;

/// Whether some field's key starts with this table's name.
pub(super) fn is_table(name: &str) -> bool {
    FIELDS.iter().any(|field| {
        field
            .key
            .split_once('.')
            .is_some_and(|(table, _)| table == name)
    })
}

/// What to write instead of an unknown key: the field with the nearest name, else the fields of the
/// table that was meant.
pub(super) fn hint(key: &str) -> String {
    let table = key.split('.').next().unwrap_or_default();
    match nearest(key) {
        _ if ["keyframe", "caption", "stop"].contains(&key) => {
            "this is a journey, which --journey flies".into()
        }
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

/// The name that was probably meant: the one nearest to `given` by Levenshtein's distance, or the
/// only one that begins with it. `None` if every name differs in more than a third of its letters.
pub fn nearest_name(given: &str, names: &[impl AsRef<str>]) -> Option<String> {
    const MAX_LENGTH: usize = 60;
    if given.is_empty() || given.len() > MAX_LENGTH {
        return None;
    }
    let wanted = given.to_lowercase();
    let names = names.iter().map(AsRef::<str>::as_ref);
    let mut begin = names.clone().filter(|name| name.starts_with(&wanted));
    if let (Some(only), None) = (begin.next(), begin.next()) {
        return Some(only.into());
    }
    let distance = |name: &str| levenshtein(&wanted, &name.to_lowercase());
    let nearest = names.min_by_key(|name| distance(name))?;
    let most = 1 + nearest.chars().count() / 3;
    // A short word such as a number is not a misspelled name.
    (distance(nearest) <= most && distance(nearest) < wanted.chars().count())
        .then(|| nearest.into())
}

/// The field whose name is nearest to this one by Levenshtein's distance, compared in full or after
/// the dot, with or without its unit; none if every name differs in more than a third of the
/// letters.
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
        let by_name = levenshtein(wanted_name, name).min(levenshtein(wanted_name, bare));
        (2 * levenshtein(&wanted, field)).min(2 * by_name + 1)
    };
    let (least, field) = FIELDS
        .iter()
        .map(|field| (distance(field.key), field.key))
        .min()?;
    (least <= 1 + 2 * (wanted_name.chars().count() / 3)).then_some(field)
}
