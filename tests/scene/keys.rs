//! The key table: what each key does to a scene.

use lightfall::flight::{self, KEYS};
use lightfall::scene::{ObserverKind, Scene, presets};

fn pressed(scene: &Scene, name: &str, times: usize) -> Scene {
    let key = KEYS.iter().find(|key| key.name == name).unwrap();
    let mut scene = scene.clone();
    (0..times).for_each(|_| (key.edit)(&mut scene));
    scene
}

#[test]
fn every_key_changes_the_scene_into_one_that_is_allowed() {
    let scene = Scene::default();
    for key in KEYS {
        let changed = pressed(&scene, key.name, 1);
        assert_ne!(changed, scene, "{} changes nothing", key.name);
        assert!(changed.check().is_ok(), "{} leads where no scene may be", key.name);
    }
}

#[test]
fn keys_that_switch_lead_back_when_pressed_again() {
    for name in ["F2", "F7", "F11", "T", "U", "L", "Z", "X", "C", "B", "M", "N", "R"] {
        assert_eq!(pressed(&Scene::default(), name, 2), Scene::default(), "{name}");
    }
    assert_eq!(pressed(&Scene::default(), "G", 3), Scene::default());
}

#[test]
fn a_key_that_would_lead_where_nothing_can_be_drawn_is_refused_with_the_reason() {
    // A camera that only spin keeps outside the horizon.
    let mut deep = Scene::default();
    deep.hole.spin = 0.9;
    deep.camera.r = 0.9;
    deep.observer.kind = ObserverKind::Zamo;
    let spin = KEYS.iter().find(|key| key.name == "T").unwrap();
    assert!(flight::pressed(spin, &deep).unwrap_err().starts_with("camera.r = 0.9 is refused"));
    for key in KEYS {
        for preset in presets::PRESETS {
            assert!(flight::pressed(key, &preset.scene(&[]).unwrap()).is_ok(), "{} in {}", key.name, preset.name);
        }
    }
}

#[test]
fn keys_have_names_and_codes_of_their_own() {
    for (i, key) in KEYS.iter().enumerate() {
        assert!(KEYS[..i].iter().all(|other| other.name != key.name && other.code != key.code), "{}", key.name);
    }
}

#[test]
fn number_keys_load_the_presets() {
    for preset in presets::PRESETS {
        assert_eq!(pressed(&Scene::default(), &preset.number.to_string(), 1), preset.scene(&[]).unwrap());
    }
}
