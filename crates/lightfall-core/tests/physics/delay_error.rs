//! The errors of delays, split into what the hit's place explains and what it does not.

use glam::{DVec2, DVec3};
use lightfall_core::accuracy::TimedRay;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::Scene;

/// The angle by which rays are turned, in radians.
const TURN: f64 = 1e-6;

/// A delay that is wrong by this much, in r_s/c, is found out.
const WRONG: f64 = 1e-3;

/// Every sixteenth pixel's ray, and the same turned in one of two directions.
fn pairs(scene: &Scene) -> Vec<[DVec3; 2]> {
    let size = DVec2::new(960.0, 540.0);
    let axes = scene.camera.tetrad_from_camera();
    let pair = |i: u32| {
        let pixel = DVec2::new(f64::from(i % 60), f64::from(i / 60)) * 16.0 + 0.5;
        let direction = axes * scene.camera.looking(pixel, size).normalize();
        let (u, v) = direction.any_orthonormal_pair();
        let aside = if i.is_multiple_of(2) { u } else { v };
        [direction, (direction + TURN * aside).normalize()]
    };
    (0..60 * 34).map(pair).collect()
}

#[test]
fn a_turned_rays_delay_is_that_of_its_place_and_a_wrong_delay_is_not() {
    for spin in [0.0, 0.9, -0.9] {
        let mut scene = Scene::default();
        scene.hole.spin = spin;
        (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, 80.0, 50.0);
        (scene.disk.follow_isco, scene.disk.outer) = (true, 11.0);
        let reference = Reference::new(&scene).unwrap();
        let (mut count, mut most) = (0, 0.0);
        for [direction, turned] in pairs(&scene) {
            let ray = TimedRay::of(&reference, direction);
            let mut other = reference.trace_with_lags(turned);
            for error in ray.errors(&other).into_iter().flatten() {
                // What remains is of second order: the two rays' constants differ by 2e-5, and p_r by
                // more where r almost turns. A wrong slope would leave about as much as the hit moves.
                let [dr, dphi] = error.moved();
                let bound = 1e-2 * dr.hypot(error.truth.r * dphi) + 1e-9;
                assert!(
                    error.at_place.abs() <= bound,
                    "{spin}, {direction}: {error:?}"
                );
                count += 1;
                most = f64::max(most, error.plain.abs());
            }
            for hit in other.hits.iter_mut().flatten() {
                hit.delay = hit.delay.map(|delay| delay + WRONG);
            }
            for error in ray.errors(&other).into_iter().flatten() {
                let found_out = (error.at_place - WRONG).abs() < 0.01 * WRONG;
                assert!(found_out, "{spin}, {direction}: {error:?}");
            }
        }
        assert!(count > 300 && most > 1e-5, "{spin}: {count} hits, {most:e}");
        println!("{spin}: {count} hits, delays differ by up to {most:e}");
    }
}
