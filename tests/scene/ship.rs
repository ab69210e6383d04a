//! The ship in its pilot's hands, frame by frame: what the keys order, how fast time passes, and how the
//! flight ends when something else moves the camera.

use glam::DVec3;
use lightfall::app::{
    Engine, FlightStep, HoldKind, News, ShipFlight, ShipFrame, Stick, instruments, own_time_rate,
};
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::optics::readout::si::MASSES;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Apsides, Heading, Hold, HoldRefusal, Mount, Rocket, board};
use lightfall_core::scene::mission::Look;
use lightfall_core::scene::{ObserverKind, Scene, presets};

const FRAME: f64 = 1.0 / 60.0;

/// A smooth disk, whose clock does not run, seen from the equator at this radius.
fn scene_at(r: f64, kind: ObserverKind) -> Scene {
    let mut scene = presets::find("above").unwrap().scene(&[]).unwrap();
    scene.disk.structure = Default::default();
    (scene.camera.r, scene.camera.theta_deg) = (r, 90.0);
    scene.observer.kind = kind;
    scene
}

fn aboard(scene: &Scene) -> ShipFlight {
    let mut ship = ShipFlight::default();
    ship.board(scene, MASSES[0]).unwrap();
    ship
}

/// A frame of this length with the hand so.
fn frame(seconds: f64, stick: Stick) -> ShipFrame {
    ShipFrame {
        seconds,
        turn_seconds: seconds,
        stick,
        reduced_motion: false,
    }
}

fn push(thrust: DVec3) -> Stick {
    Stick {
        thrust,
        ..Stick::NEUTRAL
    }
}

/// Lets a frame pass that goes on, and returns what happened in it.
#[track_caller]
fn pass(ship: &mut ShipFlight, scene: &mut Scene, frame: &ShipFrame) -> Option<News> {
    let (step, news) = ship.advance(frame, scene);
    match step {
        FlightStep::Moved(next) => *scene = next.into_scene(),
        other => panic!("{other:?}"),
    }
    news
}

fn coast(ship: &mut ShipFlight, scene: &mut Scene, frames: u32) {
    for _ in 0..frames {
        pass(ship, scene, &frame(FRAME, Stick::NEUTRAL));
    }
}

/// The angle between the nose and a heading's direction.
fn off(ship: &ShipFlight) -> f64 {
    let heading = ship.heading().unwrap();
    let direction = heading.direction(&ship.voyage().unwrap().flight.ship);
    direction.unwrap().angle_between(DVec3::X)
}

#[test]
fn a_ship_pushes_along_its_nose_as_far_as_its_thrust_is_set() {
    let mut scene = scene_at(20.0, ObserverKind::Static);
    let mut ship = aboard(&scene);
    // The camera of the preset faces the hole.
    let mut thrust_of = |gear, notches| {
        ship.change_thrust(notches);
        let stick = Stick {
            gear,
            ..push(DVec3::X)
        };
        pass(&mut ship, &mut scene, &frame(FRAME, stick));
        ship.voyage().unwrap().flight.acceleration()
    };
    assert_eq!(thrust_of(1.0, 0.0), DVec3::X);
    assert_eq!(thrust_of(0.25, 0.0), DVec3::new(0.25, 0.0, 0.0));
    assert_eq!(thrust_of(4.0, 1.0), DVec3::X, "no more than the engine's");
    let lower = thrust_of(1.0, -10.0).x;
    assert!((lower / 1.15_f64.powi(-10) - 1.0).abs() < 1e-12);
    assert!((thrust_of(4.0, 0.0).x / lower - 4.0).abs() < 1e-12);
    coast(&mut ship, &mut scene, 1);
    let flight = ship.voyage().unwrap().flight;
    assert_eq!(flight.acceleration(), DVec3::ZERO);
    assert!(flight.rocket.used() > 0.0 && flight.ship.constants().radial < 0.0);
}

#[test]
fn while_the_hand_pushes_a_full_tank_lasts_thirty_seconds_at_full_thrust_wherever_the_ship_is() {
    for r in [1.1, 10.0, 500.0] {
        let rocket = Rocket::new(0.1, 0.02, 0.1).unwrap();
        let by_hand = own_time_rate(r, 1.0, Engine::Hand, &rocket);
        // Near the hole the usual pace is slower.
        let usual = own_time_rate(r, 1.0, Engine::Off, &rocket);
        assert!(by_hand <= usual && by_hand * 30.0 <= 5.0 + 1e-12, "{r}");
        assert!(by_hand == usual || by_hand == 5.0 / 30.0, "{r}");
        assert_eq!(own_time_rate(r, 0.5, Engine::Hand, &rocket), 0.5 * by_hand);
        let fastest = own_time_rate(r, 1e9, Engine::Hold, &rocket);
        assert!((fastest / usual - 16.0).abs() < 1e-12);
    }
}

#[test]
fn something_else_that_moves_the_camera_leaves_the_ship_and_turning_the_camera_does_not() {
    let start = scene_at(10.0, ObserverKind::Orbit);
    let mut ship = aboard(&start);
    let mut scene = start.clone();
    coast(&mut ship, &mut scene, 1);
    scene.camera.yaw_deg += 20.0;
    coast(&mut ship, &mut scene, 1);
    assert!(ship.is_flown());
    scene.camera.r += 1e-9;
    let (step, _) = ship.advance(&frame(FRAME, Stick::NEUTRAL), &scene);
    assert!(step == FlightStep::Idle && !ship.is_flown());
}

#[test]
fn a_ship_that_stands_still_in_time_is_turned_by_hand_and_moves_nowhere() {
    let start = scene_at(10.0, ObserverKind::Orbit);
    let mut ship = aboard(&start);
    let mut scene = start;
    coast(&mut ship, &mut scene, 1);
    let [before, own] = [
        scene.camera.r,
        ship.voyage().unwrap().flight.ship.proper_time(),
    ];
    let look = scene.camera.tetrad_from_camera().z_axis;
    // To the right: about the downward axis.
    let turn = Stick {
        turn: DVec3::new(0.0, 0.0, -0.3),
        ..push(DVec3::X)
    };
    pass(&mut ship, &mut scene, &frame(0.0, turn));
    let turned = scene.camera.tetrad_from_camera().z_axis;
    assert!((look.angle_between(turned) - 0.3).abs() < 1e-12);
    let flight = ship.voyage().unwrap().flight;
    assert_eq!([scene.camera.r, flight.ship.proper_time()], [before, own]);
    assert!((flight.turned() - 0.3).abs() < 1e-12 && flight.rocket.used() == 0.0);
}

#[test]
fn the_nose_turns_to_each_heading_follows_it_and_is_left_to_the_gyroscopes_again() {
    let mut scene = scene_at(6.0, ObserverKind::Orbit);
    let mut ship = aboard(&scene);
    let headings = [
        Heading::Hole,
        Heading::Prograde,
        Heading::Retrograde,
        Heading::Outward,
    ];
    for expected in headings.map(Some).into_iter().chain([None]) {
        let heading = ship.face_next().unwrap();
        // The last one is the star that was outward when the key was pressed.
        match expected {
            Some(expected) => assert_eq!(heading, expected),
            None => assert!(matches!(heading, Heading::Star(_)), "{heading:?}"),
        }
        coast(&mut ship, &mut scene, 180);
        assert!(off(&ship) < 2e-3, "{heading:?}: {}", off(&ship));
        // Level: up is along decreasing theta.
        let up = scene.camera.tetrad_from_camera().y_axis;
        assert!(up.angle_between(DVec3::NEG_Y) < 0.02, "{heading:?}: {up}");
    }
    assert_eq!(ship.face_next(), None);
    let turned = ship.voyage().unwrap().flight.turned();
    coast(&mut ship, &mut scene, 10);
    assert_eq!(ship.voyage().unwrap().flight.turned(), turned);
    // A hand ends a turn.
    ship.face_next();
    let hand = Stick {
        turn: DVec3::new(0.1, 0.0, 0.0),
        ..Stick::NEUTRAL
    };
    pass(&mut ship, &mut scene, &frame(FRAME, hand));
    assert_eq!(ship.heading(), None);
    // With reduced motion it takes no time.
    assert!(ship.face_next().is_some());
    let at_once = ShipFrame {
        reduced_motion: true,
        ..frame(FRAME, Stick::NEUTRAL)
    };
    pass(&mut ship, &mut scene, &at_once);
    // In a frame the motion turns by a hundredth at most.
    assert!(off(&ship) < 0.01);
}

#[test]
fn the_nose_goes_back_through_the_row_of_headings_that_it_went_forward() {
    let mut scene = scene_at(6.0, ObserverKind::Orbit);
    let mut ship = aboard(&scene);
    let row = [
        Some(Heading::Hole),
        Some(Heading::Prograde),
        Some(Heading::Retrograde),
        Some(Heading::Outward),
    ];
    for expected in row {
        assert_eq!(ship.face_next(), expected);
    }
    coast(&mut ship, &mut scene, 180);
    for expected in row.into_iter().rev().skip(1) {
        assert_eq!(ship.face_back(), expected);
    }
    // Before the first one the gyroscopes hold the nose, and before them is the star ahead.
    assert_eq!(ship.face_back(), None);
    assert_eq!(ship.heading(), None);
    assert!(matches!(ship.face_back(), Some(Heading::Star(_))));
    assert_eq!(ship.face_back(), Some(Heading::Outward));
    // A nose that points to the hole has no star ahead.
    let mut ship = aboard(&scene_at(6.0, ObserverKind::Orbit));
    assert_eq!(ship.face_back(), Some(Heading::Outward));
}

/// The direction of a heading on the camera's axes right, up, forward, by the scene alone: the camera's
/// own axes as a ship's nose, left and up.
fn seen(heading: Heading, scene: &Scene) -> DVec3 {
    let camera = board(scene, &Mount::NOSE).unwrap();
    Mount::NOSE.0.transpose() * heading.direction(&camera).unwrap()
}

#[test]
fn a_pilot_who_looks_at_the_hole_sees_it_level_in_the_middle_while_the_ship_flies_as_without_the_look()
 {
    for heading in [Heading::Prograde, Heading::Retrograde, Heading::Outward] {
        let ends = [false, true].map(|looks| {
            let mut scene = scene_at(8.0, ObserverKind::Orbit);
            let mut ship = aboard(&scene);
            while ship.face_next() != Some(heading) {}
            coast(&mut ship, &mut scene, 180);
            if looks {
                assert_eq!(ship.switch_look(), Look::Hole);
            }
            // Longer than the head needs to turn, and with thrust along the nose.
            for _ in 0..60 {
                pass(&mut ship, &mut scene, &frame(FRAME, push(0.1 * DVec3::X)));
            }
            (ship, scene)
        });
        let [(plain, _), (ship, scene)] = &ends;
        assert_eq!(
            plain.voyage().unwrap().flight.ship,
            ship.voyage().unwrap().flight.ship
        );
        let hole = seen(Heading::Hole, scene);
        assert!(hole.distance(DVec3::Z) < 1e-9, "{heading:?}: {hole}");
        let up = scene.camera.tetrad_from_camera().y_axis;
        assert!(up.distance(DVec3::NEG_Y) < 1e-9, "{heading:?}: {up}");
        // The marks are drawn by the mount: they are where the picture has their directions.
        let flown = &ship.voyage().unwrap().flight.ship;
        let marked = ship.mount().0.transpose() * heading.direction(flown).unwrap();
        let off = marked.distance(seen(heading, scene));
        assert!(off < 1e-9, "{heading:?}: {off}");
    }
}

#[test]
fn the_head_turns_back_to_the_nose_and_leaving_the_ship_keeps_the_picture_that_is_seen() {
    let start = scene_at(8.0, ObserverKind::Orbit);
    let mut ship = aboard(&start);
    let mut scene = start.clone();
    ship.face_next();
    ship.face_next();
    coast(&mut ship, &mut scene, 180);
    let ahead = scene.camera.angles();
    let still = frame(0.0, Stick::NEUTRAL);
    let turning = ShipFrame {
        turn_seconds: 1.0,
        ..still
    };
    ship.switch_look();
    for _ in 0..4 {
        pass(&mut ship, &mut scene, &turning);
    }
    let at_hole = scene.camera.angles();
    assert_ne!(at_hole, ahead);
    // A scene that becomes a ship becomes the same scene again, whatever was looked at.
    let mut again = scene.clone();
    let mut boarded = aboard(&again);
    assert_eq!(boarded.look(), Look::Nose);
    pass(&mut boarded, &mut again, &still);
    let rounding = 1e-9;
    for (one, other) in at_hole.into_iter().zip(again.camera.angles()) {
        assert!((one - other).abs() < rounding, "{one} and {other} degrees");
    }
    assert_eq!(ship.switch_look(), Look::Nose);
    for _ in 0..4 {
        pass(&mut ship, &mut scene, &turning);
    }
    for (one, other) in ahead.into_iter().zip(scene.camera.angles()) {
        assert!((one - other).abs() < rounding, "{one} and {other} degrees");
    }
}

#[test]
fn holds_keep_an_orbit_or_the_place_until_the_hand_pushes() {
    let mut scene = scene_at(6.0, ObserverKind::Static);
    let mut ship = aboard(&scene);
    assert_eq!(ship.switch_hold(HoldKind::Still), Ok(true));
    coast(&mut ship, &mut scene, 120);
    assert!((scene.camera.r - 6.0).abs() < 1e-6, "{}", scene.camera.r);
    assert_eq!(ship.switch_hold(HoldKind::Orbit), Ok(true));
    ship.change_pace(4);
    coast(&mut ship, &mut scene, 120);
    let apsides = Apsides::of(&ship.voyage().unwrap().flight.ship);
    let [low, high] = [apsides.periapsis, apsides.apoapsis].map(Option::unwrap);
    // A hold comes nearer by one part in e in 0.16 radians of the motion, of which there were many.
    assert!(low > 5.99 && high < 6.01, "{low} to {high}");
    pass(&mut ship, &mut scene, &frame(FRAME, push(DVec3::Y)));
    assert_eq!((ship.hold(), ship.pace()), (None, 1.0));
}

#[test]
fn a_hold_that_is_not_possible_is_refused_and_one_that_becomes_so_ends() {
    let mut scene = scene_at(1.3, ObserverKind::Rain);
    let mut ship = aboard(&scene);
    let refused = ship.switch_hold(HoldKind::Orbit);
    assert_eq!(refused, Err(HoldRefusal::NoOrbit { r: 1.3 }));
    assert_eq!(ship.switch_hold(HoldKind::Still), Ok(true));
    assert_eq!(ship.hold(), Some(Hold::Hover(1.3)));
    // It falls too fast for its engine.
    let news = (0..600).find_map(|_| pass(&mut ship, &mut scene, &frame(FRAME, Stick::NEUTRAL)));
    assert!(
        matches!(
            news,
            Some(News::Refused(
                HoldRefusal::Ergosphere { .. } | HoldRefusal::Inside { .. }
            ))
        ),
        "{news:?}"
    );
    assert_eq!(ship.hold(), None);
}

#[test]
fn faster_time_ends_by_itself_at_the_lowest_point_and_slower_frames_lead_to_the_same_place() {
    let ends = [FRAME, 0.1].map(|seconds| {
        let mut scene = scene_at(10.0, ObserverKind::Orbit);
        let mut ship = aboard(&scene);
        // Brake: growing phi is to the left of a camera that faces the hole.
        let brake = scene.camera.tetrad_from_camera().transpose() * DVec3::NEG_Z;
        for _ in 0..(4.0 / seconds).round() as u32 {
            pass(
                &mut ship,
                &mut scene,
                &frame(seconds, push(DVec3::new(brake.z, -brake.x, brake.y) * 0.1)),
            );
        }
        let low = Apsides::of(&ship.voyage().unwrap().flight.ship)
            .periapsis
            .unwrap();
        pass(&mut ship, &mut scene, &frame(0.0, Stick::NEUTRAL));
        ship.change_pace(4);
        assert_eq!(ship.pace(), 16.0);
        let mut frames = 0;
        let stop = loop {
            frames += 1;
            assert!(frames < 10_000, "no stop");
            let news = pass(&mut ship, &mut scene, &frame(seconds, Stick::NEUTRAL));
            if let Some(news) = news {
                break news;
            }
        };
        assert!(matches!(stop, News::Slowed(_)), "{stop:?}");
        assert_eq!(ship.pace(), 1.0);
        assert!(
            (scene.camera.r - low).abs() < 1e-6,
            "{} and {low}",
            scene.camera.r
        );
        low
    });
    assert!(
        ends[0] < 9.0 && (ends[0] - ends[1]).abs() < 1e-9,
        "{ends:?}"
    );
}

/// 1200 frames at 16 times the usual pace are more than three turns of this orbit.
#[test]
fn faster_time_that_is_asked_for_again_at_a_turning_point_passes_the_next_ones() {
    let mut scene = scene_at(10.0, ObserverKind::Orbit);
    scene.observer.velocity = [0.0, 0.0, -0.05];
    let mut ship = aboard(&scene);
    let stops = |ship: &mut ShipFlight, scene: &mut Scene| {
        let coast = frame(FRAME, Stick::NEUTRAL);
        let news = (0..1200).filter_map(|_| pass(ship, scene, &coast));
        news.filter(|news| matches!(news, News::Slowed(_))).count()
    };
    ship.change_pace(4);
    assert_eq!(stops(&mut ship, &mut scene), 1);
    assert_eq!(ship.pace(), 1.0);
    ship.change_pace(4);
    assert_eq!(stops(&mut ship, &mut scene), 0);
    assert_eq!(ship.pace(), 16.0);
    // Slower time ends that.
    ship.change_pace(-1);
    ship.change_pace(1);
    assert_eq!(stops(&mut ship, &mut scene), 1);
}

#[test]
fn a_ship_falls_through_the_horizon_to_the_end_of_its_flight() {
    for spin in [0.0, 0.9] {
        let mut scene = scene_at(3.0, ObserverKind::Rain);
        scene.hole.spin = spin;
        let mut ship = aboard(&scene);
        let end = (0..6000).find_map(|_| {
            let (step, _) = ship.advance(&frame(FRAME, Stick::NEUTRAL), &scene);
            match step {
                FlightStep::Moved(next) => {
                    scene = next.into_scene();
                    None
                }
                FlightStep::Ended(end) => Some(end.into_scene()),
                other => panic!("{other:?}"),
            }
        });
        let end = end.expect("the fall ends").camera.r;
        let limit = min_infall_radius(scene.kerr());
        assert!((end / limit - 1.0).abs() < 1e-9, "{spin}: {end}, {limit}");
    }
}

/// The value of an instrument.
fn value(ship: &ShipFlight, label: &str) -> Option<String> {
    let all = instruments(ship, MASSES[1], Units::Hole);
    let found = all.into_iter().find(|instrument| instrument.label == label);
    found.map(|instrument| instrument.value)
}

/// The values are those of docs/FLIGHT.md and of closed forms: at rest at 2 r_s the thrust is sqrt(2)/8,
/// one c^2/r_s at M87* is 477 g, and the longest life from the horizon is pi/2.
#[test]
fn the_instruments_show_what_closed_forms_give() {
    let mut scene = scene_at(2.0, ObserverKind::Static);
    let mut ship = aboard(&scene);
    ship.switch_hold(HoldKind::Still).unwrap();
    coast(&mut ship, &mut scene, 60);
    let shown = |label| value(&ship, label).unwrap();
    assert_eq!(shown("radius, speed"), "2.000 r_s · 0.000 c");
    assert_eq!(shown("thrust"), "0.177 c²/r_s · 84.4 g");
    assert_eq!(shown("to stand still"), "0.177 c²/r_s · 84.4 g");
    assert_eq!(shown("held"), "still at 2.000 r_s");
    assert_eq!(shown("lowest point"), "in the hole");
    // At rest under constant thrust nothing changes, to the last digit. The panel shows the error.
    let error = |ship: &ShipFlight| ship.voyage().unwrap().flight.ship.error().stated();
    assert_eq!(error(&ship), 0.0);
    assert_eq!(value(&ship, "error of the flight"), None);
    let mut scene = scene_at(10.0, ObserverKind::Orbit);
    scene.observer.velocity = [0.0, 0.0, -0.05];
    let mut ship = aboard(&scene);
    coast(&mut ship, &mut scene, 1);
    let low = Apsides::of(&ship.voyage().unwrap().flight.ship)
        .periapsis
        .unwrap();
    let shown = value(&ship, "lowest point").unwrap();
    assert!(shown.starts_with(&format!("{low:.3} r_s, in ")), "{shown}");
    assert_eq!(value(&ship, "thrust").unwrap(), "off");
    let error = error(&ship);
    assert!(error > 0.0 && error < 1e-13, "{error}");
    let mut scene = scene_at(1.0, ObserverKind::Rain);
    let mut ship = aboard(&scene);
    pass(&mut ship, &mut scene, &frame(0.0, Stick::NEUTRAL));
    assert_eq!(value(&ship, "life left").unwrap(), "at most 1.571 r_s/c");
    assert_eq!(
        value(&ship, "to stand still").unwrap(),
        "nothing holds a ship here"
    );
    assert!(
        value(&ship, "signal home")
            .unwrap()
            .starts_with("reaches nobody")
    );
}

/// Beyond 100 r_s a ship that comes away is at r exp(0.5) after each second, in frames of any length.
#[test]
fn far_from_the_hole_the_distance_grows_by_no_more_than_half_in_a_second_whatever_the_frames() {
    for frames in [30_u32, 60, 144] {
        let mut scene = scene_at(150.0, ObserverKind::Static);
        scene.observer.velocity = [0.5, 0.0, 0.0];
        let mut ship = aboard(&scene);
        ship.change_pace(6);
        let one = frame(1.0 / f64::from(frames), Stick::NEUTRAL);
        let news = pass(&mut ship, &mut scene, &one);
        assert_eq!(news, Some(News::Far), "{frames}");
        for _ in 1..2 * frames {
            assert_eq!(pass(&mut ship, &mut scene, &one), None);
        }
        let expected = 150.0 * 1.0_f64.exp();
        let r = scene.camera.r;
        assert!(
            (r / expected - 1.0).abs() < 1e-9,
            "{frames}: {r}, {expected}"
        );
        // A key that asks for more changes nothing, and one for less does.
        ship.change_pace(1);
        assert_eq!(ship.pace(), 64.0);
        ship.change_pace(-1);
        assert_eq!(ship.pace(), 32.0);
    }
}

#[test]
fn a_ship_that_is_bound_or_near_runs_as_fast_as_its_pace_says() {
    for (r, velocity) in [(150.0, 0.0), (20.0, 0.5)] {
        let mut scene = scene_at(r, ObserverKind::Static);
        scene.observer.velocity = [velocity, 0.0, 0.0];
        let mut ship = aboard(&scene);
        assert_eq!(
            pass(&mut ship, &mut scene, &frame(FRAME, Stick::NEUTRAL)),
            None
        );
        assert!(!ship.is_far());
        let usual = 0.1 * scene.camera.r.powf(1.5);
        assert!((ship.rate() / usual - 1.0).abs() < 1e-9);
    }
}

#[test]
fn less_than_a_fifth_of_the_tank_is_said_once_an_empty_tank_after_it_and_then_each_push_in_vain() {
    let mut scene = scene_at(100.0, ObserverKind::Static);
    let mut ship = aboard(&scene);
    let mut said = Vec::new();
    for _ in 0..20_000 {
        // Across the way to the hole.
        said.extend(pass(&mut ship, &mut scene, &frame(0.1, push(DVec3::Y))));
        if said.contains(&News::Empty) {
            break;
        }
    }
    said.retain(|news| [News::LittleFuel, News::Empty].contains(news));
    assert_eq!(said, [News::LittleFuel, News::Empty]);
    // The key is still held: a push in vain is one that begins.
    let mut said_by = |stick| pass(&mut ship, &mut scene, &frame(0.1, stick));
    let held = said_by(push(DVec3::Y));
    assert_ne!(held, Some(News::NoPush));
    assert_ne!(said_by(Stick::NEUTRAL), Some(News::NoPush));
    assert_eq!(said_by(push(DVec3::Y)), Some(News::NoPush));
    assert_ne!(said_by(push(DVec3::Y)), Some(News::NoPush));
}

/// The points lie on the circle that is flown; going back forgets what came after.
#[test]
fn the_track_holds_the_path_in_a_bounded_number_of_points_and_forgets_what_is_undone() {
    let mut scene = scene_at(6.0, ObserverKind::Orbit);
    let mut ship = aboard(&scene);
    ship.change_pace(10);
    coast(&mut ship, &mut scene, 600);
    let places: Vec<DVec3> = ship.track().unwrap().places().collect();
    assert!((64..=1024).contains(&places.len()), "{}", places.len());
    let is_on_circle = |place: &DVec3| (place.length() - 6.0).abs() < 1e-6;
    assert!(places.iter().all(is_on_circle));
    ship.begin_again();
    assert_eq!(ship.track().unwrap().places().count(), 1);
}
