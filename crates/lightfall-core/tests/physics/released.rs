//! Observers released at many places with many velocities: their constants of the motion, the rates
//! that the metric requires, and the pictures that they see.

use crate::assert_close;
use crate::timelike::scene;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::observer_matrix;
use lightfall_core::geometry::tetrad::four_velocity;
use lightfall_core::geometry::timelike::{Geodesic, Limit, ParticleConstants, ParticleState};
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::optics::shift::RestFrame;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::TAU;

/// Releases with and without spin, over poles, bound and unbound, and next to the hole.
fn releases() -> Vec<Scene> {
    let mut all = Vec::new();
    for spin in [-0.998, -0.5, 0.0, 0.7, 0.9999] {
        for (r, theta_deg) in [
            (1.6, 90.0),
            (2.5, 40.0),
            (6.0, 75.0),
            (30.0, 0.0),
            (30.0, 179.0),
            (1e4, 10.0),
        ] {
            for velocity in [
                [0.0; 3],
                [-0.1, 0.2, 0.3],
                [0.5, 0.0, -0.6],
                [0.0, -0.4, 0.0],
            ] {
                for kind in [ObserverKind::Static, ObserverKind::Zamo, ObserverKind::Rain] {
                    all.push(scene(spin, kind, velocity, r, theta_deg));
                }
            }
        }
    }
    all
}

/// The largest relative violation of the constraints on u'^2, |n'|^2 and (n x n')_z.
fn residual(Geodesic { constants, state }: &Geodesic) -> f64 {
    let ParticleConstants {
        a,
        energy,
        angular_momentum,
        k,
    } = *constants;
    let ParticleState { u, du, n, dn, .. } = *state;
    let ae = a * energy;
    let k_prime = k + ae * (ae - 2.0 * angular_momentum);
    let (w, d) = (
        energy + a * (ae - angular_momentum) * u * u,
        1.0 - u + (a * u).powi(2),
    );
    let rest = d * (1.0 + k_prime * u * u);
    let radial = (du * du - w * w + rest).abs() / (w * w + rest.abs());
    let kappa = a * a * (1.0 - energy) * (1.0 + energy);
    let scale = k.abs() + kappa.abs();
    if scale == 0.0 {
        return radial;
    }
    let angular = (dn.length_squared() - k + kappa * n.z * n.z).abs() / scale;
    let axial = (n.x * dn.y - n.y * dn.x - angular_momentum).abs() / scale.sqrt();
    radial.max(angular).max(axial)
}

#[test]
fn a_released_observer_keeps_its_constants_and_the_scene_has_its_four_velocity() {
    let (mut inside, mut outer) = (0, 0);
    for mut scene in releases() {
        let Ok(mut worldline) = Worldline::start(&scene) else {
            continue;
        };
        let shown = format!(
            "{:?} {:?} spin {}",
            scene.camera, scene.observer, scene.hole.spin
        );
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let step = 0.03 * scene.camera.r.powf(1.5);
        for _ in 0..60 {
            let limit = worldline.advance(step, &mut scene);
            assert_ne!(limit, Some(Limit::Lost), "{shown}");
            outer += u32::from(limit == Some(Limit::Outer));
            inside += u32::from(scene.camera.r < kerr.horizon());
            let particle = worldline.geodesic().unwrap();
            assert!(
                residual(particle) < 1e-10,
                "{shown}: {:e}",
                residual(particle)
            );
            // The four-velocity of the picture's observer is the first column of its matrix.
            let (theta, phi) = (
                scene.camera.theta_deg.to_radians(),
                scene.camera.phi_deg.to_radians(),
            );
            let rain = ObserverKind::Rain;
            assert_eq!(scene.observer.kind, rain);
            let matrix = observer_matrix(
                kerr.spin,
                rain,
                scene.observer.velocity,
                scene.camera.r,
                theta,
                phi,
            )
            .unwrap();
            let (found, expected) = (four_velocity(&matrix), particle.velocity());
            // Rounding errors grow with the speed relative to rain, whose gamma reaches some tens
            // inside.
            assert_close(format!("E, {shown}"), found.energy, expected.energy, 1e-8);
            assert!(
                (found.radial - expected.radial).abs() < 1e-8 * expected.radial.abs().max(1.0),
                "{shown}"
            );
            assert!(
                (found.w.length() - expected.w.length()).abs()
                    < 1e-8 * expected.w.length().max(1.0),
                "{shown}"
            );
            let [l, expected] = [
                scene.camera.r * scene.camera.direction().cross(found.w).z,
                particle.constants.angular_momentum,
            ];
            assert!(
                (l - expected).abs() < 1e-8 * expected.abs().max(1.0),
                "L, {shown}"
            );
            if limit.is_some() {
                break;
            }
        }
    }
    assert!(inside > 500, "{inside} places inside the horizon");
    assert_eq!(outer, 0);
}

/// The rates of r, theta, phi and t with proper time are the contravariant components of the
/// four-velocity, by the inverse metric (Bardeen, Press & Teukolsky 1972 eq. 2.10). Central
/// differences have a relative error of 1e-6.
#[test]
fn places_and_coordinate_time_change_at_the_rates_of_the_metric() {
    let mut compared = 0;
    for scene in releases()
        .into_iter()
        .filter(|scene| scene.camera.r < 100.0)
    {
        let Ok(worldline) = Worldline::start(&scene) else {
            continue;
        };
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let h = 1e-5 * scene.camera.r;
        let at = |own_time: f64| {
            let (mut worldline, mut scene) = (worldline.clone(), scene.clone());
            let limit = worldline.advance(own_time, &mut scene);
            (limit, scene, worldline)
        };
        for time in [0.0, 0.5, 2.0, 9.0].map(|time| time * scene.camera.r.sqrt() + h) {
            let [(before, a, earlier), (_, here, middle), (after, b, later)] =
                [time - h, time, time + h].map(at);
            if before.or(after).is_some() || b.camera.r < 1.02 * kerr.horizon() {
                break;
            }
            let cos = here.camera.direction().z;
            let sin2 = 1.0 - cos * cos;
            if sin2 < 1e-3 {
                continue;
            }
            let (r, particle) = (here.camera.r, middle.geodesic().unwrap());
            let RestFrame {
                lapse,
                dragging,
                width,
            } = RestFrame::at(kerr, r, here.camera.theta_deg.to_radians());
            let time_rate = (particle.constants.energy
                - dragging * particle.constants.angular_momentum)
                / (lapse * lapse);
            let phi_rate =
                dragging * time_rate + particle.constants.angular_momentum / (width * width * sin2);
            let r_rate = r * r * particle.velocity().radial / kerr.sigma(r, cos);
            let rate = |first: f64, second: f64| (second - first) / (2.0 * h);
            let close = |what: &str, found: f64, expected: f64| {
                let scale = expected.abs().max(0.01);
                assert!(
                    (found - expected).abs() < 1e-6 * scale,
                    "{what}: {found} {expected}, {scene:?} at {time}"
                );
            };
            close(
                "t",
                rate(
                    earlier.coordinate_time().unwrap(),
                    later.coordinate_time().unwrap(),
                ),
                time_rate,
            );
            close("r", rate(a.camera.r, b.camera.r), r_rate);
            let swept = (b.camera.phi_deg - a.camera.phi_deg).to_radians();
            close(
                "phi",
                (swept - TAU * (swept / TAU).round()) / (2.0 * h),
                phi_rate,
            );
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

/// The photon of every pixel is the same before and just after the release, although the observer's
/// kind and its axes change.
#[test]
fn a_release_does_not_move_the_picture() {
    let mut compared = 0;
    for mut before in releases() {
        (
            before.camera.yaw_deg,
            before.camera.pitch_deg,
            before.camera.roll_deg,
        ) = (20.0, -35.0, 10.0);
        let Ok(mut worldline) = Worldline::start(&before) else {
            continue;
        };
        let mut after = before.clone();
        worldline.advance(0.0, &mut after);
        let [(camera_rays, axes), (other, turned)] = [&before, &after].map(|scene| {
            (
                CameraRays::new(scene).unwrap(),
                scene.camera.tetrad_from_camera(),
            )
        });
        for pixel in [
            DVec3::Z,
            DVec3::new(0.6, 0.0, 0.8),
            DVec3::new(-0.48, 0.6, 0.64),
            DVec3::NEG_Y,
        ] {
            let [one, two] = [
                camera_rays.photon(axes * pixel),
                other.photon(turned * pixel),
            ];
            let scale = one.energy.abs().max(1.0);
            let off = (one.energy - two.energy).abs()
                + (one.radial - two.radial).abs()
                + (one.w - two.w).length();
            // Next to the horizon of a fast hole an observer at rest has a gamma of some hundreds
            // relative to rain.
            assert!(
                off < 1e-8 * scale,
                "{:?} {:?}: {off:e}",
                before.camera,
                before.observer
            );
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

#[test]
fn a_flight_over_the_pole_keeps_the_hole_in_its_place_in_the_picture() {
    // Straight up along a meridian without rotation. Beyond the pole the direction of growing theta
    // is reversed.
    let r: f64 = 10.0;
    let speed = (0.5 / (r - 1.0)).sqrt();
    let mut scene = scene(0.0, ObserverKind::Static, [0.0, -speed, 0.0], r, 5.0);
    (scene.camera.yaw_deg, scene.camera.pitch_deg) = (12.0, 7.0);
    let normal = scene.camera.tetrad().z_axis;
    let mut worldline = Worldline::start(&scene).unwrap();
    // The axes become those of rain.
    worldline.advance(0.0, &mut scene);
    let axes = scene.camera.tetrad() * scene.camera.tetrad_from_camera();
    for _ in 0..50 {
        let before = scene.camera.direction();
        worldline.advance(0.5, &mut scene);
        let swept = before.angle_between(scene.camera.direction());
        assert!(
            (swept - 0.5 * speed / ((1.0 - speed * speed).sqrt() * r)).abs() < 1e-9,
            "{swept}"
        );
    }
    assert!(
        scene.camera.direction().dot(DVec3::Z) < 0.995 && scene.camera.phi_deg < -100.0,
        "{:?}",
        scene.camera
    );
    let turned = scene.camera.tetrad() * scene.camera.tetrad_from_camera();
    let angle = 25.0 * speed / ((1.0 - speed * speed).sqrt() * r);
    let expected = glam::DMat3::from_axis_angle(normal, -angle) * axes;
    assert!(
        (turned.z_axis - expected.z_axis).length() < 1e-8,
        "{turned} {expected}"
    );
    assert!(
        (turned.y_axis - expected.y_axis).length() < 1e-8,
        "{turned} {expected}"
    );
}
