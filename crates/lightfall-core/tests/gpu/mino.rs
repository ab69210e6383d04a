//! The method mino: Kerr's rays on the GPU against the f64 reference, published values and
//! symmetries.

use crate::bisect::bisect;
use crate::{
    bare_hole, direction_off_centre, gpu, median, pixel_directions, quantile, with_truths,
};
use glam::DVec3;
use lightfall_core::gpu::rays;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::{Outcome, Trace};
use lightfall_core::scene::{Method, ObserverKind, Scene};

fn spinning_hole(spin: f64, r: f64, theta_deg: f64) -> Scene {
    let mut scene = bare_hole(r);
    scene.method = Method::Mino;
    scene.hole.spin = spin;
    scene.camera.theta_deg = theta_deg;
    scene.observer.kind = ObserverKind::Zamo;
    scene.disk.enabled = true;
    scene
}

/// Directions all over the sphere, denser toward the hole, rounded to f32 so that the reference
/// traces the same rays.
fn spiral(count: u32) -> Vec<DVec3> {
    let direction = |i: u32| {
        let share = (f64::from(i) + 0.5) / f64::from(count);
        let inward = 1.0 - 2.0 * share * share;
        let (sin, cos) = (2.399_963 * f64::from(i)).sin_cos();
        let across = (1.0 - inward * inward).sqrt();
        DVec3::new(-inward, across * cos, across * sin)
            .as_vec3()
            .as_dvec3()
    };
    (0..count).map(direction).collect()
}

/// The smallest angle from the hole's centre, toward increasing phi times `side`, at which the
/// reference's rays are not captured.
fn edge(reference: &Reference, side: f64) -> f64 {
    let captured = |alpha: f64| {
        reference
            .trace(direction_off_centre(alpha) * DVec3::new(1.0, 1.0, side))
            .outcome
            == Outcome::Captured
    };
    let (mut low, mut high) = (0.0, 0.0);
    while captured(high) {
        (low, high) = (high, 1.3 * high + 1e-4);
    }
    bisect(low, high, captured)
}

/// Spin, camera.r and camera.theta_deg; the first place is deep in the ergosphere.
const PLACES: [(f64, f64, f64); 9] = [
    (0.9, 0.8, 80.0),
    (0.0, 20.0, 80.0),
    (0.5, 2.0, 10.0),
    (0.9, 5.0, 60.0),
    (-0.9, 20.0, 89.0),
    (0.998, 2.0, 0.0),
    (0.998, 1000.0, 60.0),
    (0.9999, 5.0, 90.0),
    (-0.9999, 20.0, 75.0),
];

#[test]
#[ignore = "needs a graphics adapter"]
fn every_ray_ends_as_in_the_reference_and_every_number_is_finite() {
    let gpu = gpu();
    for (spin, r, theta) in PLACES {
        let scene = spinning_hole(spin, r, theta);
        let reference = Reference::new(&scene).unwrap();
        // Both sides of the shadow's edge, at 3e-6 rad and more: at the default setting the method
        // must be right from 2e-6 rad on.
        let beside = [-1.0, 1.0].into_iter().flat_map(|side| {
            let edge = edge(&reference, side);
            (0..40).map(move |i| {
                let distance = 3e-6 * 1.3_f64.powi(i / 2) * if i % 2 == 0 { 1.0 } else { -1.0 };
                direction_off_centre(edge + distance) * DVec3::new(1.0, 1.0, side)
            })
        });
        let directions: Vec<DVec3> = spiral(400)
            .into_iter()
            .chain(beside.filter(|d| d.x < 0.0))
            .collect();
        for (direction, record) in directions
            .iter()
            .zip(rays::records(gpu, &scene, &directions).unwrap())
        {
            let expected = reference.trace(*direction);
            let found = record.trace(None);
            assert_eq!(
                found.outcome, expected.outcome,
                "spin {spin}, r {r}, theta {theta}, {direction}"
            );
            let finite = record.sky.is_finite() && record.residual.is_finite();
            assert!(
                finite
                    && record
                        .hits
                        .iter()
                        .all(|hit| hit.position.is_finite() && hit.g.is_finite())
            );
        }
    }
}

/// Rays on both sides of the shadow's edge, at 1e-5 of its radius, end on the right side at the
/// default setting, however small the shadow is. tests/physics compares the reference's edge with
/// published values.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_shadow_has_its_size_to_five_digits() {
    let gpu = gpu();
    for (spin, r, theta) in [
        (0.5, 20.0, 90.0),
        (0.9, 1000.0, 60.0),
        (0.998, 1000.0, 17.0),
        (-0.94, 100.0, 89.0),
    ] {
        let scene = spinning_hole(spin, r, theta);
        let reference = Reference::new(&scene).unwrap();
        for side in [-1.0, 1.0] {
            let edge = edge(&reference, side);
            let at = |alpha: f64| direction_off_centre(alpha) * DVec3::new(1.0, 1.0, side);
            let pair = [at(edge * (1.0 - 1e-5)), at(edge * (1.0 + 1e-5))];
            let found: Vec<Outcome> = rays::trace(gpu, &scene, &pair)
                .unwrap()
                .iter()
                .map(|ray| ray.outcome)
                .collect();
            assert_eq!(
                found,
                [Outcome::Captured, Outcome::Sky],
                "spin {spin}, r {r}, theta {theta}, side {side}"
            );
        }
    }
}

/// Away from the shadow's edge a ray's error is f32's rounding, about 1e-7 rad, amplified along a
/// ray that turns by about pi; at the tightest setting the error of the steps is smaller. Measured:
/// medians of 1e-7 to 5e-7, and 1.2e-6 in the ergosphere, where small rotations of a ray are large
/// on the sky.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_sky_and_the_hits_agree_with_the_reference() {
    let mut with_hits = 0;
    for (spin, r, theta) in PLACES {
        let mut scene = spinning_hole(spin, r, theta);
        scene.quality.max_error_px = 1e-4;
        let directions = spiral(1000);
        let (mut sky, mut radius, mut g, mut azimuth) = (vec![], vec![], vec![], vec![]);
        for (found, expected) in with_truths(&scene, &directions) {
            if let (Some(found), Some(expected)) = (found.sky, expected.sky) {
                sky.push((found - expected).length());
            }
            for (found, expected) in found.hits.iter().zip(expected.hits) {
                let (Some(found), Some(expected)) = (found, expected) else {
                    continue;
                };
                radius.push((found.r / expected.r - 1.0).abs());
                g.push((found.g / expected.g - 1.0).abs());
                azimuth.push((found.phi - expected.phi).sin().abs());
            }
        }
        let place = format!("spin {spin}, r {r}, theta {theta}");
        assert!(
            median(&sky) < 2e-6 && quantile(&sky, 0.9) < 2e-5,
            "{place}: sky {:e}",
            median(&sky)
        );
        if radius.len() > 50 {
            with_hits += 1;
            for (what, errors) in [("r", &radius), ("g", &g), ("phi", &azimuth)] {
                assert!(
                    median(errors) < 3e-6,
                    "{place}: {what} {:e}",
                    median(errors)
                );
            }
        }
    }
    assert!(2 * with_hits > PLACES.len(), "{with_hits} places with hits");
}

/// The step is limited by the shadow's edge at the default setting, by f32 at the tightest, and by
/// the pixel at the loosest.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_setting_with_a_smaller_error_takes_shorter_steps() {
    let gpu = gpu();
    let mut scene = spinning_hole(0.9, 20.0, 80.0);
    let directions = spiral(50);
    let mut steps_at = |max_error_px: f64| {
        scene.quality.max_error_px = max_error_px;
        rays::records(gpu, &scene, &directions)
            .unwrap()
            .iter()
            .map(|record| record.steps)
            .sum::<u32>()
    };
    let steps = [1.0, 0.05, 1e-4].map(&mut steps_at);
    // In proportion to the steps' lengths, 0.91, 0.53 and 0.25, except for the excess of a ray's
    // last step.
    assert!(
        10 * steps[1] > 13 * steps[0],
        "{steps:?} steps, from the loosest setting to the tightest"
    );
    assert!(
        10 * steps[2] > 15 * steps[1],
        "{steps:?} steps, from the loosest setting to the tightest"
    );
}

/// The error of a picture's rays, in pixels, is at most what the setting allows.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_error_of_a_picture_is_within_the_setting() {
    let gpu = gpu();
    let mut scene = spinning_hole(0.9, 20.0, 80.0);
    let reference = Reference::new(&scene).unwrap();
    let directions: Vec<DVec3> = pixel_directions(&scene, 64, 36)
        .iter()
        .map(|d| d.as_vec3().as_dvec3())
        .collect();
    let truths: Vec<Trace> = directions
        .iter()
        .map(|direction| reference.trace(*direction))
        .collect();
    let pixel =
        2.0 * (scene.camera.fov_deg.to_radians() / 2.0).tan() / f64::from(scene.picture.height);
    for max_error_px in [0.05, 1.0] {
        scene.quality.max_error_px = max_error_px;
        let found = rays::trace(gpu, &scene, &directions).unwrap();
        let skies = truths
            .iter()
            .zip(&found)
            .filter_map(|(truth, found)| truth.sky.zip(found.sky));
        let errors: Vec<f64> = skies
            .map(|(truth, found)| (found - truth).length())
            .collect();
        let worst = quantile(&errors, 0.95) / pixel;
        println!("{max_error_px} px: {worst:e}");
        assert!(
            worst < max_error_px,
            "{worst:e} pixels where {max_error_px} are allowed"
        );
    }
}
