//! Scenes as a preset and what differs from it.

use lightfall_core::scene::presets::{PRESETS, find};
use lightfall_core::scene::{Changes, Method, Override, Scene, SkyMode};

/// The scene that the changes make.
fn made(changes: &Changes) -> Scene {
    let fields = changes.fields.iter();
    let overrides: Vec<_> = fields
        .map(|(key, value)| Override::new("the link", key, &value.to_string()))
        .collect();
    changes.preset.scene(&overrides).unwrap()
}

#[test]
fn a_preset_needs_no_changes() {
    for preset in PRESETS {
        let changes = Changes::of(preset.plain_scene());
        assert_eq!(changes.preset.name, preset.name);
        assert_eq!(changes.fields, []);
    }
}

#[test]
fn changes_make_the_same_scene_again() {
    for preset in PRESETS {
        let mut scene = preset.plain_scene().clone();
        scene.hole.spin = 0.1 + 0.2;
        scene.method = Method::Mino;
        scene.camera.phi_deg += 12.5;
        scene.sky.mode = SkyMode::Grid;
        scene.picture.automatic_exposure = false;
        scene.picture.exposure_ev = -1.0 / 3.0;
        assert_eq!(made(&Changes::of(&scene)), scene, "{}", preset.name);
    }
}

#[test]
fn a_scene_of_another_name_is_made_from_the_default_preset() {
    let mut scene = find("close").unwrap().plain_scene().clone();
    (scene.name, scene.title) = ("my-place".into(), "It's \"mine\"".into());
    let changes = Changes::of(&scene);
    assert_eq!(changes.preset.name, "edge-on");
    assert_eq!(made(&changes), scene);
}

#[test]
fn a_metered_exposure_is_not_a_change() {
    let mut scene = find("edge-on").unwrap().plain_scene().clone();
    assert!(scene.picture.automatic_exposure);
    scene.picture.exposure_ev += 1.0;
    assert_eq!(Changes::of(&scene).fields, []);
}
