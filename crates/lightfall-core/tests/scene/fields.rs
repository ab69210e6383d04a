//! The field table against the Scene that it describes.

use std::collections::BTreeSet;
use std::ops::Bound::{Excluded, Included, Unbounded};

use lightfall_core::scene::{
    FIELDS, Field, Kind, ObserverKind, Override, Scene, Value, field, load,
};

fn set(key: &str, value: &str) -> Result<Scene, String> {
    load("t.toml", "", &[Override::new("--set", key, value)]).map_err(|error| error.to_string())
}

/// Two values of a field that differ from its default and from each other, as far as it has some.
fn other_values(field: &Field) -> Vec<Value> {
    let default = field.get(&Scene::default());
    let candidates = match field.kind {
        Kind::Float(_) => [0.125, 1.5, 12.3, 54.7, 321.5].map(Value::Float).to_vec(),
        Kind::Integer(_) => [1, 12, 77].map(Value::Integer).to_vec(),
        Kind::Boolean => [false, true].map(Value::Boolean).to_vec(),
        Kind::Choice(choices) => choices
            .iter()
            .map(|choice| Value::Word(choice.word))
            .collect(),
        Kind::Text => ["a", "\"b\" \\ ä"]
            .map(|text| Value::Text(text.into()))
            .to_vec(),
        Kind::Velocity => vec![Value::Velocity([0.1, -0.2, 0.3])],
        Kind::Pair => vec![Value::Pair([0.1, -0.2])],
    };
    let allowed = |value: &Value| {
        let number = value.number();
        *value != default && number.is_none_or(|number| field.kind.range().contains(number))
    };
    candidates.into_iter().filter(allowed).collect()
}

#[test]
fn every_field_reads_back_what_was_set_by_its_key_and_leaves_the_others_alone() {
    let before = Scene::default();
    for row in FIELDS.iter() {
        let others = other_values(row);
        assert!(!others.is_empty() || row.key == "schema", "{}", row.key);
        for value in others {
            let mut scene = before.clone();
            field(row.key)
                .unwrap()
                .set(&mut scene, value.clone())
                .unwrap();
            assert_eq!(row.get(&scene), value, "{}", row.key);
            assert_eq!(
                scene.differences(&before),
                [(row.key, value)],
                "{}",
                row.key
            );
        }
    }
}

#[test]
fn the_value_of_every_field_is_the_one_that_serde_writes_and_reads() {
    for row in FIELDS.iter() {
        for value in other_values(row) {
            let mut scene = Scene::default();
            row.set(&mut scene, value.clone()).unwrap();
            let table = toml::Table::try_from(&scene).unwrap();
            let (outer, inner) = row.key.split_once('.').unwrap_or((row.key, ""));
            let written = match inner {
                "" => &table[outer],
                name => &table[outer][name],
            };
            assert_eq!(written.to_string(), value.to_string(), "{}", row.key);
            assert_eq!(table.try_into::<Scene>().unwrap(), scene, "{}", row.key);
        }
    }
}

#[test]
fn a_value_of_another_kind_is_refused_by_every_field() {
    for row in FIELDS.iter() {
        let own = row.get(&Scene::default());
        let values = [
            Value::Float(1.0),
            Value::Integer(1),
            Value::Boolean(true),
            Value::Word("no word"),
            Value::Text("text".into()),
            Value::Velocity([0.0; 3]),
            Value::Pair([0.0; 2]),
        ];
        for value in values {
            let same_kind = std::mem::discriminant(&value) == std::mem::discriminant(&own);
            if same_kind && !matches!(value, Value::Word(_)) {
                continue;
            }
            let mut scene = Scene::default();
            let refusal = row.set(&mut scene, value).unwrap_err();
            assert_eq!(refusal.key, row.key);
            assert_eq!(scene, Scene::default(), "{}", row.key);
        }
    }
}

#[test]
fn the_table_has_exactly_the_fields_that_serde_writes() {
    let mut written = BTreeSet::new();
    for (key, value) in toml::Table::try_from(Scene::default()).unwrap() {
        match value {
            toml::Value::Table(inner) => {
                written.extend(inner.keys().map(|name| format!("{key}.{name}")))
            }
            _ => drop(written.insert(key)),
        }
    }
    let listed: BTreeSet<String> = FIELDS.iter().map(|field| field.key.to_owned()).collect();
    assert_eq!(listed, written);
    assert_eq!(listed.len(), FIELDS.len(), "a key is listed twice");
}

#[test]
fn the_table_lists_exactly_the_words_that_serde_knows() {
    let mut choices = 0;
    for Field { key, kind, .. } in FIELDS.iter() {
        let Kind::Choice(listed) = kind else { continue };
        let words: Vec<&str> = listed.iter().map(|choice| choice.word).collect();
        let text = match key.split_once('.') {
            Some((table, name)) => format!("[{table}]\n{name} = \"?\""),
            None => format!("{key} = \"?\""),
        };
        // Serde's own complaint ends with its own list, e.g. "expected one of `a`, `b`", or
        // "expected `a`".
        let complaint = toml::from_str::<Scene>(&text)
            .unwrap_err()
            .message()
            .to_owned();
        let known: Vec<&str> = complaint.split('`').skip(3).step_by(2).collect();
        assert_eq!(*words, known, "{key}: {complaint}");
        choices += 1;
    }
    assert!(choices >= 5, "every choice was passed over");
}

#[test]
fn every_default_is_allowed() {
    assert_eq!(Scene::default().check(), Ok(()));
}

#[test]
fn a_scene_made_without_a_preset_is_checked_in_the_same_way() {
    let mut scene = Scene::default();
    scene.camera.r = 0.75;
    assert_eq!(scene.check().unwrap_err().key, "camera.r");
    scene.hole.spin = f64::NAN;
    assert_eq!(scene.check().unwrap_err().key, "hole.spin");
    scene.hole.spin = 0.99;
    assert_eq!(
        scene.check().unwrap_err().key,
        "camera.r",
        "nothing is at rest in the ergosphere"
    );
    scene.observer.kind = ObserverKind::Zamo;
    assert_eq!(scene.check(), Ok(()));
    scene.camera.theta_deg = f64::NAN;
    assert_eq!(scene.check().unwrap_err().key, "camera.theta_deg");
    scene.observer.kind = ObserverKind::Static;
    assert_eq!(scene.check().unwrap_err().key, "camera.theta_deg");
}

#[test]
fn every_closed_end_is_allowed_and_every_open_end_refused() {
    let mut ends = 0;
    for field in FIELDS.iter() {
        let (Kind::Float(_) | Kind::Integer(_)) = field.kind else {
            continue;
        };
        // As narrowed by the other fields' defaults: camera.r by the horizon, the grid by the
        // picture.
        let range = Scene::default().range(field).0;
        for (end, allowed) in [range.low, range.high]
            .into_iter()
            .filter_map(|bound| match bound {
                Included(end) => Some((end, true)),
                Excluded(end) => Some((end, false)),
                Unbounded => None,
            })
        {
            // Ends that another field's default forbids are the next test's.
            if ["disk.outer", "picture.width", "picture.height"].contains(&field.key) {
                continue;
            }
            let outcome = set(field.key, &end.to_string());
            assert_eq!(
                outcome.is_ok(),
                allowed,
                "{} = {end}: {outcome:?}",
                field.key
            );
            ends += 1;
        }
    }
    assert!(ends > 40, "{ends}");
}

#[test]
fn every_number_beyond_its_range_is_refused_with_the_range() {
    let mut refused = 0;
    for field in FIELDS.iter() {
        let (Kind::Float(range) | Kind::Integer(range)) = field.kind else {
            continue;
        };
        let step = |x: f64| (x.abs() * 1e-9).max(1e-9);
        let beyond = |end: f64, sign: f64| match field.kind {
            Kind::Integer(_) => format!("{}", end + sign),
            _ => format!("{}", end + sign * step(end)),
        };
        let ends = [(range.low, -1.0), (range.high, 1.0)];
        for (bound, sign) in ends {
            let (Included(end) | Excluded(end)) = bound else {
                continue;
            };
            let error = set(field.key, &beyond(end, sign)).unwrap_err();
            assert!(
                error.starts_with(&format!("--set: {} = ", field.key)),
                "{error}"
            );
            assert!(error.contains("is refused: it must be "), "{error}");
            refused += 1;
        }
    }
    assert!(refused > 40);
}

#[test]
fn no_number_may_be_nan_or_infinite() {
    for Field { key, kind, .. } in FIELDS.iter() {
        if let Kind::Float(_) = kind {
            for text in [
                "nan", "-nan", "inf", "-inf", "+inf", "NaN", "infinity", "1e999",
            ] {
                assert!(set(key, text).is_err(), "{key} = {text}");
            }
        }
    }
    for velocity in [
        "[nan, 0, 0]",
        "[0, inf, 0]",
        "[1e300, 0, 0]",
        "[0, 0]",
        "[0, 0, 0, 0]",
        "[]",
        "0",
    ] {
        assert!(set("observer.velocity", velocity).is_err(), "{velocity}");
    }
}

#[test]
fn every_field_can_be_set_to_its_own_value_as_text() {
    for (field, value) in Scene::default().values() {
        assert_eq!(
            set(field.key, &value.to_string()),
            Ok(Scene::default()),
            "{}",
            field.key
        );
    }
}

#[test]
fn every_word_of_every_choice_can_be_set() {
    for field in FIELDS.iter() {
        let Kind::Choice(choices) = field.kind else {
            continue;
        };
        for word in choices.iter().map(|choice| choice.word) {
            let scene = set(field.key, word).unwrap();
            assert_eq!(field.get(&scene), Value::Word(word));
        }
    }
}

#[test]
fn a_field_is_found_only_by_its_whole_key() {
    assert_eq!(field("camera.r").unwrap().unit, "r_s");
    assert!(field("camera").is_none() && field("r").is_none() && field("").is_none());
}

#[test]
fn the_text_of_a_preset_reads_back_as_the_same_scene() {
    let mut scene = Scene {
        name: "a \"quoted\" \\ name".into(),
        ..Scene::default()
    };
    scene.hole.spin = -0.1 - 0.2;
    scene.camera.r = 1.0 / 3.0 + 1.0;
    scene.observer.velocity = [1e-300, 0.1, -0.9];
    scene.quality.max_affine = 1e9;
    assert_eq!(load("t.toml", &scene.to_preset(), &[]), Ok(scene));
}

#[test]
fn the_text_of_a_preset_explains_every_field() {
    let text = Scene::default().to_preset();
    for field in FIELDS.iter() {
        assert!(
            text.contains(&format!("# {}: ", field.about)),
            "{}",
            field.key
        );
    }
}
