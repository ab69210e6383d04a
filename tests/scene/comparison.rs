//! The words beside the divider of a comparison.

use lightfall::app::differences;
use lightfall_core::scene::{Method, ObserverKind, Scene, SkyMode, View, presets};

fn preset(name: &str) -> Scene {
    presets::find(name).unwrap().scene(&[]).unwrap()
}

/// The words for one change of preset 3.
fn words(change: fn(&mut Scene)) -> Vec<[String; 2]> {
    let (before, mut after) = (preset("3"), preset("3"));
    change(&mut after);
    differences(&before, &after)
}

#[test]
fn each_change_is_named_with_its_two_values() {
    let changes: [(fn(&mut Scene), [&str; 2]); 9] = [
        (|s| s.effects.lensing = false, ["lensing on", "lensing off"]),
        (
            |s| s.effects.doppler = false,
            ["Doppler shift on", "Doppler shift off"],
        ),
        (
            |s| s.effects.gravitational_shift = false,
            ["gravitational shift on", "gravitational shift off"],
        ),
        (|s| s.hole.spin = 0.9, ["spin 0", "spin 0.9"]),
        (
            |s| s.method = Method::Verlet,
            ["method auto (closed)", "method verlet"],
        ),
        (
            |s| s.view = View::Redshift,
            ["view colour", "view redshift"],
        ),
        (|s| s.disk.enabled = false, ["disk on", "disk off"]),
        (|s| s.sky.mode = SkyMode::Grid, ["sky stars", "sky grid"]),
        (
            |s| s.observer.kind = ObserverKind::Rain,
            ["observer hovering at rest", "observer falling freely"],
        ),
    ];
    for (change, expected) in changes {
        assert_eq!(words(change), [expected.map(str::to_owned)]);
    }
}

#[test]
fn what_both_sides_share_is_not_named() {
    let shared = words(|scene| {
        scene.title = "another".into();
        (scene.camera.r, scene.camera.fov_deg) = (12.0, 40.0);
        scene.probe.enabled = true;
        (scene.picture.exposure_ev, scene.picture.bypass) = (3.0, true);
    });
    assert_eq!(shared, <[[String; 2]; 0]>::default());
}

#[test]
fn presets_are_named_first() {
    let both = differences(&preset("2"), &preset("8"));
    assert_eq!(both[0], ["edge-on", "extremal"].map(str::to_owned));
    let names_a_key = both
        .iter()
        .flatten()
        .any(|words| words.contains(['_', '.']) && words.contains("disk."));
    assert!(!names_a_key, "{both:?}");
}
