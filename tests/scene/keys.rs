//! The key table: what each control does to a scene, and which keys it has.

use bevy::prelude::KeyCode;
use lightfall::app::{Action, Bindings, CONTROLS, Switch, control_named, edited, remark};
use lightfall_core::scene::{Method, ObserverKind, Scene, View, presets};
use std::collections::BTreeMap;

/// The scene after a control was used some times, where `loaded` is what was loaded.
fn used_from(loaded: &Scene, scene: &Scene, id: &str, times: usize) -> Scene {
    let control = control_named(id).unwrap();
    (0..times).fold(scene.clone(), |scene, _| {
        edited(control, &scene, loaded).unwrap().unwrap()
    })
}

fn used(scene: &Scene, id: &str, times: usize) -> Scene {
    used_from(scene, scene, id, times)
}

#[test]
fn every_control_of_the_scene_changes_it_into_one_that_can_be_drawn_from_any_preset() {
    for preset in presets::PRESETS {
        let scene = preset.scene(&[]).unwrap();
        for control in CONTROLS {
            let changes = matches!(control.action, Action::Edit(_) | Action::Load(_));
            match edited(control, &scene, &scene) {
                None => assert!(!changes, "{} changes no scene", control.id),
                // Only its own number leaves a preset as it is.
                Some(Ok(changed))
                    if control.keys[0] == KeyCode::named(&preset.number.to_string()).unwrap() =>
                {
                    assert_eq!(changed, scene);
                }
                // Where only free fall is possible, there is no other observer.
                Some(Ok(changed)) => assert!(changed != scene, "{} in {}", control.id, preset.name),
                Some(Err(error)) => panic!("{} in {}: {error}", control.id, preset.name),
            }
        }
    }
}

#[test]
fn switches_lead_back_when_used_again_from_any_preset() {
    let switches = [
        "scene.disk",
        "scene.isco",
        "scene.sky",
        "scene.probe",
        "scene.spin",
        "light.lensing",
        "light.doppler",
        "light.beaming",
        "light.gravitational_shift",
        "view.unfinished",
        "view.classes",
        "view.residual",
        "view.order",
        "view.redshift",
        "picture.bloom",
        "picture.bypass",
        "picture.antialias",
        "picture.dither",
        "picture.levels",
    ];
    for preset in presets::PRESETS {
        let scene = preset.scene(&[]).unwrap();
        for id in switches {
            assert_eq!(used(&scene, id, 2), scene, "{id} in {}", preset.name);
        }
        assert_eq!(used(&scene, "scene.sky_mode", 3), scene, "{}", preset.name);
        let [brighter, darker] = ["picture.brighter", "picture.darker"];
        assert_eq!(
            used(&used(&scene, brighter, 3), darker, 3),
            scene,
            "{}",
            preset.name
        );
    }
}

#[test]
fn spin_comes_back_as_the_preset_has_it() {
    let extremal = presets::find("extremal").unwrap().scene(&[]).unwrap();
    assert!(extremal.hole.spin > 0.95);
    let without = used(&extremal, "scene.spin", 1);
    assert_eq!(without.hole.spin, 0.0);
    assert_eq!(
        used_from(&extremal, &without, "scene.spin", 1).hole.spin,
        extremal.hole.spin
    );
}

#[test]
fn observers_follow_each_other_as_far_as_they_can_exist() {
    let mut scene = Scene::default();
    let kinds = |scene: &Scene, times| used(scene, "scene.observer", times).observer.kind;
    // Off the disk's plane there is no orbit.
    assert_eq!(
        [1, 2, 3].map(|times| kinds(&scene, times)),
        [ObserverKind::Zamo, ObserverKind::Rain, ObserverKind::Static]
    );
    scene.camera.theta_deg = 90.0;
    assert_eq!(kinds(&scene, 2), ObserverKind::Orbit);
}

/// What a control says beside what it does.
fn said(scene: &Scene, id: &str) -> String {
    remark(
        control_named(id).unwrap(),
        scene,
        &used(scene, id, 1),
        &Bindings::default(),
        false,
    )
    .unwrap_or_default()
}

#[test]
fn an_observer_that_is_passed_over_is_named_with_the_reason() {
    let mut scene = Scene::default();
    scene.camera.theta_deg = 83.0;
    scene.observer.kind = ObserverKind::Zamo;
    let off_plane = "passed over: camera.theta_deg is 83 with observer.kind = \"orbit\"; it must be 90, the plane of the disk";
    assert_eq!(said(&scene, "scene.observer"), off_plane);
    // From at rest to zamo nothing is passed over, and in the plane there is an orbit.
    scene.observer.kind = ObserverKind::Static;
    assert_eq!(said(&scene, "scene.observer"), "");
    (scene.camera.theta_deg, scene.observer.kind) = (90.0, ObserverKind::Zamo);
    assert_eq!(said(&scene, "scene.observer"), "");
    // Inside the horizon only free fall is left, and the key leads back to it.
    (scene.camera.r, scene.observer.kind) = (0.9, ObserverKind::Rain);
    assert_eq!(
        said(&scene, "scene.observer"),
        "inside the horizon everybody falls"
    );
}

#[test]
fn a_key_that_shows_nothing_says_why_and_names_the_key_that_helps() {
    let without = |change: fn(&mut Scene)| {
        let mut scene = presets::find("edge-on").unwrap().scene(&[]).unwrap();
        change(&mut scene);
        scene
    };
    for (change, id, words) in [
        (
            (|scene| scene.disk.enabled = false) as fn(&mut Scene),
            "scene.isco",
            "the disk is off; F2 shows it",
        ),
        (
            |scene| scene.disk.inner = 3.0,
            "scene.isco",
            "the disk begins at the innermost stable orbit either way",
        ),
        (
            |scene| scene.method = Method::Verlet,
            "scene.spin",
            "the method is auto now",
        ),
        (
            |scene| scene.view = View::Classes,
            "light.doppler",
            "this view shows no light; B goes back to it",
        ),
        (
            |scene| scene.view = View::Redshift,
            "light.beaming",
            "this view shows no light; R goes back to it",
        ),
        (
            |scene| scene.disk.enabled = false,
            "light.doppler",
            "nothing that is seen moves",
        ),
        (
            |_| {},
            "picture.antialias",
            "there is no probe to smooth; F4 puts it there",
        ),
        (
            |scene| scene.picture.bypass = true,
            "picture.dither",
            "it shows in cells only; F7 brings them back",
        ),
        (
            |scene| scene.picture.bypass = true,
            "picture.levels",
            "it shows in cells only; F7 brings them back",
        ),
    ] {
        assert_eq!(said(&without(change), id), words, "{id}");
    }
    let (scene, brighter) = (without(|_| {}), control_named("picture.brighter").unwrap());
    let metered = remark(
        brighter,
        &scene,
        &used(&scene, brighter.id, 1),
        &Bindings::default(),
        true,
    );
    assert_eq!(
        metered.as_deref(),
        Some("the exposure follows the light; F9 leaves it to you")
    );
    // Where there is something to see, nothing is said.
    let plain = without(|scene| (scene.disk.inner, scene.probe.enabled) = (4.0, true));
    for control in CONTROLS
        .iter()
        .filter(|control| matches!(control.action, Action::Edit(_)))
    {
        assert!(
            control.id == "scene.observer" || said(&plain, control.id).is_empty(),
            "{}: {}",
            control.id,
            said(&plain, control.id)
        );
    }
}

#[test]
fn a_key_that_would_lead_where_nothing_can_be_drawn_is_refused_with_the_reason() {
    // A camera that only spin keeps outside the horizon.
    let mut deep = Scene::default();
    deep.hole.spin = 0.9;
    deep.camera.r = 0.9;
    deep.observer.kind = ObserverKind::Zamo;
    let refused = edited(control_named("scene.spin").unwrap(), &deep, &deep)
        .unwrap()
        .unwrap_err();
    assert!(
        refused.starts_with("camera.r = 0.9 is refused"),
        "{refused}"
    );
}

#[test]
fn controls_have_names_and_keys_of_their_own() {
    for (i, control) in CONTROLS.iter().enumerate() {
        assert!(
            !control.keys.is_empty() && !control.does.is_empty(),
            "{}",
            control.id
        );
        for other in &CONTROLS[..i] {
            assert_ne!(other.id, control.id);
            let shared = control.keys.iter().any(|code| other.keys.contains(code));
            assert!(
                !shared || other.alt != control.alt,
                "{} and {} share a key",
                other.id,
                control.id
            );
        }
        for code in control.keys {
            assert!(
                KeyCode::name(*code).is_some(),
                "a key of {} has no name",
                control.id
            );
        }
    }
}

#[test]
fn names_of_keys_are_read_back_as_the_same_keys() {
    for name in KeyCode::names() {
        assert_eq!(KeyCode::named(name).and_then(KeyCode::name), Some(name));
        assert_eq!(
            KeyCode::named(&name.to_lowercase()).and_then(KeyCode::name),
            Some(name)
        );
    }
    assert_eq!(KeyCode::named("Any"), None);
}

#[test]
fn number_keys_load_the_presets() {
    for preset in presets::PRESETS {
        assert_eq!(
            used(&Scene::default(), &format!("preset.{}", preset.number), 1),
            preset.scene(&[]).unwrap()
        );
    }
}

#[test]
fn page_up_and_down_go_round_the_presets() {
    let count = presets::PRESETS.len();
    let mut scene = presets::PRESETS[0].scene(&[]).unwrap();
    for place in (1..count).chain([0]) {
        scene = used(&scene, "preset.next", 1);
        assert_eq!(scene, presets::PRESETS[place].scene(&[]).unwrap());
    }
    assert_eq!(
        used(&scene, "preset.previous", 1),
        presets::PRESETS[count - 1].scene(&[]).unwrap()
    );
    // From a scene of one's own, to either end.
    scene.name = "mine".into();
    assert_eq!(
        used(&scene, "preset.next", 1),
        presets::PRESETS[0].scene(&[]).unwrap()
    );
    assert_eq!(
        used(&scene, "preset.previous", 1),
        presets::PRESETS[count - 1].scene(&[]).unwrap()
    );
}

fn settings(id: &str, keys: &[&str]) -> BTreeMap<String, Vec<String>> {
    BTreeMap::from([(
        id.to_owned(),
        keys.iter().map(|key| (*key).to_owned()).collect(),
    )])
}

#[test]
fn settings_bind_keys_anew_and_say_what_is_wrong_with_them() {
    let bound = Bindings::new(&settings("view.classes", &["K", "F10"])).unwrap();
    assert_eq!(
        bound.of("view.classes"),
        ["K", "F10"].map(|name| KeyCode::named(name).unwrap())
    );
    assert_eq!(bound.settings(), settings("view.classes", &["K", "F10"]));
    assert_eq!(
        Bindings::new(&BTreeMap::new()).unwrap(),
        Bindings::default()
    );
    for (id, keys, said) in [
        ("view.clases", ["K"], "there is no control view.clases"),
        (
            "view.classes",
            ["Any"],
            "view.classes is given the key \"Any\", which is none",
        ),
        (
            "view.classes",
            ["W"],
            "W is given to both fly.forward and view.classes",
        ),
    ] {
        let error = Bindings::new(&settings(id, &keys)).unwrap_err();
        assert!(error.contains(said), "{error}");
    }
}

#[test]
fn a_key_bound_by_hand_is_taken_from_whoever_had_it() {
    let mut bindings = Bindings::default();
    let w = KeyCode::named("W").unwrap();
    bindings.bind("window.help", w);
    assert_eq!(bindings.of("window.help"), [w]);
    assert!(bindings.of("fly.forward").is_empty());
    // What was written into the settings is read back as the same.
    assert_eq!(Bindings::new(&bindings.settings()).unwrap(), bindings);
}
