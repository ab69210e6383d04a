//! The thorough search around a ray next to the edge of the shadow: answers that are wrong by a known
//! turn, or of a known class, are explained by it.

use super::{answers_to_turned_rays, scene};
use lightfall_core::accuracy::{Bounds, EDGE_DISTANCES, Truth, rays_near_edge};
use lightfall_core::optics::trace::{Outcome, Trace};
use lightfall_core::scene::{ObserverKind, Scene};

#[test]
fn the_thorough_search_finds_known_rotations_across_a_tiny_shadow() {
    // The shadow's radius is 1.8e-6 rad, thirty times the spacing of directions in f32.
    let mut scene = Scene::default();
    (scene.camera.r, scene.camera.theta_deg) = (276_779.5, 129.8);
    scene.camera.fov_deg = 0.006;
    scene.observer.kind = ObserverKind::Zamo;
    scene.observer.velocity = [0.0665, -0.9834, -0.0181];
    (scene.disk.inner, scene.disk.outer) = (33.9, 35.2);
    let rays = rays_near_edge(&scene, 500, [1e-7, 0.3]);
    let truth = Truth::of(&scene, rays).expect("a slow observer");
    let mut overstated = 0;
    for angle in [1e-8, 3e-8, 1e-7, 2e-7] {
        let given = answers_to_turned_rays(&scene, &truth, angle);
        for (i, error) in truth.judge(&given).iter().enumerate() {
            // Half of the tolerance of `closed`. The reference cannot tell less of the ray next to the
            // edge: a rounding of its f64 directions, 1e-16 rad, is magnified by the inverse of the
            // distance to the edge, down to 1e-10 rad.
            let limit = 5e-7;
            if error.backward <= limit {
                continue;
            }
            overstated += 1;
            let bounds = Bounds {
                enough: 0.5 * limit,
                known: error.backward,
            };
            let found = truth.surroundings(i, bounds).judge(&given[i], bounds);
            assert!(found <= limit, "ray {i}, {angle:e}: {found:e}, {error:?}");
        }
    }
    println!("{overstated} rays needed it");
    assert!(overstated > 0, "the usual search is enough for these rays");
}

#[test]
fn the_thorough_search_explains_an_answer_without_sky_and_hits() {
    let scene = scene(0.7);
    let rays = rays_near_edge(&scene, 400, EDGE_DISTANCES);
    let truth = Truth::of(&scene, rays).expect("a still observer");
    let is_wanted = |trace: &Trace| trace.outcome == Outcome::Captured && trace.hits[0].is_some();
    let hit: Vec<usize> = (0..truth.rays.len())
        .filter(|i| is_wanted(&truth.traces[*i]))
        .collect();
    let mut explained = 0;
    for i in hit {
        let given = Trace {
            hits: [None; 2],
            ..truth.traces[i]
        };
        let usual = truth.error_of(i, &given, 0.0);
        // The grid reaches a third of the shadow's radius, which is 0.2 rad.
        if usual > 0.06 {
            continue;
        }
        explained += 1;
        let bounds = Bounds {
            enough: usual / 4.0,
            known: f64::INFINITY,
        };
        let found = truth.surroundings(i, bounds).judge(&given, bounds);
        // The turns of the grid's rows lie a factor of two apart.
        let limit = 2.0 * usual;
        assert!(found <= limit, "ray {i}: {found:e}, usually {usual:e}");
    }
    assert!(explained > 30, "{explained} rays");
}
