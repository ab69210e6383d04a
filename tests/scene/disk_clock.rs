//! The clock of a disk that moves, as the window and sequences run it.

use lightfall::app::{
    DiskClock, FlightStep, FreeFall, History, JourneyPlayer, differences, disk_rate_words,
    stepped_rate,
};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::numbers::duration_in_words;
use lightfall_core::optics::readout::si::{HoleMass, MASSES};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::journey::{self, Journey};
use lightfall_core::scene::{DiskStructure, HotSpotKind, ObserverKind, Scene};
use lightfall_picture::{Frames, Sequence};
use lightfall_render::{DetailLimits, Pinned};
use std::path::Path;
use std::time::Duration;
use wgpu::DeviceType;

const FRAME: f64 = 1.0 / 60.0;

fn living() -> Scene {
    let mut scene = Scene::default();
    scene.disk.structure = DiskStructure::Turbulent;
    scene
}

/// A flight inward, with a clock that gets faster.
fn inward() -> Journey {
    let text = "[[keyframe]]\ntime = 0\nr = 30\ndisk_rate = 2\n[[keyframe]]\ntime = 6\nr = 5\ndisk_rate = 8\n";
    journey::load("in.toml", text).unwrap()
}

fn sequence(journey: Option<Journey>, fps: f64) -> Sequence {
    let frames = "0..999".parse::<Frames>().unwrap();
    Sequence::new(journey, frames, fps, Path::new("a.png")).unwrap()
}

#[test]
fn the_clock_runs_by_its_rate_and_a_frame_lasts_no_longer_than_a_quarter_of_a_second() {
    let (mut clock, mut scene) = (DiskClock::default(), living());
    scene.disk.time = 50.0;
    for _ in 0..120 {
        scene.disk.time = clock.advance(FRAME, &scene);
    }
    assert!((scene.disk.time - 58.0).abs() < 1e-9, "two seconds at 4");
    let before = scene.disk.time;
    assert_eq!(clock.advance(0.0, &scene), before, "paused");
    assert_eq!(
        clock.advance(1000.0, &scene),
        before + 1.0,
        "the machine slept"
    );
}

#[test]
fn a_hand_that_moves_the_camera_does_not_move_the_disk() {
    let (mut clock, mut scene) = (DiskClock::default(), living());
    scene.disk.time = clock.advance(0.0, &scene);
    let kerr = Kerr { spin: 0.0 };
    let stage = |scene: &Scene| scene.disk.time - kerr.ingoing_time_lead(scene.camera.r);
    let start = stage(&scene);
    for r in [19.0, 12.0, 5.0, 3.0, 400.0, 20.0] {
        scene.camera.r = r;
        scene.disk.time = clock.advance(0.0, &scene);
        assert!((stage(&scene) - start).abs() < 1e-9, "{r}");
    }
    // Turning the camera, and going round the hole, is no reason to change the clock.
    (scene.camera.yaw_deg, scene.camera.phi_deg) = (30.0, 80.0);
    assert_eq!(clock.advance(0.0, &scene), scene.disk.time);
}

#[test]
fn a_scene_that_was_loaded_begins_at_its_own_time() {
    let (mut clock, mut scene) = (DiskClock::default(), living());
    scene.disk.time = clock.advance(FRAME, &scene);
    let mut other = living();
    (other.name, other.camera.r, other.disk.time) = ("other".into(), 6.0, -30.0);
    assert_eq!(clock.advance(0.0, &other), -30.0);
    // Also one that has the same time by chance.
    let mut third = other.clone();
    (third.name, third.camera.r) = ("third".into(), 60.0);
    assert_eq!(clock.advance(0.0, &third), -30.0);
    // An edit of the time counts as well, wherever the camera goes in the same frame.
    (third.camera.r, third.disk.time) = (9.0, 12.0);
    assert_eq!(clock.advance(0.0, &third), 12.0);
}

#[test]
fn keys_double_and_halve_the_rate_within_a_range() {
    assert_eq!(stepped_rate(4.0, 1), 8.0);
    assert_eq!(stepped_rate(4.0, -1), 2.0);
    assert_eq!(stepped_rate(800.0, 1), 1000.0);
    assert_eq!(stepped_rate(1.0 / 64.0, -1), 1.0 / 64.0);
    assert_eq!(stepped_rate(0.0, 1), 1.0 / 64.0);
    assert_eq!(stepped_rate(0.0, -1), 0.0);
    // A slower rate, typed on the panel, is kept and can be left.
    assert_eq!(stepped_rate(0.001, -1), 0.001);
    assert_eq!(stepped_rate(0.001, 1), 0.002);
}

#[test]
fn a_second_of_the_window_is_said_in_times_of_the_chosen_hole() {
    // r_s/c of Sgr A* is 42.35 s here, so that 4 r_s/c are 169.4 s.
    let words = disk_rate_words(4.0, MASSES[0], Units::Hole);
    assert_eq!(
        words,
        "Disk's clock: 4 r_s/c per second (2.82 minutes for Sgr A*)"
    );
    let own = disk_rate_words(0.5, HoleMass::of_suns(1.23e5), Units::Hole);
    assert!(own.ends_with("(606 ms for this hole)"), "{own}");
    for (seconds, words) in [
        (0.0, "0 s"),
        (0.25, "250 ms"),
        (59.0, "59 s"),
        (5400.0, "1.5 hours"),
        (86_400.0 * 2.0, "2 days"),
        (86_400.0, "1 day"),
        (3.155_76e7, "1 year"),
        (3.155_76e8, "10 years"),
    ] {
        assert_eq!(duration_in_words(seconds), words);
    }
}

#[test]
fn the_clock_makes_no_entry_in_the_history_and_breaks_none() {
    let start = living();
    let mut history = History::new(start.clone());
    let mut scene = start.clone();
    // A slider that is dragged while the clock runs is one change.
    for step in 1..20 {
        scene.disk.time += 4.0 * FRAME;
        let before = scene.clone();
        scene.disk.outer += 1.0;
        history.note(&before, &scene, Duration::from_millis(16 * step));
    }
    scene.disk.time = 77.0;
    let undone = history.undo(&scene).unwrap().unwrap().into_scene();
    assert_eq!(undone.disk.outer, start.disk.outer);
    assert_eq!(undone.disk.time, 77.0, "the clock is not put back");
    assert!(history.undo(&undone).is_none(), "there was one change");
    // The time that a user sets is a change like others.
    let mut set = undone.clone();
    set.disk.time = 500.0;
    history.note(&undone, &set, Duration::from_secs(9));
    set.disk.time = 501.0;
    assert_eq!(history.undo(&set).unwrap().unwrap().disk.time, 77.0);
}

#[test]
fn undoing_a_journey_restores_the_rate_that_it_has_changed() {
    let start = living();
    let mut history = History::new(start.clone());
    history.note_departure(&start, Duration::from_secs(1));
    let mut flown = start.clone();
    (flown.camera.r, flown.disk.rate, flown.disk.time) = (5.0, 40.0, 90.0);
    let undone = history.undo(&flown).unwrap().unwrap();
    assert_eq!((undone.camera, undone.disk.rate), (start.camera, 4.0));
    assert_eq!(undone.disk.time, 90.0);
}

#[test]
fn frames_of_a_sequence_differ_by_the_rate_over_the_frame_rate() {
    let mut scene = living();
    (scene.disk.time, scene.disk.rate) = (10.0, 3.0);
    let still = sequence(None, 24.0);
    for number in [0, 1, 2, 240] {
        let frame = still.scene(&scene, number);
        let time = 10.0 + 3.0 * f64::from(number) / 24.0;
        assert!((frame.disk.time - time).abs() < 1e-12, "{number}");
        assert_eq!(frame.without_clock(), scene.without_clock());
    }
    assert_eq!(still.end(), None);
    // Nothing moves on a smooth disk.
    let smooth = Scene::default();
    assert_eq!(still.scene(&smooth, 100), smooth);
    // A journey that leads nowhere is the same as none.
    let nowhere = "[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 5\nr = 20\n";
    let nowhere = sequence(Some(journey::load("j", nowhere).unwrap()), 24.0);
    let frame = nowhere.scene(&scene, 240);
    assert!(
        (frame.disk.time - 40.0).abs() < 1e-12,
        "{}",
        frame.disk.time
    );
}

#[test]
fn a_journey_drives_the_clock_in_the_window_as_in_a_sequence() {
    let mut scene = living();
    scene.disk.time = 20.0;
    let sequence = sequence(Some(inward()), 60.0);
    let mut player = JourneyPlayer::new(inward());
    player.restart();
    let mut now = scene.clone();
    for number in 0..300 {
        now = match player.advance(FRAME, &now, false) {
            FlightStep::Moved(next) => next.into_scene(),
            other => panic!("{other:?}"),
        };
        let frame = sequence.scene(&scene, number);
        assert!(
            (now.disk.time - frame.disk.time).abs() < 1e-9,
            "frame {number}: {} {}",
            now.disk.time,
            frame.disk.time
        );
        assert!((now.disk.rate - frame.disk.rate).abs() < 1e-9);
    }
    // A paused journey has a paused clock.
    match player.advance(0.0, &now, false) {
        FlightStep::Moved(next) => assert_eq!(next.disk.time, now.disk.time),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_fall_drives_the_clock_and_a_paused_fall_does_not() {
    let mut scene = living();
    scene.observer.kind = ObserverKind::Rain;
    let mut fall = FreeFall::default();
    fall.start(&scene).unwrap();
    for _ in 0..30 {
        let step = fall.advance(FRAME, &scene);
        let FlightStep::Moved(next) = step else {
            panic!("{step:?}")
        };
        scene = next.into_scene();
    }
    let far = fall.worldline().unwrap().coordinate_time().unwrap();
    // Sums of thirty differences of r*, about 20.
    assert!((scene.disk.time - far).abs() < 1e-11, "{far}");
    match fall.advance(0.0, &scene) {
        FlightStep::Moved(next) => assert_eq!(next.disk.time, scene.disk.time),
        other => panic!("{other:?}"),
    }
}

#[test]
fn both_sides_of_a_comparison_have_one_clock() {
    let mut scene = living();
    let mut pinned = Pinned::new(&scene);
    scene.disk.time = 33.0;
    scene.disk.structure = DiskStructure::None;
    scene.hot_spot.kind = HotSpotKind::Rigid;
    pinned.follow(&scene);
    let drawn = pinned.drawable().unwrap();
    assert_eq!(drawn.disk.time, 33.0);
    assert_eq!(drawn.disk.structure, DiskStructure::Turbulent);
    let words = differences(&drawn, &scene).concat().join(", ");
    assert!(!words.contains("clock"), "{words}");
}

#[test]
fn a_window_on_a_software_renderer_draws_fewer_waves() {
    let cpu = DetailLimits::of_window(DeviceType::Cpu);
    assert_eq!((cpu.drawn_waves(24), cpu.drawn_waves(12)), (12, 12));
    for kind in [DeviceType::DiscreteGpu, DeviceType::IntegratedGpu] {
        assert_eq!(DetailLimits::of_window(kind).drawn_waves(48), 48);
    }
}
