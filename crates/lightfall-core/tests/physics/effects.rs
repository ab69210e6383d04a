//! Effects switched off one by one, against observers and flat space.

use crate::reference::directions;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::{Photon, observer_matrix};
use lightfall_core::geometry::sphere::celestial_frame;
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::optics::disk;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::shift::{RestFrame, Shift};
use lightfall_core::scene::{Effects, ObserverKind, Scene};
use std::f64::consts::FRAC_PI_2;

fn scene(spin: f64, kind: ObserverKind, velocity: [f64; 3]) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (6.0, 70.0, 25.0);
    (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
    scene
}

#[test]
fn an_observer_at_rest_in_the_local_frame_has_no_doppler_factor() {
    for spin in [-0.9, 0.0, 0.5, 0.998] {
        let mut scene = scene(spin, ObserverKind::Zamo, [0.0; 3]);
        scene.effects.gravitational_shift = false;
        let (camera_rays, shift) = (CameraRays::new(&scene).unwrap(), Shift::new(&scene));
        for direction in directions(400) {
            let photon = camera_rays.photon(direction);
            let n = scene.camera.direction();
            let lambda = scene.camera.r * n.cross(photon.w).z / photon.energy;
            // Only the Doppler factor remains, which is one for this camera, except for rounding.
            assert!(
                (shift.of_sky(1.0 / photon.energy, lambda) - 1.0).abs() < 1e-13,
                "spin {spin}, {direction}"
            );
        }
    }
}

#[test]
fn the_matters_motion_is_the_doppler_shift_of_special_relativity_in_the_local_frame() {
    for spin in [-0.9, 0.0, 0.5, 0.998] {
        // The camera is at rest in the local frame in the plane, next to the matter. At equal radii
        // the gravitational factor is one.
        let mut scene = scene(spin, ObserverKind::Zamo, [0.0; 3]);
        let kerr = Kerr { spin };
        (scene.camera.r, scene.camera.theta_deg) = (1.3 * kerr.isco(), 90.0);
        scene.effects.gravitational_shift = false;
        let r = scene.camera.r;
        let orbit = kerr.circular_orbit(r).unwrap();
        let matrix =
            observer_matrix(spin, ObserverKind::Zamo, [0.0; 3], r, FRAC_PI_2, 0.0).unwrap();
        // The matter's speed in the local frame: d(phi) - omega dt in the frame's lengths and
        // times.
        let RestFrame {
            lapse,
            dragging,
            width,
        } = RestFrame::at(kerr, r, FRAC_PI_2);
        let speed = (orbit.angular_velocity - dragging) * width / lapse;
        for direction in directions(400) {
            let photon = matrix.photon(direction);
            let momentum = r * photon.w.y;
            let whole = disk::redshift(&orbit, photon.energy, momentum);
            let found = Shift::new(&scene).of_disk(whole, r, momentum / photon.energy);
            // Light that arrives from d travels along -d.
            let expected = (1.0 - speed * speed).sqrt() / (1.0 + speed * direction.z);
            assert!(
                (found / expected - 1.0).abs() < 1e-12,
                "spin {spin}: {found} against {expected}"
            );
        }
    }
}

#[test]
fn without_spin_the_gravitational_factor_is_that_of_observers_at_rest() {
    let mut scene = scene(0.0, ObserverKind::Rain, [0.1, -0.2, 0.3]);
    scene.effects.doppler = false;
    let shift = Shift::new(&scene);
    // sqrt(1 - 1/r) at both ends, for every motion of the camera.
    let lapse = |r: f64| (1.0 - 1.0 / r).sqrt();
    assert!((shift.of_sky(0.7, 2.0) - 1.0 / lapse(6.0)).abs() < 1e-15);
    assert!((shift.of_disk(0.7, 4.0, 2.0) - lapse(4.0) / lapse(6.0)).abs() < 1e-15);
}

#[test]
fn without_aberration_directions_are_those_of_the_local_frame_and_frequencies_those_of_the_camera()
{
    for (spin, kind, velocity) in [
        (0.0, ObserverKind::Static, [0.3, -0.4, 0.5]),
        (0.9, ObserverKind::Rain, [0.1, 0.0, -0.6]),
        (-0.7, ObserverKind::Static, [0.0; 3]),
    ] {
        let with = scene(spin, kind, velocity);
        let mut without = with.clone();
        without.effects.aberration = false;
        let (with, without) = (
            CameraRays::new(&with).unwrap(),
            CameraRays::new(&without).unwrap(),
        );
        let (theta, phi) = (70_f64.to_radians(), 25_f64.to_radians());
        let rest = observer_matrix(spin, ObserverKind::Zamo, [0.0; 3], 6.0, theta, phi).unwrap();
        for direction in directions(400) {
            let (photon, at_rest) = (without.photon(direction), rest.photon(direction));
            // The same path: the photons differ only by a factor.
            let factor = at_rest.energy / photon.energy;
            assert!((factor * photon.w - at_rest.w).length() < 1e-13);
            assert!((factor * photon.radial - at_rest.radial).abs() < 1e-13);
            // Per unit frequency for the camera: -p.u = 1, u being the first column of the camera's
            // own matrix.
            let camera = with.matrix.rows.map(|row| row[0]);
            let camera = Photon {
                energy: camera[0],
                radial: camera[1],
                w: DVec3::from_slice(&camera[2..]),
            };
            let [p, u] = [photon, camera].map(|vector| on_zamo_tetrad(spin, &vector, theta, phi));
            // f64's rounding, times the camera's gamma squared.
            assert!(
                (p[0] * u[0] - p[1] * u[1] - p[2] * u[2] - p[3] * u[3] - 1.0).abs() < 1e-13,
                "{direction}"
            );
        }
    }
}

/// A vector on the axes of the zero-angular-momentum observer at r = 6, from the metric: Bardeen,
/// Press & Teukolsky 1972 eq. 3.2.
fn on_zamo_tetrad(spin: f64, vector: &Photon, theta: f64, phi: f64) -> [f64; 4] {
    let (kerr, r) = (Kerr { spin }, 6.0);
    let frame = RestFrame::at(kerr, r, theta);
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let (sigma, delta) = (kerr.sigma(r, theta.cos()), kerr.delta(r));
    let momentum = r * vector.w.dot(phi_hat) * theta.sin();
    [
        (vector.energy - frame.dragging * momentum) / frame.lapse,
        r * r * vector.radial / (sigma * delta).sqrt(),
        r * vector.w.dot(theta_hat) / sigma.sqrt(),
        r * vector.w.dot(phi_hat) / frame.width,
    ]
}

#[test]
fn straight_rays_keep_the_aberration_of_special_relativity() {
    let speed = 0.6;
    let mut scene = scene(0.9, ObserverKind::Zamo, [speed, 0.0, 0.0]);
    (scene.disk.enabled, scene.effects.lensing) = (false, false);
    let reference = Reference::new(&scene).unwrap();
    let mut seen = 0;
    for direction in directions(400) {
        let Some(sky) = reference.trace(direction).sky else {
            continue;
        };
        // Einstein 1905, section 7, for a camera that moves outward: cos = (cos' - v) / (1 - v
        // cos').
        let cosine = (direction.x - speed) / (1.0 - speed * direction.x);
        assert!(
            (sky.dot(scene.camera.direction()) - cosine).abs() < 1e-12,
            "{direction}"
        );
        seen += 1;
    }
    assert!(seen > 20, "{seen} rays reach the sky");
}

#[test]
fn far_from_the_hole_the_disks_shifts_do_not_depend_on_lensing() {
    let mut scene = scene(0.5, ObserverKind::Static, [0.0; 3]);
    (scene.camera.r, scene.camera.theta_deg) = (60_000.0, 40.0);
    (scene.disk.inner, scene.disk.outer) = (3000.0, 30_000.0);
    let bent = Reference::new(&scene).unwrap();
    scene.effects = Effects {
        lensing: false,
        ..Effects::default()
    };
    let straight = Reference::new(&scene).unwrap();
    let mut hits = 0;
    for turn in 0..60 {
        let turn = f64::from(turn) * 0.1;
        let direction = DVec3::new(-1.0, 0.3 * turn.sin(), 0.3 * turn.cos());
        if let [Some(bent), Some(straight)] =
            [bent, straight].map(|reference| reference.trace(direction).hits[0])
        {
            // Matter moves with 0.007 c at most. Light is deflected by about 1/r, which displaces
            // its hit by the same angle.
            assert!((bent.g - straight.g).abs() < 3e-6, "{bent:?} {straight:?}");
            assert!(
                (straight.g - 1.0).abs() > 3e-6 && (bent.r / straight.r - 1.0).abs() < 1e-3,
                "{bent:?} {straight:?}"
            );
            hits += 1;
        }
    }
    assert!(hits > 30, "{hits} hits");
}
