//! Ships that start as a scene's observer and are written back, and the clocks of their flights.

use crate::random::Random;
use crate::ship_flights::controls;
use crate::timelike::scene;
use glam::{DVec3, Vec4Swizzles};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::{Photon, min_infall_radius};
use lightfall_core::geometry::ship::{Controls, Ship, boost, components, zamo_axes};
use lightfall_core::geometry::sphere::wrap_degrees;
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::optics::ship::{
    Clocks, HOME_RADIUS, Heading, Mount, board, disk_clock, write_scene,
};
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::{ObserverKind, Scene};

/// Some observer: any kind that exists at its place, on the axis, at the horizon and inside.
fn random_scene(random: &mut Random) -> Scene {
    let spin = random.of(&[-0.9, 0.0, 0.0, 0.5, 0.998]);
    let kerr = Kerr { spin };
    let kind = random.of(&[
        ObserverKind::Static,
        ObserverKind::Zamo,
        ObserverKind::Orbit,
        ObserverKind::Rain,
        ObserverKind::Rain,
    ]);
    let theta_deg = match (kind, random.integer(1, 4)) {
        (ObserverKind::Orbit, _) => 90.0,
        (_, 1) => random.of(&[0.0, 180.0]),
        _ => random.between(0.0, 180.0),
    };
    let limit = kind
        .properties()
        .limit
        .radius(kerr, theta_deg.to_radians().cos());
    let r = match (kind, random.integer(1, 3)) {
        (ObserverKind::Rain, 1) => random.between(min_infall_radius(kerr), kerr.horizon()),
        (ObserverKind::Rain, 2) => kerr.horizon(),
        _ => random.log_between(1.02 * limit.max(kerr.horizon()), 100.0),
    };
    let velocity = random.between(0.0, 0.9) * random.direction();
    let mut scene = scene(spin, kind, velocity.to_array(), r, theta_deg);
    let camera = &mut scene.camera;
    camera.phi_deg = random.between(-180.0, 180.0);
    camera.yaw_deg = random.between(-180.0, 180.0);
    camera.pitch_deg = random.between(-90.0, 90.0);
    camera.roll_deg = random.between(-180.0, 180.0);
    if spin == 0.0 {
        scene.disk.tilt_deg = random.between(0.0, 180.0);
        scene.disk.node_deg = random.between(-180.0, 180.0);
    }
    scene
}

/// The photons that arrive along the camera's axes and their opposites, in the disk's frame.
fn photons(scene: &Scene) -> Vec<Photon> {
    let rays = CameraRays::in_disk_frame(scene).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    let along = |axis: DVec3| rays.photon(axes * axis);
    DVec3::AXES
        .into_iter()
        .flat_map(|axis| [along(axis), along(-axis)])
        .collect()
}

/// A photon's numbers, of the order of its frequency on the camera.
fn numbers(photon: &Photon) -> [f64; 5] {
    let Photon { energy, radial, w } = *photon;
    [energy, radial, w.x, w.y, w.z]
}

/// The tolerances are rounding: of degrees, which are 1e-16 of 180, and of the photons, which grow
/// with gamma of the observer relative to rain.
#[test]
fn a_random_scene_that_becomes_a_ship_and_a_scene_again_shows_the_same_picture() {
    let mut random = Random::new();
    let [mut worst, mut worst_field] = [0.0_f64; 2];
    for case in 0..2000 {
        let before = random_scene(&mut random);
        let shown = || {
            let Scene {
                camera, observer, ..
            } = &before;
            format!(
                "case {case}: {camera:?} {observer:?} spin {}",
                before.hole.spin
            )
        };
        let mount = if random.one_in(2) {
            Mount::NOSE
        } else {
            Mount(before.camera.tetrad_from_camera())
        };
        let ship = board(&before, &mount).unwrap();
        // v - t grows as the logarithm of the distance from the horizon, and its rounding as the
        // inverse.
        let place = ship.place();
        let slope = place.rho2() / place.kerr.delta(place.r).abs().max(1e-6);
        let rounding = 1e-15 * (10.0 + place.r * (1.0 + slope));
        assert!(disk_clock(&ship).abs() < rounding, "{}", shown());
        let mut after = before.clone();
        write_scene(&ship, &mount, &mut after).unwrap();
        assert_eq!(after.check(), Ok(()), "{}", shown());
        let (old, new) = (&before.camera, &after.camera);
        let place = (new.r / old.r - 1.0)
            .abs()
            .max((new.theta_deg - old.theta_deg).to_radians().abs())
            .max(
                wrap_degrees(new.phi_deg - old.phi_deg).to_radians().abs()
                    * ship.place().sin_theta(),
            );
        assert!(place < 1e-13, "{}: {place:e}", shown());
        let most = |photon: &Photon| {
            numbers(photon)
                .into_iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()))
        };
        let (old_photons, new_photons) = (photons(&before), photons(&after));
        let scale = old_photons.iter().map(most).fold(1.0, f64::max);
        for (old, new) in old_photons.iter().zip(&new_photons) {
            for (old, new) in numbers(old).into_iter().zip(numbers(new)) {
                let error = (old - new).abs() / (scale * scale);
                worst = worst.max(error);
                assert!(error < 1e-12, "{}: {error:e}", shown());
            }
        }
        if before.observer.kind == ObserverKind::Rain {
            for (old, new) in before.observer.velocity.iter().zip(after.observer.velocity) {
                worst_field = worst_field.max((old - new).abs());
            }
        }
    }
    eprintln!("photons {worst:.1e}, velocities {worst_field:.1e}");
    assert!(worst_field < 1e-14, "{worst_field:e}");
}

/// The place and the motion are those of a fall, which other tests compare with closed forms.
#[test]
fn a_ship_that_coasts_is_the_scenes_observer_let_go() {
    for (spin, kind, velocity, r, theta_deg, time) in [
        (0.9, ObserverKind::Static, [0.1, 0.2, 0.3], 6.0, 70.0, 30.0),
        (0.998, ObserverKind::Zamo, [0.0, 0.0, 0.6], 2.0, 90.0, 20.0),
        (-0.5, ObserverKind::Rain, [0.3, 0.1, 0.0], 3.0, 20.0, 3.0),
        (0.0, ObserverKind::Static, [0.0; 3], 4.0, 0.0, 5.0),
    ] {
        let start = scene(spin, kind, velocity, r, theta_deg);
        let (mut fallen, mut flown) = (start.clone(), start.clone());
        let mut line = Worldline::start(&start).unwrap();
        let zero = line.clock();
        line.advance(time, &mut fallen);
        let mut ship = board(&start, &Mount::NOSE).unwrap();
        ship.advance(&Controls::default(), time).unwrap();
        write_scene(&ship, &Mount::NOSE, &mut flown).unwrap();
        let (one, other) = (&fallen.camera, &flown.camera);
        assert!((one.r - other.r).abs() < 1e-12 * one.r, "spin {spin}");
        assert!((one.direction() - other.direction()).length() < 1e-12);
        for (one, other) in fallen.observer.velocity.iter().zip(flown.observer.velocity) {
            assert!((one - other).abs() < 1e-11, "{one} {other}");
        }
        // Both clocks are sums of the same series.
        assert!((line.clock() - zero - disk_clock(&ship)).abs() < 1e-11);
        assert_eq!(
            line.coordinate_time().is_some(),
            Clocks::new(&ship).far.is_some()
        );
        if let (Some(one), Some(other)) = (line.coordinate_time(), Clocks::new(&ship).far) {
            assert!((one - other).abs() < 1e-11, "{one} {other}");
        }
    }
}

/// Frequencies are rates of clocks. Without spin, and on the axis, light between ship and home moves
/// along the rays that join them, so the shift is the derivative of one clock's time by the other's.
/// A central difference over 2e-4 has an error of about 1e-9.
#[test]
fn the_light_between_ship_and_home_is_shifted_as_their_clocks_say() {
    for (spin, r, theta_deg) in [
        (0.0, 5.0, 60.0),
        (0.9, 3.0, 0.0),
        (0.0, 0.7, 90.0),
        (0.0, 1500.0, 90.0),
    ] {
        let start = scene(spin, ObserverKind::Rain, [0.4, 0.0, 0.0], r, theta_deg);
        let mut ship = board(&start, &Mount::NOSE).unwrap();
        let push = controls([0.3 / r, 0.0, 0.0], [0.0; 3]);
        let h = 1e-4;
        let mut clocks = [0.0, h, h].map(|step| {
            ship.advance(&push, step).unwrap();
            Clocks::new(&ship)
        });
        clocks[0].own = 0.0;
        let [before, now, after] = clocks;
        let home = (1.0 - 1.0 / HOME_RADIUS).sqrt();
        let seen = (after.home_seen - before.home_seen) / (2.0 * h);
        assert!(
            (seen * home - now.home_light).abs() < 1e-7,
            "{seen} {}",
            now.home_light
        );
        assert_eq!(now.far.is_some(), r > 1.0);
        if let (Some(light), Some(rate)) = (now.own_light, now.far_rate) {
            let arrival = |clocks: &Clocks| clocks.far.unwrap() + clocks.signal_delay.unwrap();
            let arriving = (arrival(&after) - arrival(&before)) / (2.0 * h);
            assert!(
                (1.0 / (arriving * home) - light).abs() < 1e-7,
                "{arriving} {light}"
            );
            let far = (after.far.unwrap() - before.far.unwrap()) / (2.0 * h);
            assert!((far - rate).abs() < 1e-7, "{far} {rate}");
        }
    }
}

/// The forward point of a boost keeps its place, so on the axes of the observer with zero angular
/// momentum, boosted to the ship, the marker is along the velocity.
#[test]
fn the_prograde_marker_is_along_the_motion_and_continuous_through_the_horizon() {
    for spin in [0.0, 0.9, -0.998] {
        let start = scene(spin, ObserverKind::Rain, [0.2, 0.3, 0.4], 2.0, 70.0);
        let mut ship = board(&start, &Mount::NOSE).unwrap();
        let [mut outside, mut inside] = [0; 2];
        let marker = |ship: &Ship| Heading::Prograde.direction(ship).unwrap();
        let mut last = marker(&ship);
        let step = 1e-3;
        loop {
            if ship.advance(&Controls::default(), step).unwrap().is_some() {
                break;
            }
            let direction = marker(&ship);
            // The direction turns with the rate of the motion, some tens of radians per r_s/c.
            let jump = (direction - last).length();
            assert!(
                jump < 60.0 * step,
                "spin {spin}, r {}: {jump}",
                ship.place().r
            );
            last = direction;
            let place = ship.place();
            if let Some(zamo) = zamo_axes(&place, 0.0) {
                outside += 1;
                let momentum = components(&zamo, ship.velocity()).yzw();
                let boosted = zamo * boost(momentum);
                let vector = boosted * glam::DVec4::from((0.0, momentum.normalize()));
                let expected = components(&ship.frame(), vector).yzw();
                // Near the horizon gamma of this observer grows, and its rounding with it.
                let tolerance = 1e-14 * momentum.length_squared().max(1.0);
                assert!((direction - expected).length() < tolerance, "r {}", place.r);
            } else {
                inside += 1;
            }
            let opposite = Heading::Retrograde.direction(&ship).unwrap();
            assert_eq!(opposite, -direction);
        }
        assert!(outside > 100 && inside > 10, "{outside} {inside}");
    }
}

/// Far away at rest the hole is inward and home outward; nothing else is needed of these directions.
#[test]
fn a_ship_at_rest_faces_the_hole_where_the_camera_does() {
    let start = scene(0.9, ObserverKind::Static, [0.0; 3], 1e6, 50.0);
    let ship = board(&start, &Mount::NOSE).unwrap();
    // Dragging turns the light by a/r.
    let nose = Heading::Hole.direction(&ship).unwrap();
    assert!((nose - DVec3::X).length() < 1e-6, "{nose}");
    let back = Heading::Outward.direction(&ship).unwrap();
    assert!((back + DVec3::X).length() < 1e-6, "{back}");
    assert!(Heading::Prograde.direction(&ship).is_some());
    let still = scene(0.0, ObserverKind::Static, [0.0; 3], 5.0, 50.0);
    let still = board(&still, &Mount::NOSE).unwrap();
    assert_eq!(Heading::Prograde.direction(&still), None);
}
