//! Flights that steer themselves: the guided journey and free motion, frame by frame, and how they
//! end when something else moves the camera.

use lightfall::app::{FlightStep, FreeFall, JourneyPlayer};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{Method, ObserverKind, Scene, journey, presets};

const FRAME: f64 = 1.0 / 60.0;

fn preset(name: &str) -> Scene {
    presets::find(name).unwrap().scene(&[]).unwrap()
}

fn player() -> JourneyPlayer {
    JourneyPlayer::new(journey::load("default.toml", journey::DEFAULT).unwrap())
}

/// The scene after a step that goes on.
#[track_caller]
fn next(step: FlightStep) -> Scene {
    match step {
        FlightStep::Moved(scene) => scene.into_scene(),
        other => panic!("{other:?}"),
    }
}

/// By how much what the camera sees has moved: in ln r and in its axes.
fn moved(a: &Scene, b: &Scene) -> f64 {
    let axes = |scene: &Scene| scene.camera.tetrad() * scene.camera.tetrad_from_camera();
    let [one, two] = [axes(a), axes(b)];
    (a.camera.r / b.camera.r).ln().abs()
        + (one.z_axis - two.z_axis).length()
        + (one.y_axis - two.y_axis).length()
}

#[test]
fn a_journey_starts_gently_from_anywhere_and_reaches_its_end_without_a_jump() {
    for (name, kind) in [
        ("above", ObserverKind::Static),
        ("limit", ObserverKind::Rain),
    ] {
        let mut scene = preset(name);
        scene.observer.kind = kind;
        let (mut player, start) = (player(), scene.clone());
        player.start(&scene);
        scene = next(player.advance(FRAME, &scene, false));
        assert!(
            moved(&start, &scene) < 1e-9,
            "it begins where the camera is"
        );
        let mut frames = 0;
        loop {
            let before = scene.clone();
            let step = player.advance(FRAME, &scene, false);
            let ended = matches!(step, FlightStep::Ended(_));
            match step {
                FlightStep::Moved(after) | FlightStep::Ended(after) => scene = after.into_scene(),
                other => panic!("{other:?} after {frames} frames"),
            }
            // A tenth a frame is fast, but no jump: the way to the start is twenty times as far as
            // the camera stood.
            assert!(
                moved(&before, &scene) < 0.1,
                "{} after {frames} frames",
                moved(&before, &scene)
            );
            frames += 1;
            if ended {
                break;
            }
        }
        assert!((131.0..133.0).contains(&(f64::from(frames) * FRAME)));
        assert_eq!(scene.camera.r < 1.0, kind == ObserverKind::Rain);
        assert!(!player.is_playing() && player.advance(FRAME, &scene, false) == FlightStep::Idle);
    }
}

#[test]
fn moving_the_camera_ends_a_journey_which_can_then_go_on() {
    let mut scene = preset("edge-on");
    let mut player = player();
    player.restart();
    for _ in 0..600 {
        scene = next(player.advance(FRAME, &scene, false));
    }
    let time = player.time();
    assert!((time - 10.0).abs() < 0.1);
    // Other changes than of the camera do not end it.
    scene.disk.enabled = false;
    scene = next(player.advance(FRAME, &scene, false));
    assert!(!scene.disk.enabled);
    scene.camera.yaw_deg += 0.01;
    assert_eq!(player.advance(FRAME, &scene, false), FlightStep::Idle);
    assert!(!player.is_playing());
    scene.camera.r = 7.0;
    player.start(&scene);
    let again = next(player.advance(FRAME, &scene, false));
    assert!(
        moved(&scene, &again) < 1e-9 && (player.time() - time).abs() < 0.1,
        "it goes on where it was left"
    );
    player.restart();
    assert_eq!(
        (
            player.time(),
            next(player.advance(FRAME, &scene, false)).camera.r.round()
        ),
        (0.0, 60.0)
    );
}

#[test]
fn a_journey_begins_anew_after_another_scene_was_loaded() {
    let (above, close) = (preset("above"), preset("close"));
    let mut player = player();
    assert_eq!(player.stage(), Some(&above), "its captions name the disk");
    assert!(player.begins_anew(&above));
    player.rewind(&above);
    player.start(&above);
    let mut scene = above.clone();
    for _ in 0..600 {
        scene = next(player.advance(FRAME, &scene, false));
    }
    player.stop();
    assert!(!player.begins_anew(&above), "J goes on where it was left");
    assert!(player.begins_anew(&close));
    player.rewind(&close);
    assert!(player.time() == 0.0 && !player.begins_anew(&close));
    let keyframes = "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 1";
    let plain = JourneyPlayer::new(journey::load("j.toml", keyframes).unwrap());
    assert_eq!(plain.stage(), None);
}

#[test]
fn a_calm_journey_does_not_roll() {
    let mut scene = preset("edge-on");
    let mut player = player();
    player.restart();
    let mut rolls = [0.0_f64; 2];
    for (roll, calm) in rolls.iter_mut().zip([false, true]) {
        player.restart();
        scene.camera.roll_deg = 0.0;
        for _ in 0..6000 {
            scene = next(player.advance(FRAME, &scene, calm));
            *roll = roll.max(scene.camera.roll_deg.abs());
        }
    }
    assert!(rolls[0] > 5.0 && rolls[1] == 0.0, "{rolls:?}");
}

#[test]
fn a_journey_shows_its_title_first_and_then_its_captions() {
    let mut scene = preset("edge-on");
    let mut player = player();
    assert_eq!(player.words(), None, "nothing is said before the start");
    player.restart();
    let (mut said, mut last) = (Vec::new(), String::new());
    loop {
        let words = player.words().map(|words| words.text.to_owned());
        let words = words.unwrap_or_default();
        if words != last && !words.is_empty() {
            said.push(words.clone());
        }
        last = words;
        match player.advance(0.25, &scene, false) {
            FlightStep::Moved(next) => scene = next.into_scene(),
            FlightStep::Ended(_) => break,
            other => panic!("{other:?}"),
        }
    }
    let journey = journey::load("default.toml", journey::DEFAULT).unwrap();
    let captions = journey.captions.iter().map(|caption| caption.text.clone());
    let all: Vec<String> = std::iter::once(journey.title.clone())
        .chain(captions)
        .collect();
    assert_eq!(said, all);
    assert_eq!(player.words(), None, "nothing is said after the end");
}

#[test]
fn a_paused_journey_stands_still_and_a_skip_moves_it_at_once() {
    let mut scene = preset("edge-on");
    let mut player = player();
    player.restart();
    for _ in 0..600 {
        scene = next(player.advance(FRAME, &scene, false));
    }
    let (time, before) = (player.time(), scene.clone());
    for _ in 0..60 {
        scene = next(player.advance(0.0, &scene, false));
    }
    assert_eq!((player.time(), &scene), (time, &before));
    player.skip(5.0);
    scene = next(player.advance(0.0, &scene, false));
    assert!((player.time() - time - 5.0).abs() < 1e-12 && scene.camera.r < before.camera.r);
    player.skip(-5.0);
    scene = next(player.advance(0.0, &scene, false));
    assert!(moved(&before, &scene) < 1e-9, "back where it was paused");
    player.skip(-1e6);
    assert_eq!(player.time(), 0.0);
    player.skip(1e6);
    assert!(matches!(
        player.advance(0.0, &scene, false),
        FlightStep::Ended(_)
    ));
    // A paused fall stands still, too.
    let mut scene = preset("falling");
    let mut free_fall = FreeFall::default();
    free_fall.start(&scene).unwrap();
    scene = next(free_fall.advance(FRAME, &scene));
    assert_eq!(next(free_fall.advance(0.0, &scene)), scene);
    let clocks = free_fall.clocks(&scene, Units::Hole);
    assert!(
        clocks.starts_with("Your clock 0.") && clocks.contains(" · far clock 0."),
        "{clocks}"
    );
}

#[test]
fn an_observer_let_go_in_free_fall_ends_inside_the_horizon() {
    let mut scene = preset("falling");
    let start = scene.camera.r;
    let mut free_fall = FreeFall::default();
    free_fall.start(&scene).unwrap();
    let mut frames = 0;
    loop {
        match free_fall.advance(FRAME, &scene) {
            FlightStep::Moved(after) => scene = after.into_scene(),
            FlightStep::Ended(after) => {
                scene = after.into_scene();
                break;
            }
            other => panic!("{other:?}"),
        }
        frames += 1;
        assert!(frames < 60 * 60, "{:?}", scene.camera);
        let own = (start.powf(1.5) - scene.camera.r.powf(1.5)) / 1.5;
        assert!((free_fall.worldline().unwrap().proper_time() - own).abs() < 1e-9);
    }
    assert!((scene.camera.r - 0.1).abs() < 1e-12 && frames > 300);
    // From here to the centre the rest of the way takes 2/3 r^(3/2).
    let clocks = free_fall.clocks(&scene, Units::Hole);
    assert!(
        clocks.starts_with("Inside the horizon") && clocks.ends_with("0.021 r_s/c to the centre"),
        "{clocks}"
    );
}

/// Through a spinning hole's horizon, dropped and thrown: the sky in the picture moves on as it
/// moved, though the azimuth that the scene notes becomes another there.
#[test]
fn through_a_spinning_holes_horizon_the_picture_goes_on() {
    for (spin, velocity) in [
        (0.9, [0.0; 3]),
        (-0.7, [-0.2, 0.1, 0.4]),
        (0.998, [0.0, 0.3, 0.0]),
    ] {
        let mut scene = preset("falling");
        let kerr = Kerr { spin };
        (
            scene.hole.spin,
            scene.camera.theta_deg,
            scene.observer.velocity,
        ) = (spin, 60.0, velocity);
        scene.camera.r = 1.5 * kerr.horizon();
        let mut free_fall = FreeFall::default();
        free_fall.start(&scene).unwrap();
        free_fall.change_pace(-2);
        // What is seen where the camera looks, away from the hole, and how far that moved in the
        // frame before.
        let looked = |scene: &Scene| {
            let forward = scene.camera.tetrad_from_camera().z_axis;
            Reference::new(scene)
                .unwrap()
                .trace(if forward.x > 0.0 { forward } else { -forward })
                .sky
        };
        let (mut last, mut step, mut inside) = (looked(&scene).unwrap(), None::<f64>, 0);
        for frame in 0.. {
            assert!(frame < 20_000, "{:?}", scene.camera);
            let flight = free_fall.advance(FRAME, &scene);
            let ended = matches!(flight, FlightStep::Ended(_));
            match flight {
                FlightStep::Moved(after) | FlightStep::Ended(after) => scene = after.into_scene(),
                other => panic!("spin {spin}: {other:?} at {:?}", scene.camera),
            }
            let seen = looked(&scene).unwrap();
            let moved = (seen - last).length();
            if !ended {
                assert!(
                    step.is_none_or(|step| moved < 1.5 * step + 1e-4),
                    "{moved} after {step:?} at {:?}",
                    scene.camera
                );
            }
            (last, step, inside) = (
                seen,
                Some(moved),
                inside + u32::from(scene.camera.r < kerr.horizon()),
            );
            if ended {
                break;
            }
        }
        assert_eq!(scene.camera.r, min_infall_radius(kerr));
        assert!(
            inside > 100
                && free_fall
                    .clocks(&scene, Units::Hole)
                    .contains("to the last picture"),
            "{inside} frames inside"
        );
    }
}

#[test]
fn free_motion_goes_on_while_looking_around_and_ends_when_the_camera_is_moved() {
    let mut scene = preset("edge-on");
    (scene.camera.theta_deg, scene.observer.kind) = (90.0, ObserverKind::Orbit);
    let mut free_fall = FreeFall::default();
    free_fall.start(&scene).unwrap();
    scene = next(free_fall.advance(1.0, &scene));
    assert!(
        free_fall
            .clocks(&scene, Units::Hole)
            .starts_with("In orbit")
    );
    scene.camera.yaw_deg = 33.0;
    let after = next(free_fall.advance(1.0, &scene));
    assert!(after.camera.yaw_deg == 33.0 && after.camera.phi_deg != scene.camera.phi_deg);
    // Twice the pace, twice the way.
    let way = after.camera.phi_deg - scene.camera.phi_deg;
    free_fall.change_pace(1);
    let faster = next(free_fall.advance(1.0, &after));
    assert!(((faster.camera.phi_deg - after.camera.phi_deg) / way - 2.0).abs() < 1e-9);
    let mut taken = faster.clone();
    taken.camera.r += 0.1;
    assert_eq!(free_fall.advance(1.0, &taken), FlightStep::Idle);
    assert!(!free_fall.is_moving());
}

#[test]
fn a_fall_that_cannot_be_drawn_farther_stops_at_its_last_picture_and_says_why() {
    let mut scene = preset("falling");
    (scene.hole.spin, scene.camera.theta_deg, scene.method) = (0.9, 60.0, Method::KerrSchild);
    let mut free_fall = FreeFall::default();
    free_fall.start(&scene).unwrap();
    for _ in 0..6000 {
        match free_fall.advance(FRAME, &scene) {
            FlightStep::Moved(after) => scene = after.into_scene(),
            FlightStep::Refused(reason) => {
                assert!(reason.contains("inside the horizon"), "{reason}");
                assert!(scene.camera.r > Kerr { spin: 0.9 }.horizon());
                return;
            }
            other => panic!("{other:?}"),
        }
    }
    panic!("it never came to the horizon");
}

#[test]
fn a_journey_ends_with_its_own_words() {
    let words = |text: &str| {
        let keyframes = "\n[[keyframe]]\ntime = 0\nr = 12\n[[keyframe]]\ntime = 9\nr = 10";
        let journey = journey::load("mine.toml", &format!("{text}{keyframes}")).unwrap();
        JourneyPlayer::new(journey).last_words().map(str::to_owned)
    };
    assert_eq!(
        words("title = \"Lesson 1\"\nending = \" Now draw the ring. \""),
        ["Lesson 1", "Now draw the ring."]
    );
    assert_eq!(words("title = \"Lesson 2\""), ["Lesson 2", ""]);
    assert_eq!(words(""), ["The journey ends here", ""]);
}

#[test]
fn a_flight_stands_still_while_the_machine_sleeps() {
    let night = 8.0 * 3600.0;
    let mut scene = preset("edge-on");
    let mut player = player();
    player.restart();
    for _ in 0..600 {
        scene = next(player.advance(FRAME, &scene, false));
    }
    assert_eq!(player.progress(), "9 of 132 s");
    let (time, before) = (player.time(), scene.clone());
    scene = next(player.advance(night, &scene, false));
    assert!(
        player.time() - time < 0.5 && moved(&before, &scene) < 0.1,
        "{} s",
        player.time() - time
    );

    let mut scene = preset("falling");
    let mut free_fall = FreeFall::default();
    free_fall.start(&scene).unwrap();
    scene = next(free_fall.advance(FRAME, &scene));
    let (own, r) = (free_fall.worldline().unwrap().proper_time(), scene.camera.r);
    scene = next(free_fall.advance(night, &scene));
    let slept = free_fall.worldline().unwrap().proper_time() - own;
    assert!(
        slept < 0.5 * free_fall.rate(r) && scene.camera.r > 0.9 * r,
        "{slept}"
    );
}

#[test]
fn a_journey_that_cannot_be_flown_to_its_end_is_reported_at_once_and_flown_as_far_as_possible() {
    let mut scene = preset("edge-on");
    (scene.hole.spin, scene.observer.kind) = (0.9, ObserverKind::Rain);
    // A last keyframe that is deeper inside than the innermost radius of this spin.
    let deep = journey::DEFAULT.replace("rain = { r = 0.5,", "rain = { r = 0.3,");
    let mut player = JourneyPlayer::new(journey::load("deep.toml", &deep).unwrap());
    player.start(&scene);
    let fault = player.check(&scene).unwrap_err();
    assert!(
        fault.place.starts_with("keyframe 11 ")
            && fault.reason.contains("camera.r = 0.3 is refused"),
        "{fault}"
    );
    let refused = loop {
        match player.advance(0.25, &scene, false) {
            FlightStep::Moved(next) => scene = next.into_scene(),
            other => break other,
        }
    };
    assert!(
        matches!(&refused, FlightStep::Refused(reason) if reason.contains("camera.r = 0.3")),
        "{refused:?}"
    );
    assert!(scene.camera.r < Kerr { spin: 0.9 }.horizon() && player.time() > 106.0);
    scene.hole.spin = 0.0;
    assert_eq!(player.check(&scene), Ok(()));
}
