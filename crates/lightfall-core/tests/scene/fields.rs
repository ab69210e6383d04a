//! The field table against the Scene that it describes.

use std::collections::BTreeSet;
use std::ops::Bound::{Excluded, Included, Unbounded};

use lightfall_core::scene::{FIELDS, Field, Kind, ObserverKind, Override, Scene, field, load};

fn set(key: &str, value: &str) -> Result<Scene, String> {
    load("t.toml", "", &[Override::new("--set", key, value)]).map_err(|error| error.to_string())
}

fn value_of(scene: &Scene, field: &Field) -> String {
    scene
        .values()
        .find(|(other, _)| other.key == field.key)
        .unwrap()
        .1
        .to_string()
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
    for Field { key, kind, .. } in FIELDS {
        let Kind::Choice(words) = kind else { continue };
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
fn a_scene_that_no_preset_went_into_is_checked_alike() {
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
    for field in FIELDS {
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
        }
    }
}

#[test]
fn every_number_refuses_what_lies_beyond_its_range_and_names_the_range() {
    let mut refused = 0;
    for field in FIELDS {
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
    for Field { key, kind, .. } in FIELDS {
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
fn every_field_can_be_set_by_its_key_to_what_it_is() {
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
fn every_word_of_every_choice_is_kept() {
    for field in FIELDS {
        let Kind::Choice(words) = field.kind else {
            continue;
        };
        for word in words {
            let scene = set(field.key, word).unwrap();
            assert_eq!(value_of(&scene, field), format!("\"{word}\""));
        }
    }
}

#[test]
fn a_field_is_found_by_its_whole_key_only() {
    assert_eq!(field("camera.r").unwrap().unit, "r_s");
    assert!(field("camera").is_none() && field("r").is_none() && field("").is_none());
}

#[test]
fn the_preset_that_is_shown_is_the_scene_that_was_meant() {
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
fn the_preset_that_is_shown_explains_every_field() {
    let text = Scene::default().to_preset();
    for field in FIELDS {
        assert!(
            text.contains(&format!("# {}: ", field.about)),
            "{}",
            field.key
        );
    }
}
