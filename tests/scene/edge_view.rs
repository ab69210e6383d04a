//! The edge of the shadow stays in view during a fall.

use glam::DVec3;
use lightfall::app::{Aim, aimed, edge_distance, edge_in_view};
use lightfall_core::optics::apparent_hole::{ApparentHole, dark_share};
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::{Scene, presets};
use std::f64::consts::FRAC_PI_2;

/// How far the camera may turn in one frame, in radians: half a radian a second.
const MAX_TURN: f64 = 0.5 / 60.0;

/// Maximum share of the picture that the shadow may fill during a fall.
const MAX_DARK: f64 = 0.6;

fn preset(name: &str) -> Scene {
    presets::find(name).unwrap().scene(&[]).unwrap()
}

/// Lets the scene's observer fall to the end in steps of the usual pace, and turns the camera in each
/// one. `check` is called after each step.
fn fall(mut scene: Scene, mut check: impl FnMut(&Scene)) {
    let axes = aimed(&scene, Aim::Hole).unwrap();
    scene.camera.set_orientation(axes);
    let mut line = Worldline::start(&scene).unwrap();
    let mut was_turned = false;
    loop {
        let limit = line.advance(0.1 / 60.0 * scene.camera.r.powf(1.5), &mut scene);
        let before = scene.camera.tetrad_from_camera().z_axis;
        if let Some(axes) = edge_in_view(&scene, was_turned, MAX_TURN) {
            scene.camera.set_orientation(axes);
            was_turned = true;
        }
        let after = scene.camera.tetrad_from_camera().z_axis;
        assert!(before.angle_between(after) < MAX_TURN * (1.0 + 1e-6));
        check(&scene);
        if limit.is_some() {
            return;
        }
    }
}

#[test]
fn a_fall_is_never_dark_and_the_edge_comes_to_the_middle() {
    for (name, spin) in [
        ("edge-on", 0.0),
        ("above", 0.0),
        ("edge-on", 0.9),
        ("close", 0.9),
        ("extremal", 0.998),
        ("limit", 0.99),
    ] {
        let mut scene = preset(name);
        scene.hole.spin = spin;
        let (mut frames, mut darkest, mut last) = (0, 0.0_f64, scene.clone());
        fall(scene, |scene| {
            // A camera that begins in the dark needs some seconds to turn. Of a spinning hole the edge
            // is no circle, and the camera keeps to one of its size.
            if frames % 20 == 0 && frames > 240 {
                let dark = dark_share(scene).unwrap();
                darkest = dark.max(darkest);
                assert!(
                    dark < MAX_DARK,
                    "{name} at r {}: {dark} is dark",
                    scene.camera.r
                );
            }
            frames += 1;
            last = scene.clone();
        });
        println!("{name}: at most {darkest} is dark");
        let hole = ApparentHole::new(&last).unwrap();
        let forward = last.camera.tetrad_from_camera().z_axis;
        // At the end the edge is between the middle and the upper part of the picture.
        let above = (hole.radius - hole.direction.angle_between(forward))
            / last.camera.half_angles(last.picture.size().as_dvec2()).y;
        assert!(
            frames > 200 && (-0.05..0.6).contains(&above),
            "{name}: {above}, {frames} frames"
        );
    }
}

#[test]
fn a_small_hole_and_a_camera_that_looks_beside_it_are_left_alone() {
    let mut scene = preset("edge-on");
    assert_eq!(edge_in_view(&scene, false, MAX_TURN), None);
    scene.camera.r = 1.2;
    let hole = ApparentHole::new(&scene).unwrap();
    let axes = aimed(&scene, Aim::Outward).unwrap();
    scene.camera.set_orientation(axes);
    assert_eq!(edge_in_view(&scene, false, MAX_TURN), None);
    assert!(
        edge_in_view(&scene, true, MAX_TURN).is_some(),
        "it never turns back"
    );
    // Beside the middle the camera turns straight away from it, and stays level to the side.
    let axes = aimed(&scene, Aim::Hole).unwrap();
    scene.camera.set_orientation(axes);
    scene.camera.yaw_deg += 20.0;
    let turned = edge_in_view(&scene, false, MAX_TURN).unwrap();
    let before = scene.camera.tetrad_from_camera().z_axis;
    let gained = hole.direction.angle_between(turned.z_axis) - hole.direction.angle_between(before);
    assert!((gained - MAX_TURN).abs() < 1e-9);
    assert!(turned.z_axis.dot(DVec3::Y).abs() < 1e-6);
}

#[test]
fn the_edge_moves_from_the_upper_part_of_the_picture_toward_its_middle() {
    for half_height in [0.1, 0.5] {
        let in_picture = |radius: f64| (radius - edge_distance(radius, half_height)) / half_height;
        let first = 0.6 * half_height;
        assert!(edge_distance(first, half_height).abs() < 1e-12);
        assert!(edge_distance(0.9 * first, half_height) < 0.0);
        let mut last = in_picture(first);
        assert!((last - 0.6).abs() < 1e-12);
        for step in 1..=20 {
            let next = in_picture(first + f64::from(step) / 20.0 * (FRAC_PI_2 - first));
            assert!(next < last && next > 0.0);
            last = next;
        }
        assert!(last < 0.3);
    }
}
