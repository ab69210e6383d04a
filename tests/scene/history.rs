//! Undoing restores what was changed, and nothing else.

use lightfall::app::History;
use lightfall_core::scene::{ObserverKind, Scene, presets};
use std::time::Duration;

fn seconds(seconds: u64) -> Duration {
    Duration::from_secs(seconds)
}

#[test]
fn undoing_restores_the_last_change_and_keeps_what_was_flown_since() {
    let start = Scene::default();
    let mut history = History::new(start.clone());
    let mut scene = start.clone();
    scene.disk.enabled = false;
    history.note(&start, &scene, seconds(1));
    scene.camera.r = 7.0;
    let undone = history.undo(&scene).unwrap().unwrap();
    assert!(undone.disk.enabled);
    assert_eq!(undone.camera.r, 7.0);
    assert!(history.undo(&undone).is_none(), "there was one change only");
}

#[test]
fn undoing_a_fall_or_a_journey_returns_the_camera_to_its_start_and_keeps_other_changes() {
    let start = Scene::default();
    let mut history = History::new(start.clone());
    history.note_departure(&start, seconds(1));
    let mut fallen = start.clone();
    (fallen.camera.r, fallen.observer.kind) = (0.4, ObserverKind::Rain);
    fallen.sky.seed += 1;
    let undone = history.undo(&fallen).unwrap().unwrap();
    assert_eq!(
        (undone.camera, undone.observer),
        (start.camera, start.observer)
    );
    assert_eq!(undone.sky.seed, fallen.sky.seed);
    assert!(history.undo(&undone).is_none());
}

#[test]
fn flying_by_hand_since_the_last_change_is_undone_at_once_and_then_the_change() {
    let start = Scene::default();
    let mut history = History::new(start.clone());
    let mut scene = start.clone();
    scene.disk.enabled = false;
    history.note(&start, &scene, seconds(1));
    for second in 2..9 {
        history.note_departure_by_hand(&scene, seconds(second));
        scene.camera.r *= 0.8;
    }
    let undone = history.undo(&scene).unwrap().unwrap();
    assert_eq!(undone.camera, start.camera);
    assert!(!undone.disk.enabled, "the flight came after the change");
    let undone = history.undo(&undone).unwrap().unwrap();
    assert!(undone.disk.enabled);
    assert!(history.undo(&undone).is_none());
}

#[test]
fn loading_a_preset_is_undone_together_with_what_counts_as_loaded() {
    let start = Scene::default();
    let mut history = History::new(start.clone());
    let preset = presets::PRESETS[7].scene(&[]).unwrap();
    history.note_loaded(&start, &preset, seconds(1));
    assert_eq!(*history.loaded(), preset);
    assert_eq!(history.undo(&preset).unwrap().unwrap().into_scene(), start);
    assert_eq!(*history.loaded(), start);
}

#[test]
fn undoing_a_flight_that_began_in_another_scene_restores_the_whole_former_scene() {
    let before = presets::PRESETS[4].scene(&[]).unwrap();
    let start = presets::PRESETS[1].scene(&[]).unwrap();
    let mut history = History::new(before.clone());
    history.note_departure_elsewhere(&before, &start, seconds(1));
    assert_eq!(*history.loaded(), start);
    // The flight has moved what both scenes have in common, too.
    let mut flown = start.clone();
    (flown.camera.yaw_deg, flown.camera.roll_deg) = (40.0, 3.0);
    assert_eq!(history.undo(&flown).unwrap().unwrap().into_scene(), before);
    assert_eq!(*history.loaded(), before);
    assert!(history.undo(&before).is_none(), "it is one change");
}

#[test]
fn dragging_a_slider_is_one_change() {
    let start = Scene::default();
    let mut history = History::new(start.clone());
    let mut scene = start.clone();
    for step in 1..20 {
        let before = scene.clone();
        scene.disk.outer += 1.0;
        history.note(&before, &scene, Duration::from_millis(16 * step));
    }
    assert_eq!(history.undo(&scene).unwrap().unwrap().into_scene(), start);
    // Another field at once, or the same one later, is another change.
    let mut other = start.clone();
    other.disk.inner = 4.0;
    history.note(&start, &other, seconds(1));
    let mut both = other.clone();
    both.disk.outer = 20.0;
    history.note(&other, &both, seconds(1));
    let mut later = both.clone();
    later.disk.outer = 30.0;
    history.note(&both, &later, seconds(9));
    let undone = history.undo(&later).unwrap().unwrap().into_scene();
    assert_eq!(undone, both);
    assert_eq!(history.undo(&undone).unwrap().unwrap().into_scene(), other);
}

#[test]
fn the_history_keeps_its_64_newest_changes() {
    let mut scene = Scene::default();
    let mut history = History::new(scene.clone());
    for step in 0..200 {
        let before = scene.clone();
        scene.disk.enabled = !scene.disk.enabled;
        history.note(&before, &scene, seconds(step));
    }
    let count = std::iter::from_fn(|| history.undo(&scene)).count();
    assert_eq!(count, 64);
}

#[test]
fn a_change_that_the_cameras_place_forbids_to_undo_is_undone_together_with_the_place() {
    // Without the spin that was added, the camera that flew in since would be inside the horizon.
    let start = Scene::default();
    let mut spinning = start.clone();
    spinning.hole.spin = 0.9;
    let mut history = History::new(start.clone());
    history.note(&start, &spinning, seconds(1));
    spinning.camera.r = 0.9;
    assert_eq!(
        history.undo(&spinning).unwrap().unwrap().into_scene(),
        start
    );
}

#[test]
fn a_change_that_cannot_be_undone_says_why() {
    let mut impossible = Scene::default();
    impossible.camera.r = 0.9;
    let mut spinning = impossible.clone();
    spinning.hole.spin = 0.9;
    let mut history = History::new(Scene::default());
    history.note(&impossible, &spinning, seconds(1));
    assert!(
        history
            .undo(&spinning)
            .unwrap()
            .unwrap_err()
            .contains("hole.spin = 0 is refused together with camera.r = 0.9")
    );
}

#[test]
fn undoing_the_light_meter_restores_the_exposure_by_hand() {
    let mut start = Scene::default();
    start.picture.automatic_exposure = false;
    start.picture.exposure_ev = 2.0;
    let mut history = History::new(start.clone());
    let mut scene = start.clone();
    scene.picture.automatic_exposure = true;
    history.note(&start, &scene, seconds(1));
    // What the meter sets is no change of the user's.
    scene.picture.exposure_ev = -1.5;
    let undone = history.undo(&scene).unwrap().unwrap();
    assert_eq!(*undone.scene(), start);
}
