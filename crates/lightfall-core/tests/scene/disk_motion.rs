//! The clock of a disk that moves: where it counts, how a moved camera changes it, and how journeys
//! drive it.

use crate::journey_faults::without_line;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::scene::journey::{self, Journey};
use lightfall_core::scene::{DiskStructure, HotSpotKind, ObserverKind, Scene, View};

/// A scene whose disk moves.
fn living() -> Scene {
    let mut scene = Scene::default();
    scene.disk.structure = DiskStructure::Turbulent;
    scene
}

fn journey(text: &str) -> Journey {
    journey::load("j.toml", text).unwrap()
}

/// The disk's time and rate of a journey through `start` after some seconds.
fn clock(journey: &Journey, start: &Scene, seconds: f64) -> [f64; 2] {
    let [mut first, mut next] = [start.clone(), start.clone()];
    journey.apply(0.0, &mut first);
    journey.apply(seconds, &mut next);
    journey.drive_clock([0.0, seconds], &first, &mut next);
    [next.disk.time, next.disk.rate]
}

#[test]
fn a_disk_moves_if_it_is_there_and_has_structure_or_a_hot_spot() {
    assert!(!Scene::default().disk_moves());
    assert!(living().disk_moves() && living().shows_disk_motion());
    let mut scene = Scene::default();
    scene.hot_spot.kind = HotSpotKind::Sheared;
    assert!(scene.disk_moves());
    scene.disk.enabled = false;
    assert!(!scene.disk_moves());
    for view in View::ALL {
        let scene = Scene { view, ..living() };
        assert!(scene.disk_moves());
        let light = matches!(view, View::Colour | View::Unfinished);
        assert_eq!(scene.shows_disk_motion(), light, "{view:?}");
    }
}

/// Far out the light keeps t - r*, whose slope is that of the tortoise coordinate. Next to the
/// horizon the clock's ingoing time, t + r* outside and the clock itself inside, has no jump. Both
/// sides of the photon orbit agree there.
#[test]
fn a_moved_camera_keeps_outgoing_time_far_out_and_ingoing_time_at_the_horizon() {
    for spin in [-0.9, 0.0, 0.7, 0.998] {
        let mut scene = living();
        scene.hole.spin = spin;
        let kerr = Kerr { spin };
        let lead = |r: f64| scene.disk_time_lead(r);
        let tortoise = |r: f64| kerr.ingoing_time_lead(r);
        let far = lead(50.0) - lead(5.0) - (tortoise(50.0) - tortoise(5.0));
        assert!(far.abs() < 1e-12, "{spin}: {far:e}");
        let turn = kerr.photon_orbit_polar();
        let kink = lead(turn * (1.0 + 1e-12)) - lead(turn * (1.0 - 1e-12));
        // Twice the way in r*, whose slope is r^2/Delta, a few here.
        assert!(kink.abs() < 1e-10, "{spin}: {kink:e}");
        let horizon = kerr.horizon();
        let inside = lead(horizon * 0.99);
        for above in [1e-3, 1e-6, 1e-9] {
            let r = horizon * (1.0 + above);
            let ingoing = lead(r) + tortoise(r);
            assert!((ingoing - inside).abs() < 1e-12, "{spin}: {ingoing}");
        }
    }
    let mut flat = living();
    flat.effects.lensing = false;
    assert_eq!(flat.disk_time_lead(7.0) - flat.disk_time_lead(2.0), 5.0);
}

#[test]
fn a_journey_without_a_word_about_the_clock_runs_it_at_the_scenes_rate() {
    let journey =
        journey("[[keyframe]]\ntime = 3\nyaw_deg = 0\n[[keyframe]]\ntime = 7\nyaw_deg = 9\n");
    let mut scene = living();
    (scene.disk.time, scene.disk.rate) = (100.0, 2.5);
    assert_eq!(clock(&journey, &scene, 0.0), [100.0, 2.5]);
    assert_eq!(clock(&journey, &scene, 3.0), [107.5, 2.5]);
    assert_eq!(clock(&journey, &scene, 40.0), [200.0, 2.5], "after its end");
    // A smooth disk has no clock.
    let smooth = Scene::default();
    assert_eq!(clock(&journey, &smooth, 3.0), [0.0, 4.0]);
}

/// The rate is linear between keyframes, so the time is a parabola there.
#[test]
fn a_journeys_rate_is_linear_and_its_time_the_exact_integral() {
    let journey = journey(
        "[[keyframe]]\ntime = 10\n[[keyframe]]\ntime = 12\ndisk_rate = 2\n\
         [[keyframe]]\ntime = 16\ndisk_rate = 10\n[[keyframe]]\ntime = 18\ndisk_rate = 0\n",
    );
    let scene = living();
    let expected = |t: f64| match t {
        _ if t < 2.0 => [2.0 * t, 2.0],
        _ if t < 6.0 => [
            4.0 + 2.0 * (t - 2.0) + (t - 2.0).powi(2),
            2.0 + 2.0 * (t - 2.0),
        ],
        _ if t < 8.0 => [
            28.0 + 10.0 * (t - 6.0) - 2.5 * (t - 6.0).powi(2),
            10.0 - 5.0 * (t - 6.0),
        ],
        _ => [38.0, 0.0],
    };
    for step in 0..40 {
        let t = 0.25 * f64::from(step);
        let (found, expected) = (clock(&journey, &scene, t), expected(t));
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{t}: {found} {expected}");
        }
    }
    // In parts, as a window flies it, forward and back.
    let mut now = scene.clone();
    let mut from = 0.0;
    for to in [0.5, 4.25, 7.0, 1.0, 9.0] {
        let mut next = now.clone();
        journey.apply(to, &mut next);
        journey.drive_clock([from, to], &now, &mut next);
        (now, from) = (next, to);
        assert!((now.disk.time - expected(to)[0]).abs() < 1e-12, "{to}");
    }
}

#[test]
fn a_keyframe_with_a_time_sets_the_clock_there() {
    let journey = journey(
        "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 2\ndisk_time = -50\n[[keyframe]]\ntime = 4\n",
    );
    let mut scene = living();
    scene.disk.time = 7.0;
    assert_eq!(clock(&journey, &scene, 1.0)[0], 11.0);
    assert_eq!(clock(&journey, &scene, 2.0)[0], -50.0);
    assert_eq!(clock(&journey, &scene, 3.5)[0], -44.0);
}

/// A journey into the hole, twice as far in every second. What is seen of the disk depends on t -
/// r* outside the photon orbit, and on the ingoing time inside: it advances by the rate alone.
#[test]
fn a_journey_through_the_horizon_neither_leaps_nor_runs_backward() {
    let journey = journey(
        "[[keyframe]]\ntime = 0\nr = 30\nobserver = \"rain\"\n[[keyframe]]\ntime = 10\nr = 0.3\n",
    );
    let scene = living();
    let kerr = Kerr { spin: 0.0 };
    let stage = |t: f64| {
        let mut there = scene.clone();
        journey.apply(t, &mut there);
        let (r, time) = (there.camera.r, clock(&journey, &scene, t)[0]);
        match r {
            _ if r >= 1.5 => time - kerr.ingoing_time_lead(r),
            _ if r > 1.0 => time + kerr.ingoing_time_lead(r) - 2.0 * kerr.ingoing_time_lead(1.5),
            _ => time - 2.0 * kerr.ingoing_time_lead(1.5),
        }
    };
    let start = stage(0.0);
    for step in 0..1000 {
        let t = 0.01 * f64::from(step);
        let passed = stage(t) - start;
        assert!((passed - 4.0 * t).abs() < 1e-9, "{t}: {passed}");
    }
    let mut end = scene.clone();
    journey.apply(10.0, &mut end);
    assert!(end.camera.r < 1.0 && end.observer.kind == ObserverKind::Rain);
}

#[test]
fn faults_of_a_journeys_clock_are_reported() {
    let fault = |line: &str| {
        let text = format!("[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 1\n{line}");
        without_line(&journey::load("j.toml", &text).unwrap_err().to_string())
    };
    assert_eq!(
        fault("disk_rate = -1"),
        "j.toml: keyframe 2: disk_rate = -1 is refused: it must be a number from 0 to 1000 r_s/c"
    );
    assert!(fault("disk_time = \"noon\"").contains("keyframe 2: disk_time = \"noon\" is refused"));
    assert!(fault("rain.disk_time = 4").contains("keyframe 2: there is no rain.disk_time; "));
}

#[test]
fn read_outs_follow_the_clock_and_the_spot_only_where_there_is_a_spot() {
    let needed_later = |scene: &Scene| {
        let mut later = scene.clone();
        later.disk.time += 10.0;
        later.for_readouts()
    };
    let mut scene = Scene::default();
    assert_eq!(scene.for_readouts(), needed_later(&scene));
    scene.hot_spot.kind = HotSpotKind::Rigid;
    assert_ne!(scene.for_readouts(), needed_later(&scene));
    let mut moved = scene.clone();
    moved.hot_spot.r += 1.0;
    assert_ne!(scene.for_readouts(), moved.for_readouts());
}
