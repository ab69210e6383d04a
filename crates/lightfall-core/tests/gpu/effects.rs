//! Effects switched off one by one, compared with their formulas in f64.

use crate::{bare_hole, gpu, pixel_directions, quantile, with_truths};
use lightfall_core::gpu::rays;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{Effects, Method, ObserverKind, Scene};

/// A camera that moves, above the disk.
fn moving(r: f64) -> Scene {
    let mut scene = Scene {
        method: Method::Closed,
        ..bare_hole(r)
    };
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, [0.1, 0.2, -0.3]);
    scene.disk.enabled = true;
    scene
}

fn without(switch: fn(&mut Effects)) -> Effects {
    let mut effects = Effects::default();
    switch(&mut effects);
    effects
}

#[test]
#[ignore = "needs a graphics adapter"]
fn every_combination_of_effects_agrees_with_the_formulas_in_f64() {
    for (switched, (method, spin)) in
        (0..32_u32).flat_map(|set| [(set, (Method::Closed, 0.0)), (set, (Method::Mino, 0.9))])
    {
        let [lensing, doppler, beaming, gravitational_shift, aberration] =
            std::array::from_fn(|effect| switched >> effect & 1 == 0);
        let mut scene = moving(8.0);
        (scene.method, scene.hole.spin, scene.quality.max_error_px) = (method, spin, 1e-3);
        scene.effects = Effects {
            lensing,
            doppler,
            beaming,
            gravitational_shift,
            aberration,
        };
        let directions = pixel_directions(&scene, 32, 18);
        let (mut g, mut differing, mut sky) = (Vec::new(), 0, Vec::new());
        for (found, truth) in with_truths(&scene, &directions) {
            if found.outcome != truth.outcome
                || found.hits.map(|hit| hit.is_some()) != truth.hits.map(|hit| hit.is_some())
            {
                differing += 1;
                continue;
            }
            g.extend(
                found
                    .hits
                    .iter()
                    .zip(truth.hits)
                    .filter_map(|(found, truth)| {
                        let (found, truth) = ((*found)?, truth?);
                        Some(
                            (found.g / truth.g - 1.0)
                                .abs()
                                .max((found.r / truth.r - 1.0).abs()),
                        )
                    }),
            );
            sky.extend(
                found
                    .sky
                    .zip(truth.sky)
                    .map(|(found, truth)| (found - truth).length()),
            );
        }
        // f32's rounding, stretched where the ray passes near the critical curve or meets the disk
        // at a small angle.
        assert!(
            g.len() > 50 && sky.len() > 50,
            "{:?}: {} hits, {} of the sky",
            scene.effects,
            g.len(),
            sky.len()
        );
        assert!(
            quantile(&g, 0.95) < 1e-5,
            "{spin} {:?}: {:e}",
            scene.effects,
            quantile(&g, 0.95)
        );
        assert!(
            quantile(&sky, 0.95) < 1e-5,
            "{spin} {:?}: {:e}",
            scene.effects,
            quantile(&sky, 0.95)
        );
        assert!(
            differing <= 2,
            "{:?}: {differing} rays differ in kind",
            scene.effects
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn straight_rays_are_straight() {
    let mut scene = moving(8.0);
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Static, [0.0; 3]);
    scene.effects = without(|effects| effects.lensing = false);
    let directions = pixel_directions(&scene, 96, 54);
    let found = rays::trace(gpu(), &scene, &directions).unwrap();
    let start = scene.camera.r * scene.camera.direction();
    let (mut captured, mut hits) = (0, 0);
    for (found, direction) in found.iter().zip(&directions) {
        let straight = scene.camera.tetrad() * *direction;
        let passes = start.cross(straight).length();
        if (passes - 1.0).abs() > 1e-5 {
            assert_eq!(
                found.outcome == Outcome::Captured,
                passes < 1.0,
                "{direction}"
            );
        }
        captured += usize::from(found.outcome == Outcome::Captured);
        if let Some(sky) = found.sky {
            // f32's rounding of a unit vector, a few times.
            assert!((sky - straight).length() < 5e-7, "{direction}: {sky}");
        }
        if let Some(hit) = found.hits[0] {
            let place = start - start.z / straight.z * straight;
            // f32's rounding of the place, stretched by the small angle between ray and plane.
            assert!(
                (hit.r - place.length()).abs() < 1e-6 * scene.camera.r / straight.z.abs(),
                "{hit:?}, {place}"
            );
            hits += 1;
        }
    }
    // The shares of the picture that the ball and the annulus cover.
    assert!(
        captured > 30 && hits > 500,
        "{captured} captured, {hits} hits"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn g_is_one_without_any_shift() {
    let gpu = gpu();
    let mut scene = moving(8.0);
    scene.effects =
        without(|effects| (effects.doppler, effects.gravitational_shift) = (false, false));
    let traces = rays::trace(gpu, &scene, &pixel_directions(&scene, 48, 27)).unwrap();
    let shifts: Vec<f64> = traces
        .iter()
        .flat_map(|trace| trace.hits)
        .flatten()
        .map(|hit| hit.g)
        .collect();
    assert!(shifts.len() > 100 && shifts.iter().all(|g| *g == 1.0));
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_product_of_the_two_shifts_is_the_whole_shift() {
    let gpu = gpu();
    let shifts = |effects| {
        let scene = Scene {
            effects,
            ..moving(8.0)
        };
        let traces = rays::trace(gpu, &scene, &pixel_directions(&scene, 48, 27)).unwrap();
        traces
            .iter()
            .flat_map(|trace| trace.hits)
            .flatten()
            .map(|hit| hit.g)
            .collect::<Vec<_>>()
    };
    let whole = shifts(Effects::default());
    let motion = shifts(without(|effects| effects.gravitational_shift = false));
    let gravity = shifts(without(|effects| effects.doppler = false));
    assert_eq!((whole.len(), whole.len()), (motion.len(), gravity.len()));
    for ((whole, motion), gravity) in whole.iter().zip(motion).zip(gravity) {
        // Three roundings of f32.
        assert!(
            (motion * gravity / whole - 1.0).abs() < 4e-7,
            "{motion} {gravity} {whole}"
        );
        // The matter is between 3 and 11 r_s, and the camera is at 8 r_s.
        assert!((0.8..1.1).contains(&gravity), "{gravity}");
    }
}
