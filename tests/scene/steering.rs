//! Flying by hand: the camera always moves on with a scene that can be drawn, and another observer
//! takes over where the wanted one cannot exist.

use crate::random::Random;
use glam::DVec3;
use lightfall::app::{Barrier, Steered, Steering, steered};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Camera, MAX_RADIUS, Method, ObserverKind, Scene};

/// A frame at sixty frames per second.
const FRAME: f64 = 1.0 / 60.0;

/// A frame of full thrust.
fn full_thrust(thrust: DVec3) -> Steering {
    Steering {
        thrust,
        turn: DVec3::ZERO,
        speed: 1.0,
        seconds: FRAME,
    }
}

fn place(camera: &Camera) -> DVec3 {
    camera.direction() * camera.r
}

/// A scene around a hole of spin 0.9, in which only the camera and the observer matter.
fn spinning(kind: ObserverKind, r: f64, theta_deg: f64) -> Drawable {
    let mut scene = Scene::default();
    scene.hole.spin = 0.9;
    scene.observer.kind = kind;
    (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
    Drawable::new(scene).unwrap()
}

#[test]
fn thrust_in_the_ergosphere_flies_on_with_an_observer_that_exists_and_reports_it_once() {
    // A circular orbit in the ergosphere, which ends at r = 1 in the equatorial plane. Nothing is at
    // rest there, but thrust takes the camera off its orbit.
    let orbiting = spinning(ObserverKind::Orbit, 0.9, 90.0);
    for thrust in [DVec3::X, DVec3::Y, -DVec3::Z] {
        let first = steered(&orbiting, &full_thrust(thrust)).unwrap();
        assert_ne!(place(&first.scene.camera), place(&orbiting.camera));
        assert_eq!(first.scene.observer.kind, ObserverKind::Zamo);
        assert_eq!(
            first.replaced,
            Some([ObserverKind::Static, ObserverKind::Zamo])
        );
        let second = steered(&first.scene, &full_thrust(thrust)).unwrap();
        assert_ne!(place(&second.scene.camera), place(&first.scene.camera));
        assert_eq!(second.replaced, None);
    }
}

#[test]
fn an_observer_at_rest_flown_from_the_axis_into_the_ergosphere_flies_on_as_zamo() {
    // On the axis the ergosphere begins at the horizon, r = 0.718; at the equator, at r = 1.
    let mut scene = spinning(ObserverKind::Static, 0.95, 0.0);
    let mut replaced = Vec::new();
    for frame in 0.. {
        assert!(frame < 10_000, "{:?}", scene.camera);
        // The camera looks at the hole in every frame, and down leads to growing theta.
        let next = steered(&scene, &full_thrust(-DVec3::Y)).unwrap();
        assert!(next.scene.camera.theta_deg > scene.camera.theta_deg);
        replaced.extend(next.replaced);
        let mut level = next.scene.into_scene();
        let camera = &mut level.camera;
        (camera.yaw_deg, camera.pitch_deg, camera.roll_deg) = (0.0, 0.0, 0.0);
        scene = Drawable::new(level).unwrap();
        if scene.camera.theta_deg > 89.0 {
            break;
        }
    }
    assert!(scene.camera.r < 0.96, "{}", scene.camera.r);
    assert_eq!(replaced, [[ObserverKind::Static, ObserverKind::Zamo]]);
}

#[test]
fn thrust_brings_an_orbiting_camera_to_rest_outside_the_ergosphere() {
    let orbiting = spinning(ObserverKind::Orbit, 8.0, 90.0);
    let Steered {
        scene, replaced, ..
    } = steered(&orbiting, &full_thrust(DVec3::X)).unwrap();
    assert_eq!(
        (scene.observer.kind, replaced),
        (ObserverKind::Static, None)
    );
}

#[test]
fn looking_around_leaves_the_place_and_the_observer_as_they_are() {
    for kind in ObserverKind::ALL {
        let mut scene = spinning(kind, 1.7, 90.0);
        let before = scene.clone();
        for _ in 0..100 {
            let looking = Steering {
                thrust: DVec3::ZERO,
                turn: DVec3::new(0.3, -0.2, 0.1),
                ..full_thrust(DVec3::ZERO)
            };
            let next = steered(&scene, &looking).unwrap();
            assert_eq!(next.replaced, None);
            scene = next.scene;
        }
        let place = |camera: &Camera| (camera.r, camera.theta_deg, camera.phi_deg);
        assert_eq!(place(&scene.camera), place(&before.camera));
        assert_eq!(scene.observer, before.observer);
        assert_ne!(scene.camera, before.camera);
    }
}

/// A random scene that can be drawn, often at the very limits of what can be.
fn random_scene(random: &mut Random) -> Drawable {
    loop {
        let mut scene = Scene {
            method: random.of(&Method::ALL),
            ..Scene::default()
        };
        scene.hole.spin = match random.integer(0, 4) {
            0 => 0.0,
            1 => random.of(&[-0.999_999, -0.9, 0.9, 0.999_999]),
            2 => random.between(0.7, 1.0),
            _ => random.between(-1.0, 1.0),
        };
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        scene.observer.kind = random.of(&ObserverKind::ALL);
        let camera = &mut scene.camera;
        camera.theta_deg = match random.integer(0, 2) {
            _ if scene.observer.kind == ObserverKind::Orbit => 90.0,
            0 => random.of(&[0.0, 90.0, 180.0]),
            _ => random.between(0.0, 180.0),
        };
        camera.r = match random.integer(0, 3) {
            0 => random.of(&[
                min_infall_radius(kerr),
                kerr.horizon(),
                kerr.static_limit(camera.theta_deg.to_radians().cos()) * (1.0 + 1e-12),
                kerr.photon_orbit_prograde() * (1.0 + 1e-12),
                1.08,
                MAX_RADIUS,
            ]),
            1 => random.between(min_infall_radius(kerr), 1.1),
            2 => random.between(1.0, 4.0),
            _ => random.between(0.0, MAX_RADIUS.ln()).exp(),
        };
        camera.phi_deg = random.between(-360.0, 360.0);
        camera.yaw_deg = random.between(-360.0, 360.0);
        let pitch_deg = random.between(-360.0, 360.0);
        camera.pitch_deg = random.of(&[-90.0, 90.0, pitch_deg]);
        camera.roll_deg = random.between(-360.0, 360.0);
        if random.one_in(2) {
            scene.observer.velocity = [(); 3].map(|()| random.between(-0.57, 0.57));
        }
        let effects = &mut scene.effects;
        for effect in [
            &mut effects.lensing,
            &mut effects.doppler,
            &mut effects.beaming,
            &mut effects.gravitational_shift,
            &mut effects.aberration,
        ] {
            *effect = !random.one_in(6);
        }
        if let Ok(scene) = Drawable::new(scene) {
            return scene;
        }
    }
}

fn random_steering(random: &mut Random) -> Steering {
    let mut vector = |size: f64| {
        DVec3::new(
            random.between(-size, size),
            random.between(-size, size),
            random.between(-size, size),
        )
    };
    let (thrust, turn) = (vector(1.0).clamp_length_max(1.0), vector(3.0));
    let seconds = random.between(1e-4, 0.25);
    Steering {
        thrust: random.of(&[thrust, DVec3::X, DVec3::Z, -DVec3::Z]),
        turn: random.of(&[turn, DVec3::ZERO]),
        speed: random.between(-9.0, 5.0).exp2(),
        seconds: random.of(&[FRAME, 0.25, seconds]),
    }
}

/// Whether thrust must have moved the camera, which was outside the horizon: some of it does not
/// lead farther in or out than the camera may fly. Shares below a thousandth may be lost in
/// rounding.
fn must_move(before: &Camera, after: &Camera, thrust: DVec3) -> bool {
    // The axes after the frame's turn, in which the thrust is given.
    let thrust = after.tetrad() * after.tetrad_from_camera() * thrust;
    let outward = thrust.dot(before.direction());
    let sideways = (thrust - outward * before.direction()).length();
    sideways > 1e-3
        || outward > 1e-3 && before.r < MAX_RADIUS
        || outward < -1e-3 && before.r > 1.08 + 1e-6
}

#[test]
fn whatever_the_hand_does_in_random_places_the_scene_can_be_drawn_and_the_camera_moves() {
    let mut random = Random::new();
    let mut replaced_count = 0;
    for case in 0..10_000 {
        let mut scene = random_scene(&mut random);
        for _ in 0..3 {
            let steering = random_steering(&mut random);
            let given = || format!("case {case}: {steering:?} of {:?}", *scene);
            let Steered {
                scene: next,
                replaced,
                stopped_by,
            } = steered(&scene, &steering).unwrap_or_else(|error| panic!("{error}, {}", given()));
            let inside = scene.camera.r <= kerr(&scene).horizon();
            if inside {
                assert_eq!(place(&scene.camera), place(&next.camera), "{}", given());
                let pushed = steering.thrust != DVec3::ZERO;
                assert_eq!(
                    stopped_by,
                    pushed.then_some(Barrier::Horizon),
                    "{}",
                    given()
                );
            } else if must_move(&scene.camera, &next.camera, steering.thrust) {
                assert_ne!(
                    place(&scene.camera),
                    place(&next.camera),
                    "the camera stands still, {}",
                    given()
                );
            }
            let wanted = match scene.observer.kind {
                ObserverKind::Orbit if steering.thrust != DVec3::ZERO => ObserverKind::Static,
                kind => kind,
            };
            let expected = (wanted != next.observer.kind).then_some([wanted, next.observer.kind]);
            assert_eq!(replaced, expected, "{}", given());
            replaced_count += usize::from(replaced.is_some());
            scene = next;
        }
    }
    // The cases would show nothing if they never led to such a place.
    assert!(
        replaced_count > 100,
        "only {replaced_count} observers were replaced"
    );
}

fn kerr(scene: &Scene) -> Kerr {
    Kerr {
        spin: scene.hole.spin,
    }
}
