//! Where a ship sees a star, against the reference tracer, and a nose that stays on one.

use crate::random::Random;
use crate::timelike::scene;
use glam::{DMat3, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::sphere::angle_between;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::ship::{
    Flight, Heading, Mount, Orders, Rocket, board, star_ahead, turn_to,
};
use lightfall_core::scene::{ObserverKind, Scene};

/// The star that a scene's camera sees in the middle of its picture.
fn in_the_middle(scene: &Scene) -> Option<DVec3> {
    let forward = scene.camera.tetrad_from_camera().z_axis;
    Reference::new(scene).unwrap().trace(forward).sky
}

/// A scene of a random spin whose observer moves somewhere on either side of the horizon, and looks
/// somewhere.
fn random_scene(random: &mut Random) -> Scene {
    let spin = random.of(&[0.0, 0.9, -0.7]);
    let r = Kerr { spin }.horizon() * random.log_between(0.8, 20.0);
    let velocity = random.between(0.0, 0.8) * random.direction();
    let theta_deg = random.between(5.0, 175.0);
    let mut scene = scene(spin, ObserverKind::Rain, velocity.to_array(), r, theta_deg);
    scene.camera.set_orientation(DMat3::IDENTITY);
    scene.camera.yaw_deg = random.between(-180.0, 180.0);
    scene.camera.pitch_deg = random.between(-80.0, 80.0);
    scene
}

/// The nose looks at the star that the middle of the picture shows, and the heading of this star is the
/// nose: from another nose, too, where the image is the primary one. Differences leave about 1e-10.
#[test]
fn random_ships_see_stars_where_the_reference_tracer_does() {
    let mut random = Random::new();
    let (mut seen, mut again) = (0, 0);
    for _ in 0..200 {
        let scene = random_scene(&mut random);
        let ship = board(&scene, &Mount::NOSE).unwrap();
        let expected = in_the_middle(&scene);
        let star = star_ahead(&ship);
        assert_eq!(star.is_some(), expected.is_some());
        let (Some(star), Some(expected)) = (star, expected) else {
            continue;
        };
        assert!(angle_between(star, expected) < 1e-9, "{star} {expected}");
        seen += 1;
        let mut turned = ship;
        let rotation = turn_to(DVec3::X, random.direction());
        turned.turn(rotation);
        let Some(direction) = Heading::Star(star).direction(&turned) else {
            continue;
        };
        // On the axes of the ship that was not turned.
        let off = angle_between(rotation * direction, DVec3::X);
        // An image of a higher order is not the primary one.
        again += u32::from(off < 1e-8);
    }
    assert!(seen > 100, "{seen}");
    assert!(again > seen * 9 / 10, "{again} of {seen}");
}

/// In orbit the gyroscopes' direction drifts away from a star, and the autopilot keeps the nose on it. The
/// middle of the picture shows the star to within the turn of a tick, except while it is nearly behind the
/// hole.
#[test]
fn a_nose_that_faces_a_star_stays_on_it_for_a_turn() {
    for spin in [0.0, 0.9] {
        let start = scene(spin, ObserverKind::Orbit, [0.0; 3], 6.0, 90.0);
        let mut ship = board(&start, &Mount::NOSE).unwrap();
        // A little above the plane of the orbit.
        let star = DVec3::new(0.3, 0.8, 0.4).normalize();
        let first = Heading::Star(star).direction(&ship).unwrap();
        ship.turn(turn_to(DVec3::X, first));
        let mut flight = Flight::new(ship, Rocket::new(0.0, 0.0, 1.0).unwrap());
        flight.order(Orders {
            face: Some(Heading::Star(star)),
            ..Orders::COAST
        });
        let mut worst = 0.0_f64;
        for _ in 0..300 {
            assert_eq!(flight.advance(0.4), Ok(None));
            let ahead = star_ahead(&flight.ship).expect("the nose never points into the hole");
            worst = worst.max(angle_between(ahead, star));
        }
        // Far longer than a tick, a star passes behind the hole, and its image to the other side.
        assert!(worst < 0.1, "spin {spin}: {worst}");
    }
}
