//! The path ahead in bent light: against numbers of another program, and against the reference tracer,
//! which knows nothing of nearest approaches.

use crate::random::Random;
use crate::timelike::scene;
use glam::{DMat2, DMat3, DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::PhotonConstants;
use lightfall_core::geometry::schwarzschild::shadow_half_angle_static;
use lightfall_core::geometry::sphere::angle_between;
use lightfall_core::optics::reference::{HoleAndDisk, Reference};
use lightfall_core::optics::ship::{Apsis, Mount, board, path_ahead, seen_path, seen_wire};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::PI;

/// The place at radius `r` in the equator, this angle ahead of the camera of [`scene`], without spin.
fn ahead(r: f64, angle: f64) -> DVec3 {
    let azimuth = 25_f64.to_radians() + angle;
    r * DVec3::new(azimuth.cos(), azimuth.sin(), 0.0)
}

/// The angles from the hole's middle at which points of the circle at 6 r_s are seen, in degrees, by an
/// observer at rest on it.
fn seen_on_circle(scene: &Scene, degrees: [f64; 3]) -> [f64; 3] {
    let steps = 180;
    let places: Vec<_> = (1..=steps)
        .map(|i| ahead(6.0, PI * f64::from(i) / f64::from(steps)))
        .collect();
    let seen = seen_wire(scene, &places).unwrap();
    degrees.map(|degree| {
        let direction = seen[degree as usize - 1].unwrap();
        assert!(direction.z >= -1e-6, "on the side of the motion");
        angle_between(direction, DVec3::NEG_X).to_degrees()
    })
}

/// Numbers of a program with another integrator, to a tenth of a degree, and what flat lines would show.
#[test]
fn points_of_the_circle_at_6_are_seen_where_another_program_sees_them() {
    let mut scene = scene(0.0, ObserverKind::Static, [0.0; 3], 6.0, 90.0);
    let expected = [44.6, 36.7, 31.3];
    let found = seen_on_circle(&scene, [120.0, 150.0, 180.0]);
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() < 0.05, "{found} for {expected}");
    }
    let shadow = shadow_half_angle_static(6.0).to_degrees();
    assert!((shadow - 23.3).abs() < 0.05, "{shadow}");
    scene.effects.lensing = false;
    let flat = seen_on_circle(&scene, [120.0, 150.0, 180.0]);
    for (found, expected) in flat.into_iter().zip([30.0, 15.0, 0.0]) {
        assert!((found - expected).abs() < 1e-6, "{found} for {expected}");
    }
}

/// The angle between `direction` and the one in which the reference tracer sees a place of the disk's
/// plane, given in the disk's frame. It is sought from a direction a thousandth of a radian beside.
fn off_by(scene: &Scene, place: DVec2, direction: DVec3) -> f64 {
    let reference = Reference::new(scene).unwrap();
    let (r, n) = reference.camera();
    let hole = HoleAndDisk {
        kerr: scene.kerr(),
        annulus: Some([0.8 * place.length(), 1.2 * place.length()]),
    };
    let missed = |direction: DVec3| {
        let photon = reference.photon(direction);
        let (constants, start) = PhotonConstants::of_photon(hole.kerr, &photon, r, n);
        let hits = hole.trace(&constants, start).hits;
        let hits = hits.into_iter().flatten();
        hits.map(|hit| hit.r * DVec2::from_angle(hit.phi) - place)
            .min_by(|a, b| a.length().total_cmp(&b.length()))
            .expect("a hit near the place")
    };
    let mut found = (direction + 1e-3 * direction.any_orthonormal_vector()).normalize();
    for _ in 0..8 {
        let (one, other) = found.any_orthonormal_pair();
        let miss = missed(found);
        let rate = |axis: DVec3| (missed((found + 1e-6 * axis).normalize()) - miss) / 1e-6;
        let step = -(DMat2::from_cols(rate(one), rate(other)).inverse() * miss);
        let step = step.clamp_length_max(1e-3);
        found = (found + step.x * one + step.y * other).normalize();
    }
    assert!(missed(found).length() < 1e-9 * place.length());
    angle_between(found, direction)
}

/// A scene whose observer moves somewhere outside the horizon, well off the equator.
fn random_scene(random: &mut Random, spin: f64) -> Scene {
    let theta_deg = random.of(&[1.0, -1.0]) * random.between(20.0, 70.0) + 90.0;
    let r = random.log_between(3.0, 20.0);
    let velocity = random.between(0.2, 0.8) * random.direction();
    scene(spin, ObserverKind::Rain, velocity.to_array(), r, theta_deg)
}

/// The path to where it first crosses the equator, between two of its points, which is its last one.
fn path_to_node(scene: &Scene) -> Option<Vec<DVec3>> {
    let ship = board(scene, &Mount::NOSE).unwrap();
    let path = path_ahead(&ship, 64);
    let places: Vec<_> = path.iter().map(|point| point.place).collect();
    let crossing = places
        .windows(2)
        .position(|pair| pair[0].z * pair[1].z < 0.0)?;
    let [from, to] = [places[crossing], places[crossing + 1]];
    let node = from + (to - from) * (from.z / (from.z - to.z));
    // Reference reports hits where matter can circle.
    let least = 1.1 * scene.kerr().photon_orbit_prograde();
    let path = [&places[1..=crossing], &[node.with_z(0.0)]].concat();
    (node.length() > least).then_some(path)
}

/// 1e-6 rad is the bar. Differences for derivatives leave about 1e-10.
#[test]
fn the_ends_of_random_inclined_paths_are_seen_where_the_reference_tracer_finds_them() {
    let mut random = Random::new();
    let (mut checked, mut worst) = (0, 0.0_f64);
    for index in 0..160 {
        let spin = [0.0, 0.9][index % 2];
        let scene = random_scene(&mut random, spin);
        let Some(path) = path_to_node(&scene) else {
            continue;
        };
        let seen = seen_wire(&scene, &path).unwrap();
        // A node more than half a turn away has no primary image on this side.
        let Some(direction) = seen.get(path.len() - 1).copied().flatten() else {
            continue;
        };
        let place = path[path.len() - 1];
        let lead = Kerr { spin }.ingoing_azimuth_lead(place.length());
        let place = DVec2::from_angle(-lead).rotate(place.truncate());
        let off = off_by(&scene, place, direction);
        assert!(off < 1e-6, "scene {index}: {off:e}");
        worst = worst.max(off);
        checked += 1;
    }
    eprintln!("{checked} ends of paths are off by {worst:.1e} rad at most");
    assert!(checked > 40, "{checked}");
}

/// Without spin a disk can be tilted so that any point lies in its plane.
#[test]
fn every_point_of_a_random_path_without_spin_is_seen_where_the_reference_tracer_finds_it() {
    let mut random = Random::new();
    let mut checked = 0;
    for _ in 0..12 {
        let mut scene = random_scene(&mut random, 0.0);
        let ship = board(&scene, &Mount::NOSE).unwrap();
        let path = path_ahead(&ship, 65);
        let places: Vec<_> = path.iter().skip(1).map(|point| point.place).collect();
        let seen = seen_path(&scene).unwrap();
        let camera = scene.camera.direction();
        let found = places.iter().zip(&seen.points).step_by(5);
        for (place, direction) in found.filter_map(|(place, seen)| Some((place, (*seen)?))) {
            let toward = place.normalize();
            let normal = toward.cross(toward.cross(camera));
            if place.length() < 1.6 || normal.length() < 0.1 {
                continue;
            }
            let normal = normal.normalize();
            scene.disk.tilt_deg = normal.z.acos().to_degrees();
            // The node is where the plane rises through the equator.
            let node = DVec3::Z.cross(normal);
            scene.disk.node_deg = node.y.atan2(node.x).to_degrees();
            let hole_from_disk: DMat3 = scene.disk.hole_from_disk();
            assert!((hole_from_disk.z_axis - normal).length() < 1e-9);
            let in_disk = hole_from_disk.transpose() * *place;
            let off = off_by(&scene, in_disk.truncate(), direction);
            assert!(off < 1e-6, "{off:e}");
            checked += 1;
        }
    }
    assert!(checked > 40, "{checked}");
}

/// Points are a twentieth of a radian apart without spin. Light from ahead moves against the rotation of
/// the hole, which carries it along: near the hole its half turn is a shorter way on the circle.
#[test]
fn the_path_of_a_circle_is_seen_for_half_a_turn_and_inside_the_horizon_nothing_is() {
    for (spin, r, least) in [
        (0.0, 6.0, 62),
        (0.0, 3.0, 62),
        (0.9, 6.0, 50),
        (0.9, 1.5, 30),
    ] {
        let scene = scene(spin, ObserverKind::Orbit, [0.0; 3], r, 90.0);
        let path = seen_path(&scene).unwrap();
        let seen = path.points.iter().flatten().count();
        assert!(seen >= least, "spin {spin}, r {r}: {seen}");
        assert!(path.apsides.is_empty(), "a circle has no turning points");
        for pair in path.points.windows(2) {
            if let [Some(from), Some(to)] = pair {
                assert!(angle_between(*from, *to) < 0.35, "spin {spin}, r {r}");
            }
        }
    }
    let inside = scene(0.0, ObserverKind::Rain, [0.0; 3], 0.9, 60.0);
    assert_eq!(seen_path(&inside).unwrap().points, []);
}

#[test]
fn turning_points_are_marked_on_the_path() {
    // Inward and slower than the circle, which at 12 r_s has 0.21 c: down to the lowest point within half
    // a turn.
    let scene = scene(0.0, ObserverKind::Static, [-0.08, 0.0, 0.19], 12.0, 90.0);
    let path = seen_path(&scene).unwrap();
    let [(apsis, direction)] = path.apsides[..] else {
        panic!("{:?}", path.apsides)
    };
    assert_eq!(apsis, Apsis::Low);
    let ship = board(&scene, &Mount::NOSE).unwrap();
    let ahead = path_ahead(&ship, 65);
    let index = ahead
        .iter()
        .position(|point| point.apsis.is_some())
        .unwrap();
    assert_eq!(path.points[index - 1], Some(direction));
    let lowest = ahead[index].place.length();
    let others = ahead.iter().map(|point| point.place.length());
    assert_eq!(lowest, others.fold(f64::INFINITY, f64::min));
}

#[test]
fn random_scenes_of_extreme_numbers_have_paths_of_unit_directions_without_panic() {
    let mut random = Random::new();
    for spin in [0.0, 1e-5, -0.999_99, 0.998] {
        let horizon = Kerr { spin }.horizon();
        for r in [horizon, 1.000_001 * horizon, 1.1 * horizon, 1.4, 1e5] {
            for theta in [0.0, 1e-9, 60.0, 90.0, 180.0] {
                let velocity = random.between(0.0, 0.999) * random.direction();
                for lensing in [true, false] {
                    let mut scene = scene(spin, ObserverKind::Rain, velocity.to_array(), r, theta);
                    scene.effects.lensing = lensing;
                    let Ok(path) = seen_path(&scene) else {
                        assert!(r <= horizon || !lensing, "{spin} {r} {theta}");
                        continue;
                    };
                    for direction in path.points.iter().flatten() {
                        let length = direction.length();
                        assert!((length - 1.0).abs() < 1e-9, "{spin} {r} {theta}: {length}");
                    }
                }
            }
        }
    }
}
