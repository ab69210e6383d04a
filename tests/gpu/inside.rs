//! A camera that has fallen in: the shaders against the reference, and what is refused there.

use crate::{bare_hole, gpu, median, quantile};
use glam::DVec3;
use lightfall::gpu::{GpuScene, rays};
use lightfall::physics::reference::Reference;
use lightfall::scene::{Method, ObserverKind, Scene};

fn fallen(method: Method, r: f64, velocity: [f64; 3]) -> Scene {
    let mut scene = Scene { method, ..bare_hole(r) };
    scene.disk.enabled = true;
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, velocity);
    scene
}

/// Directions spread evenly over the sphere (a golden spiral).
fn all_around(count: u32) -> Vec<DVec3> {
    let turn = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let at = |i: u32| {
        let x = 1.0 - f64::from(2 * i + 1) / f64::from(count);
        let (sin, cos) = (turn * f64::from(i)).sin_cos();
        DVec3::new(x, (1.0 - x * x).sqrt() * cos, (1.0 - x * x).sqrt() * sin)
    };
    (0..count).map(at).collect()
}

#[test]
fn inside_the_horizon_the_sky_and_the_disk_are_where_the_reference_has_them() {
    let Some(gpu) = gpu() else { return };
    let directions = all_around(4000);
    for r in [1.0, 0.999, 0.7, 0.3, 0.1] {
        for velocity in [[0.0; 3], [-0.2, 0.5, 0.3], [0.6, 0.0, -0.6]] {
            let scene = fallen(Method::Auto, r, velocity);
            let reference = Reference::new(&scene).unwrap();
            let (mut sky, mut hits, mut seen, mut differing) = (Vec::new(), Vec::new(), [0, 0], 0);
            for (direction, trace) in directions.iter().zip(rays::trace(gpu, &scene, &directions).unwrap()) {
                let truth = reference.trace(*direction);
                differing += u32::from(trace.outcome != truth.outcome);
                sky.extend(trace.sky.zip(truth.sky).map(|(sky, truth)| (sky - truth).length()));
                for (hit, truth) in trace.hits.into_iter().zip(truth.hits) {
                    let both = hit.zip(truth);
                    hits.extend(
                        both.map(|(hit, truth)| (hit.g / truth.g - 1.0).abs().max((hit.r / truth.r - 1.0).abs())),
                    );
                    seen = [seen[0] + u32::from(hit.is_some()), seen[1] + u32::from(truth.is_some())];
                }
            }
            let place = format!("{velocity:?} at {r}");
            // f32's rounding, times what lensing stretches it by where the ray circles the hole first.
            assert!(median(&sky) < 5e-7 && quantile(&sky, 0.99) < 1e-5, "{place}: sky {:e}", quantile(&sky, 0.99));
            assert!(median(&hits) < 2e-5 && quantile(&hits, 0.99) < 3e-4, "{place}: hits {:e}", quantile(&hits, 0.99));
            assert!(differing <= 1 && seen[0].abs_diff(seen[1]) <= 1, "{place}: {differing} outcomes, hits {seen:?}");
            assert!(sky.len() > 900, "{place}: {} rays to the sky", sky.len());
        }
    }
}

#[test]
fn what_needs_an_outside_is_refused_inside() {
    let refused = |scene: &Scene| GpuScene::for_rays(scene).unwrap_err().to_string();
    for method in [Method::Verlet, Method::KerrSchild, Method::Mino] {
        assert!(
            refused(&fallen(method, 0.7, [0.0; 3])).starts_with("camera.r = 0.7 is refused: it is inside the horizon")
        );
    }
    let mut spinning = fallen(Method::Auto, 0.7, [0.0; 3]);
    spinning.hole.spin = 0.9;
    assert!(refused(&spinning).ends_with("holes without spin only"), "{}", refused(&spinning));
    let mut parted = fallen(Method::Auto, 0.7, [0.0; 3]);
    parted.effects.doppler = false;
    assert!(
        refused(&parted).starts_with("camera.r is 0.7; it must be greater than 1.000000, the horizon, where effects.")
    );
    assert!(Reference::new(&parted).is_err());
    parted.effects.doppler = true;
    parted.effects.beaming = false;
    assert!(GpuScene::for_rays(&parted).is_ok());
}
