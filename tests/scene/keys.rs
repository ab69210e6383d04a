//! The control table: how each control changes a scene, and which keys it has.

use bevy::prelude::KeyCode;
use lightfall::app::{
    Action, Bindable, Bindings, CONTROLS, Group, KeyLabels, Modifier, RowPreset, checked_change,
    control_named, edited, help_rows, preset_beside, remark,
};
use lightfall_core::scene::{Method, Observer, ObserverKind, Projection, Scene, View, presets};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The scene after a control was used some times, where `loaded` is what was loaded.
fn used_from(loaded: &Scene, scene: &Scene, id: &str, times: usize) -> Scene {
    let control = control_named(id).unwrap();
    (0..times).fold(scene.clone(), |scene, _| {
        let changed = edited(control, &scene, loaded).unwrap();
        checked_change(&scene, changed).unwrap().into_scene()
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
            let changed = edited(control, &scene, &scene);
            match changed.map(|changed| checked_change(&scene, changed)) {
                None => assert!(!changes, "{} changes no scene", control.id),
                // Only its own number leaves a preset as it is.
                Some(Ok(changed))
                    if KeyCode::from_name(&preset.number.to_string()) == Some(control.keys[0]) =>
                {
                    assert_eq!(*changed.scene(), scene);
                }
                // Where only free fall is possible, there is no other observer.
                Some(Ok(changed)) => assert!(
                    *changed.scene() != scene,
                    "{} in {}",
                    control.id,
                    preset.name
                ),
                // Straight rays pass through no matter with depth.
                Some(Err(error)) if control.id == "light.lensing" && scene.has_medium() => {
                    assert!(
                        error.starts_with("effects.lensing = false is refused"),
                        "{error}"
                    );
                }
                Some(Err(error)) => panic!("{} in {}: {error}", control.id, preset.name),
            }
        }
    }
}

#[test]
fn a_switch_used_twice_restores_any_preset() {
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
        "view.delay",
        "view.redshift",
        "view.error",
        "view.steps",
        "picture.bloom",
        "picture.bypass",
        "picture.antialias",
        "picture.dither",
        "picture.levels",
    ];
    for preset in presets::PRESETS {
        let scene = preset.scene(&[]).unwrap();
        let refused = |id: &&str| *id == "light.lensing" && scene.has_medium();
        for id in switches.into_iter().filter(|id| !refused(id)) {
            assert_eq!(used(&scene, id, 2), scene, "{id} in {}", preset.name);
        }
        assert_eq!(used(&scene, "scene.sky_mode", 4), scene, "{}", preset.name);
        // Both take the exposure from the light meter.
        let [brighter, darker] = ["picture.brighter", "picture.darker"];
        let mut by_hand = scene.clone();
        by_hand.picture.automatic_exposure = false;
        assert_eq!(
            used(&used(&scene, brighter, 3), darker, 3),
            by_hand,
            "{}",
            preset.name
        );
    }
}

#[test]
fn the_spin_switch_returns_to_the_presets_spin() {
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
fn the_observer_key_goes_through_the_observers_that_can_exist() {
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

/// What a control says in addition to what it does.
fn feedback_of(scene: &Scene, id: &str) -> String {
    remark(
        control_named(id).unwrap(),
        scene,
        &used(scene, id, 1),
        &Bindings::default(),
    )
    .unwrap_or_default()
}

#[test]
fn the_keys_of_the_pixel_look_say_that_a_dome_has_none() {
    let mut dome = Scene::default();
    dome.camera.projection = Projection::Fisheye;
    for id in ["picture.bypass", "picture.dither", "picture.levels"] {
        assert_eq!(
            feedback_of(&dome, id),
            "only perspective pictures are shown in cells"
        );
    }
}

#[test]
fn a_hole_with_a_tilted_disk_is_not_made_to_spin() {
    let mut tilted = Scene::default();
    tilted.disk.tilt_deg = 30.0;
    let spinning = edited(control_named("scene.spin").unwrap(), &tilted, &tilted).unwrap();
    assert_ne!(spinning.hole.spin, 0.0);
    assert_eq!(
        checked_change(&tilted, spinning).unwrap_err(),
        "around a hole that spins the disk must lie in the equator (its tilt is 30° and must be 0)"
    );
    // An orbit of the camera stays in the equator, and not in the disk's plane.
    (tilted.camera.theta_deg, tilted.observer.kind) = (83.0, ObserverKind::Zamo);
    assert_eq!(
        feedback_of(&tilted, "scene.observer"),
        "an orbit is offered in the plane theta = 90° only (you are 7° off)"
    );
}

#[test]
fn a_skipped_observer_is_named_with_the_reason() {
    let mut scene = Scene::default();
    scene.camera.theta_deg = 83.0;
    scene.observer.kind = ObserverKind::Zamo;
    let off_plane = "an orbit is offered in the disk's plane only (you are 7° off)";
    assert_eq!(feedback_of(&scene, "scene.observer"), off_plane);
    // From at rest to zamo nothing is passed over, and in the plane there is an orbit.
    scene.observer.kind = ObserverKind::Static;
    assert_eq!(
        feedback_of(&scene, "scene.observer"),
        "without spin this is hovering at rest"
    );
    scene.hole.spin = 0.5;
    assert_eq!(feedback_of(&scene, "scene.observer"), "");
    scene.hole.spin = 0.0;
    (scene.camera.theta_deg, scene.observer.kind) = (90.0, ObserverKind::Zamo);
    assert_eq!(feedback_of(&scene, "scene.observer"), "");
    // Inside the horizon only free fall is left, and the key leads back to it.
    (scene.camera.r, scene.observer.kind) = (0.9, ObserverKind::Rain);
    assert_eq!(
        feedback_of(&scene, "scene.observer"),
        "inside the horizon every observer falls"
    );
}

#[test]
fn a_key_without_a_visible_effect_says_why_and_names_the_key_that_helps() {
    let without = |change: fn(&mut Scene)| {
        let mut scene = presets::find("above").unwrap().scene(&[]).unwrap();
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
            "the disk begins at the innermost stable orbit in either case",
        ),
        (
            |scene| scene.method = Method::Verlet,
            "scene.spin",
            "the method is now auto",
        ),
        (
            |scene| scene.view = View::Classes,
            "light.doppler",
            "this view shows no light; B shows it again",
        ),
        (
            |scene| scene.view = View::Redshift,
            "light.beaming",
            "this view shows no light; R shows it again",
        ),
        (
            |scene| scene.disk.enabled = false,
            "light.doppler",
            "nothing in view moves",
        ),
        (
            |_| {},
            "picture.antialias",
            "there is no probe to smooth; F4 adds it",
        ),
        (
            |scene| scene.picture.bypass = true,
            "picture.dither",
            "this shows in the pixel look only; F7 switches it on",
        ),
        (
            |scene| scene.picture.bypass = true,
            "picture.levels",
            "this shows in the pixel look only; F7 switches it on",
        ),
        (
            |_| {},
            "scene.spin",
            "the disk still begins at 3 r_s; U moves it to the innermost stable orbit",
        ),
        (
            |_| {},
            "light.beaming",
            "what approaches is still bluer and looks hotter, so it stays brighter; Z switches that off, too",
        ),
    ] {
        assert_eq!(feedback_of(&without(change), id), words, "{id}");
    }
    // Where there is something to see, there is no feedback.
    let plain = without(|scene| (scene.disk.inner, scene.probe.enabled) = (4.0, true));
    let explained = [
        "scene.observer",
        "scene.spin",
        "light.doppler",
        "light.beaming",
    ];
    for control in CONTROLS
        .iter()
        .filter(|control| matches!(control.action, Action::Edit(_)))
    {
        assert!(
            explained.contains(&control.id) || feedback_of(&plain, control.id).is_empty(),
            "{}: {}",
            control.id,
            feedback_of(&plain, control.id)
        );
    }
}

#[test]
fn a_change_that_cannot_be_drawn_is_refused_with_the_reason() {
    // A camera that only spin keeps outside the horizon.
    let mut deep = Scene::default();
    deep.hole.spin = 0.9;
    deep.camera.r = 0.9;
    deep.observer.kind = ObserverKind::Zamo;
    let without_spin = edited(control_named("scene.spin").unwrap(), &deep, &deep).unwrap();
    let refused = checked_change(&deep, without_spin).unwrap_err();
    assert_eq!(
        refused,
        "zero angular momentum needs a place outside the horizon (r above 1 r_s)"
    );
    // The lower limit is rounded up, so that it is allowed itself.
    let fall = Scene {
        observer: Observer {
            kind: ObserverKind::Rain,
            ..deep.observer
        },
        ..deep.clone()
    };
    let mut deeper = fall.clone();
    deeper.camera.r = 0.1473994654915289;
    assert_eq!(
        checked_change(&fall, deeper).unwrap_err(),
        "too deep for spin 0.9 (r must be above 0.33 r_s)"
    );
    let mut thin = deep.clone();
    thin.disk.outer = 0.123456789;
    let refused = checked_change(&deep, thin).unwrap_err();
    assert!(
        refused.contains("0.1235") && !refused.contains("0.12345"),
        "{refused}"
    );
}

#[test]
fn controls_have_names_and_keys_of_their_own() {
    for (i, control) in CONTROLS.iter().enumerate() {
        assert!(
            !control.keys.is_empty() && !control.description.is_empty(),
            "{}",
            control.id
        );
        for other in &CONTROLS[..i] {
            assert_ne!(other.id, control.id);
            let shared = control.keys.iter().any(|code| other.keys.contains(code));
            assert!(
                !shared || other.modifier != control.modifier,
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
        assert_eq!(KeyCode::from_name(name).and_then(KeyCode::name), Some(name));
        assert_eq!(
            KeyCode::from_name(&name.to_lowercase()).and_then(KeyCode::name),
            Some(name)
        );
    }
    assert_eq!(KeyCode::from_name("Any"), None);
}

#[test]
fn number_keys_load_the_presets() {
    // There are nine such keys; further presets are reached with the others.
    for preset in presets::PRESETS.iter().filter(|preset| preset.number <= 9) {
        assert_eq!(
            used(&Scene::default(), &format!("preset.{}", preset.number), 1),
            preset.scene(&[]).unwrap()
        );
    }
}

#[test]
fn page_up_and_down_go_through_the_presets_and_the_users_own_in_a_circle() {
    let built_in = presets::PRESETS.map(|preset| RowPreset::BuiltIn(preset.name.into()));
    let own: Vec<PathBuf> = vec!["lesson-1.toml".into(), "lesson-2.toml".into()];
    for own in [Vec::new(), own] {
        let row: Vec<RowPreset> = built_in
            .iter()
            .cloned()
            .chain(own.iter().cloned().map(RowPreset::Own))
            .collect();
        for (place, now) in row.iter().enumerate() {
            let beside = |places: i32| preset_beside(now, own.clone(), places);
            assert_eq!(beside(1), row[(place + 1) % row.len()]);
            assert_eq!(beside(-1), row[(place + row.len() - 1) % row.len()]);
        }
        // From any other scene or file, to either end.
        for other in [
            RowPreset::BuiltIn("mine".into()),
            RowPreset::Own("elsewhere.toml".into()),
        ] {
            assert_eq!(preset_beside(&other, own.clone(), 1), row[0]);
            assert_eq!(preset_beside(&other, own.clone(), -1), row[row.len() - 1]);
        }
    }
}

fn settings(id: &str, keys: &[&str]) -> BTreeMap<String, Vec<String>> {
    BTreeMap::from([(
        id.to_owned(),
        keys.iter().map(|key| (*key).to_owned()).collect(),
    )])
}

#[test]
fn settings_bind_keys_and_say_what_is_wrong_with_them() {
    let bound = Bindings::new(
        &settings("view.classes", &["Keypad 1", "Keypad 2"]),
        &KeyLabels::default(),
    )
    .unwrap();
    assert_eq!(
        bound.of("view.classes"),
        ["Keypad 1", "Keypad 2"].map(|name| KeyCode::from_name(name).unwrap())
    );
    assert_eq!(
        bound.settings(),
        settings("view.classes", &["Keypad 1", "Keypad 2"])
    );
    assert_eq!(
        Bindings::new(&BTreeMap::new(), &KeyLabels::default()).unwrap(),
        Bindings::default()
    );
    for (id, keys, expected) in [
        ("view.clases", ["K"], "there is no control view.clases"),
        ("view.classes", ["Any"], "view.classes: unknown key \"Any\""),
        (
            "view.classes",
            ["Alt+K"],
            "view.classes: unknown key \"Alt+K\"",
        ),
    ] {
        let error = Bindings::new(&settings(id, &keys), &KeyLabels::default()).unwrap_err();
        assert!(error.contains(expected), "{error}");
    }
    let mut twice = settings("view.classes", &["W"]);
    twice.extend(settings("fly.forward", &["W"]));
    let error = Bindings::new(&twice, &KeyLabels::default()).unwrap_err();
    assert!(
        error.contains("W is given to both fly.forward and view.classes"),
        "{error}"
    );
}

#[test]
fn a_key_in_the_settings_is_taken_from_the_control_that_has_it_by_default() {
    let w = KeyCode::from_name("W").unwrap();
    let bound = Bindings::new(&settings("view.classes", &["W"]), &KeyLabels::default()).unwrap();
    assert_eq!(bound.owner(w, None).unwrap().id, "view.classes");
    assert!(bound.of("fly.forward").is_empty());
    assert_eq!(
        Bindings::new(&bound.settings(), &KeyLabels::default()).unwrap(),
        bound
    );
}

#[test]
fn a_modifier_belongs_to_a_control_and_its_keys_are_written_with_and_without_it() {
    for name in ["F", "Alt+F"] {
        let bound = Bindings::new(
            &settings("window.fullscreen", &[name]),
            &KeyLabels::default(),
        )
        .unwrap();
        assert_eq!(bound.label("window.fullscreen"), "Alt+F");
        let f = KeyCode::from_name("F").unwrap();
        assert_eq!(
            bound.owner(f, Some(Modifier::Alt)).unwrap().id,
            "window.fullscreen"
        );
        // The same key without the modifier is another one.
        assert_eq!(bound.owner(f, None).unwrap().id, "motion.let_go");
    }
}

#[test]
fn keys_without_a_row_for_the_modifier_keep_their_meaning_with_shift_alone() {
    let bindings = Bindings::default();
    let meant = |name: &str, held| {
        bindings
            .pressed(KeyCode::from_name(name).unwrap(), held)
            .map(|control| control.id)
    };
    assert_eq!(meant("Enter", None), Some("journey.again"));
    assert_eq!(
        meant("Enter", Some(Modifier::Alt)),
        Some("window.fullscreen")
    );
    assert_eq!(meant("P", Some(Modifier::Shift)), Some("window.panel"));
    assert_eq!(meant("P", Some(Modifier::Alt)), None);
    assert_eq!(meant("P", Some(Modifier::Ctrl)), None);
}

#[test]
fn binding_a_key_takes_it_from_its_former_control() {
    let mut bindings = Bindings::default();
    let w = KeyCode::from_name("W").unwrap();
    bindings.bind("window.help", w);
    assert_eq!(bindings.of("window.help"), [w]);
    assert!(bindings.of("fly.forward").is_empty());
    // What was written into the settings is read back as the same.
    assert_eq!(
        Bindings::new(&bindings.settings(), &KeyLabels::default()).unwrap(),
        bindings
    );
}

/// The document's table is made from the table of controls: if this fails, the message holds the
/// text to put between the marks.
#[test]
fn the_table_of_keys_in_the_page_about_the_window_is_that_of_the_help() {
    let bindings = Bindings::default();
    let tables = Group::ALL.map(|group| {
        let rows: String = help_rows(&bindings, group)
            .iter()
            .map(|[keys, words]| format!("| {keys} | {words} |\n"))
            .collect();
        format!("| Key | {} |\n|---|---|\n{rows}", group.title())
    });
    let table = tables.join("\n");
    let page = std::fs::read_to_string("docs/WINDOW.md").unwrap();
    let (_, marked) = page.split_once("<!-- keys -->\n").unwrap();
    let (written, _) = marked.split_once("<!-- end -->").unwrap();
    assert!(written == table, "the table of keys is now\n\n{table}");
}
