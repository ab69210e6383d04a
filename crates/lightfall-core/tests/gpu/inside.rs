//! A camera inside the horizon: the shaders against the reference, and the refusals.

use crate::{all_around, bare_hole, gpu, median, quantile};
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::gpu::{Gpu, GpuScene, rays};
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{Method, ObserverKind, Scene};

fn fallen(method: Method, r: f64, velocity: [f64; 3]) -> Scene {
    let mut scene = Scene {
        method,
        ..bare_hole(r)
    };
    scene.disk.enabled = true;
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, velocity);
    scene
}

/// The differences between the GPU's answers and the reference's.
#[derive(Default)]
struct Differences {
    sky: Vec<f64>,
    /// Of the sky, divided by the sky's movement per rotation of the ray: the rotation that
    /// explains them.
    turns: Vec<f64>,
    hits: Vec<f64>,
    azimuths: Vec<f64>,
    outcomes: u32,
    hits_seen: [u32; 2],
}

impl Differences {
    fn add(&mut self, gpu: &Gpu, scene: &Scene, directions: &[DVec3]) {
        let reference = Reference::new(scene).unwrap();
        for (direction, trace) in directions
            .iter()
            .zip(rays::trace(gpu, scene, directions).unwrap())
        {
            let truth = reference.trace(*direction);
            self.outcomes += u32::from(trace.outcome != truth.outcome);
            if let (Some(sky), Some(true_sky)) = (trace.sky, truth.sky) {
                let off = (sky - true_sky).length();
                let (x, y) = direction.any_orthonormal_pair();
                let moved = |across: DVec3| {
                    reference
                        .trace(*direction + 1e-6 * across)
                        .sky
                        .map(|sky| sky - true_sky)
                };
                // Next to the edge of the visible region a small rotation explains any difference.
                let stretch = [x, y].map(|across| {
                    moved(across).map_or(f64::INFINITY, |moved| moved.length() / 1e-6)
                });
                self.sky.push(off);
                self.turns.push(off / (1.0 + stretch[0].hypot(stretch[1])));
            }
            for (hit, truth) in trace.hits.into_iter().zip(truth.hits) {
                if let (Some(hit), Some(truth)) = (hit, truth) {
                    self.hits.push(
                        (hit.g / truth.g - 1.0)
                            .abs()
                            .max((hit.r / truth.r - 1.0).abs()),
                    );
                    self.azimuths
                        .push(2.0 * (0.5 * (hit.phi - truth.phi)).sin().abs());
                }
                self.hits_seen[0] += u32::from(hit.is_some());
                self.hits_seen[1] += u32::from(truth.is_some());
            }
        }
    }
}

const VELOCITIES: [[f64; 3]; 3] = [[0.0; 3], [-0.2, 0.5, 0.3], [0.6, 0.0, -0.6]];

#[test]
#[ignore = "needs a graphics adapter"]
fn inside_the_horizon_the_sky_and_the_disk_are_where_the_reference_has_them() {
    let gpu = gpu();
    let directions = all_around(4000);
    for (method, r) in [1.0, 0.999, 0.7, 0.3, 0.1]
        .into_iter()
        .flat_map(|r| [(Method::Auto, r), (Method::Mino, r)])
    {
        for velocity in VELOCITIES {
            let mut off = Differences::default();
            off.add(gpu, &fallen(method, r, velocity), &directions);
            let place = format!("{method:?}, {velocity:?} at {r}");
            let Differences {
                sky,
                hits,
                outcomes,
                hits_seen: [seen, there],
                ..
            } = off;
            // f32's rounding, times what lensing stretches it by where the ray circles the hole
            // first.
            assert!(
                median(&sky) < 5e-7 && quantile(&sky, 0.99) < 3e-5,
                "{place}: sky {:e}",
                quantile(&sky, 0.99)
            );
            assert!(
                median(&hits) < 2e-5 && quantile(&hits, 0.99) < 3e-4,
                "{place}: hits {:e}",
                quantile(&hits, 0.99)
            );
            assert!(
                outcomes <= 1 && seen.abs_diff(there) <= 1,
                "{place}: {outcomes} outcomes, hits {seen}, {there}"
            );
            assert!(sky.len() > 900, "{place}: {} rays to the sky", sky.len());
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn inside_a_spinning_hole_the_sky_and_the_disk_are_where_the_reference_has_them() {
    let gpu = gpu();
    let directions = all_around(600);
    for spin in [0.1, 0.9, -0.9, 0.998, 0.9999] {
        let (horizon, end) = (Kerr { spin }.horizon(), min_infall_radius(Kerr { spin }));
        let mut all = Differences::default();
        for depth in [0.0, 1e-3, 0.5, 1.0] {
            for velocity in VELOCITIES {
                let r = horizon - depth * (horizon - end);
                let mut scene = fallen(Method::Auto, r, velocity);
                scene.hole.spin = spin;
                let mut off = Differences::default();
                off.add(gpu, &scene, &directions);
                let (place, [seen, there]) =
                    (format!("spin {spin}, {velocity:?} at {r}"), off.hits_seen);
                let [middle, most] = [0.5, 0.99].map(|share| quantile(&off.turns, share));
                assert!(
                    middle < 2e-7 && most < 4e-6,
                    "{place}: turns {middle:e}, {most:e}"
                );
                // An observer that is thrown outward against the hole's rotation sees the sky on a
                // fifth of its own sky. There f32's rounding of the direction is four times as
                // large on the sky, and more rays are next to the shadow's edge.
                if off.sky.len() > directions.len() / 2 {
                    let [middle, most] = [0.5, 0.99].map(|share| quantile(&off.sky, share));
                    assert!(
                        middle < 5e-7 && most < 3e-5,
                        "{place}: sky {middle:e}, {most:e}"
                    );
                }
                assert!(
                    off.outcomes <= 1 && seen.abs_diff(there) <= 1,
                    "{place}: {} outcomes",
                    off.outcomes
                );
                assert!(
                    off.sky.len() > 54,
                    "{place}: {} rays to the sky",
                    off.sky.len()
                );
                all.hits.extend(off.hits);
                all.azimuths.extend(off.azimuths);
            }
        }
        let [middle, most] = [0.5, 0.99].map(|share| quantile(&all.hits, share));
        let azimuth = [0.5, 0.99].map(|share| quantile(&all.azimuths, share));
        println!(
            "{spin}: {} hits, {middle:e} {most:e}, azimuths {azimuth:?}",
            all.hits.len()
        );
        assert!(
            all.hits.len() > 90 && middle < 1e-5 && most < 3e-4,
            "spin {spin}: hits {middle:e}, {most:e}"
        );
        assert!(
            azimuth[0] < 2e-6 && azimuth[1] < 3e-4,
            "spin {spin}: azimuths {azimuth:?}"
        );
    }
}

#[test]
fn methods_observers_and_effects_that_need_an_outside_are_refused_inside() {
    let refused = |scene: &Scene| GpuScene::for_rays(scene).unwrap_err().to_string();
    for method in [Method::Verlet, Method::KerrSchild] {
        assert!(
            refused(&fallen(method, 0.7, [0.0; 3]))
                .starts_with("camera.r = 0.7 is refused: it is inside the horizon")
        );
    }
    let mut spinning = fallen(Method::KerrSchild, 0.7, [0.0; 3]);
    spinning.hole.spin = 0.9;
    assert!(
        refused(&spinning).starts_with("camera.r = 0.7 is refused"),
        "{}",
        refused(&spinning)
    );
    spinning.method = Method::Auto;
    assert!(GpuScene::for_rays(&spinning).is_ok());
    spinning.camera.r = Kerr { spin: 0.9 }.inner_horizon();
    assert!(
        refused(&spinning).contains("the inner horizon"),
        "{}",
        refused(&spinning)
    );
    let mut parted = fallen(Method::Auto, 0.7, [0.0; 3]);
    parted.effects.doppler = false;
    assert!(refused(&parted).starts_with(
        "camera.r is 0.7; it must be greater than 1.000000, the horizon, where effects."
    ));
    assert!(Reference::new(&parted).is_err());
    parted.effects.doppler = true;
    parted.effects.beaming = false;
    assert!(GpuScene::for_rays(&parted).is_ok());
}
