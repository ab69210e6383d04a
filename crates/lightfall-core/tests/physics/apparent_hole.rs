//! Where the hole appears, against traced rays.

use glam::DVec3;
use lightfall_core::optics::apparent_hole::{ApparentHole, dark_share};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::ObserverKind::{Orbit, Rain, Static, Zamo};
use lightfall_core::scene::{Scene, presets};
use std::f64::consts::TAU;

/// Observers outside and inside the horizon, at rest, falling, orbiting, thrown; with effects off.
fn scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for spin in [0.0, 0.9, -0.998] {
        for (kind, r, theta_deg, velocity) in [
            (Static, 20.0, 83.0, [0.0; 3]),
            (Static, 2.5, 40.0, [0.3, -0.4, 0.5]),
            (Zamo, 1.2, 60.0, [0.0; 3]),
            (Zamo, 6.0, 120.0, [0.0, 0.0, 0.9]),
            (Orbit, 8.0, 90.0, [0.0; 3]),
            (Rain, 1.4, 75.0, [0.0; 3]),
            (Rain, 0.95, 75.0, [0.2, 0.1, -0.3]),
        ] {
            for [lensing, aberration] in [[true, true], [true, false], [false, true]] {
                let mut scene = Scene::default();
                scene.hole.spin = spin;
                (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
                (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
                (scene.effects.lensing, scene.effects.aberration) = (lensing, aberration);
                scene.disk.enabled = false;
                if ApparentHole::new(&scene).is_ok() {
                    scenes.push(scene);
                }
            }
        }
    }
    assert!(scenes.len() > 50, "only {} observers exist", scenes.len());
    scenes
}

/// The traced edge of the dark disc, at angles from `middle`, in 48 directions around it.
fn traced_edge(scene: &Scene, middle: DVec3) -> Vec<f64> {
    let reference = Reference::new(scene).unwrap();
    let across = middle.any_orthonormal_vector();
    let up = middle.cross(across);
    let dark = |angle: f64, around: f64| {
        let side = around.cos() * across + around.sin() * up;
        let direction = angle.cos() * middle + angle.sin() * side;
        reference.trace(direction).outcome == Outcome::Captured
    };
    assert!(dark(0.0, 0.0), "the middle is not dark: {scene:?}");
    let edge = (0..48).map(|i| {
        let around = TAU * f64::from(i) / 48.0;
        let (mut inside, mut outside) = (0.0, std::f64::consts::PI);
        for _ in 0..30 {
            let angle = 0.5 * (inside + outside);
            if dark(angle, around) {
                inside = angle;
            } else {
                outside = angle;
            }
        }
        inside
    });
    edge.collect()
}

#[test]
fn the_middle_and_the_radius_of_the_dark_disc_are_those_of_traced_rays() {
    for scene in scenes() {
        let hole = ApparentHole::new(&scene).unwrap();
        let edge = traced_edge(&scene, hole.direction);
        let (least, most) = (
            edge.iter().copied().fold(f64::INFINITY, f64::min),
            edge.iter().copied().fold(0.0, f64::max),
        );
        let given = format!("{hole:?}, edge {least} to {most}: {scene:?}");
        let is_circle = scene.hole.spin == 0.0 || !scene.effects.lensing;
        if is_circle {
            // A bisection of 30 steps is good to 3e-9; the inverse cosine of the black ball's radius
            // costs some more digits.
            assert!(
                (most - hole.radius).abs() < 1e-6 && (most - least) < 1e-6,
                "{given}"
            );
        } else {
            // A spinning hole's shadow is flattened, and the mean direction of its edge is near
            // the middle but not exactly there.
            assert!(least <= hole.radius && hole.radius <= most, "{given}");
            assert!(least > 0.6 * most, "{given}");
        }
    }
}

#[test]
fn the_dark_share_is_that_of_a_picture_traced_with_ten_times_as_many_rays() {
    for preset in presets::PRESETS {
        let scene = preset.plain_scene();
        let reference = Reference::new(scene).unwrap();
        let size = glam::DVec2::new(64.0, 36.0);
        let axes = scene.camera.tetrad_from_camera();
        let mut dark = 0;
        for i in 0..64 * 36 {
            let pixel = glam::DVec2::new(f64::from(i % 64) + 0.5, f64::from(i / 64) + 0.5);
            let trace = reference.trace(axes * scene.camera.looking(pixel, size));
            dark += u32::from(trace.outcome == Outcome::Captured && trace.hits[0].is_none());
        }
        let fine = f64::from(dark) / (64.0 * 36.0);
        let found = dark_share(scene).unwrap();
        // An edge of the length of the picture's width crosses 16 of 144 rays, half of which may
        // fall on the wrong side.
        assert!(
            (found - fine).abs() < 8.0 / 144.0,
            "{}: {found}, {fine}",
            preset.name
        );
    }
}

#[test]
fn a_camera_turned_away_from_the_hole_does_not_have_it_in_the_picture() {
    for scene in scenes() {
        let hole = ApparentHole::new(&scene).unwrap();
        let mut facing = scene.clone();
        facing.camera.fov_deg = 20.0;
        let up = hole.direction.any_orthonormal_vector();
        let look = |forward: DVec3| glam::DMat3::from_cols(forward.cross(-up), up, forward);
        facing.camera.set_orientation(look(hole.direction));
        assert!(hole.from_camera(&facing).z > 1.0 - 1e-9);
        assert!(hole.is_in_picture(&facing), "{facing:?}");
        // Half of the picture's diagonal is less than 21 degrees.
        if hole.radius < 2.5 {
            facing.camera.set_orientation(look(-hole.direction));
            assert!(!hole.is_in_picture(&facing), "{facing:?}");
            assert_eq!(dark_share(&facing).unwrap(), 0.0, "{facing:?}");
        }
    }
}
