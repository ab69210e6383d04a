//! Diagnostic views against the records of the same rays.

use crate::ALONG;
use crate::light::light_from;
use crate::{edge_on, gpu, pixel_directions};
use glam::DVec3;
use lightfall_core::geometry::schwarzschild::shadow_half_angle_static;
use lightfall_core::gpu::kernel::uniform;
use lightfall_core::gpu::rays::{GpuTrace, records};
use lightfall_core::gpu::{Gpu, GpuScene, Variant, bindings};
use lightfall_core::scene::{Method, Scene, View};
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// The light of the picture's own shader in these directions on the observer's axes.
fn shown(gpu: &Gpu, scene: &Scene, directions: &[DVec3]) -> Vec<[u32; 3]> {
    let source = Variant::picture(scene).source();
    let numbers = GpuScene::for_rays(scene).unwrap();
    let given = directions
        .iter()
        .map(|direction| direction.as_vec3().extend(0.0));
    let lights = light_from(
        gpu,
        &source,
        ALONG,
        &[(bindings::SCENE, uniform(&numbers))],
        given,
    );
    lights
        .iter()
        .map(|light| light.truncate().to_array().map(f32::to_bits))
        .collect()
}

/// The view of the edge-on preset, or of the article's method with so few steps that some rays get
/// no answer.
fn views_of(method: Method, max_steps: u32) -> Scene {
    let mut scene = Scene {
        method,
        ..edge_on()
    };
    scene.quality.max_steps = max_steps;
    scene
}

/// Asserts that each kind has one colour and each colour one kind, and returns their number.
fn one_to_one<K: Ord + Copy>(colours: &[[u32; 3]], kinds: &[K]) -> usize {
    let pairs: BTreeSet<(K, [u32; 3])> =
        kinds.iter().copied().zip(colours.iter().copied()).collect();
    let by_kind: BTreeMap<K, [u32; 3]> = pairs.iter().copied().collect();
    let by_colour: BTreeMap<[u32; 3], K> = pairs
        .iter()
        .map(|(kind, colour)| (*colour, *kind))
        .collect();
    assert_eq!((by_kind.len(), by_colour.len()), (pairs.len(), pairs.len()));
    pairs.len()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn every_ray_class_has_a_colour_of_its_own() {
    let gpu = gpu();
    let mut seen = BTreeSet::new();
    for (method, max_steps) in [(Method::Closed, 768), (Method::Verlet, 60)] {
        let scene = Scene {
            view: View::Classes,
            ..views_of(method, max_steps)
        };
        let directions = pixel_directions(&scene, 192, 108);
        let class = |record: &GpuTrace| (record.outcome, record.hit_count);
        let classes: Vec<(u32, u32)> = records(gpu, &scene, &directions)
            .unwrap()
            .iter()
            .map(class)
            .collect();
        // Equal bits, because the same shader traces the same rays.
        let count = one_to_one(&shown(gpu, &scene, &directions), &classes);
        seen.extend(classes);
        assert!(count >= 5, "{method:?}: {count} classes");
    }
    let outcomes: BTreeSet<u32> = seen.iter().map(|class| class.0).collect();
    assert_eq!(
        outcomes.len(),
        3,
        "some outcome was not put to the test: {seen:?}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn each_order_has_a_colour_and_the_sky_differs_from_the_disk() {
    let gpu = gpu();
    let scene = Scene {
        view: View::Order,
        ..views_of(Method::Closed, 768)
    };
    // A fan of rays across the shadow's edge, denser near the edge, so that some hit the thin
    // images of high order.
    let edge = shadow_half_angle_static(20.0);
    let fan: Vec<DVec3> = (0..3000)
        .flat_map(|i| {
            let alpha = edge + 0.4 * (-f64::from(i) * 0.005).exp();
            [0.3_f64, 1.2, -1.2].map(|turn| {
                DVec3::new(
                    -alpha.cos(),
                    alpha.sin() * turn.sin(),
                    alpha.sin() * turn.cos(),
                )
            })
        })
        .collect();
    let traces = records(gpu, &scene, &fan).unwrap();
    let kind = |record: &GpuTrace| {
        let seen = record.hit_count > 0;
        let order = ((f64::from(record.turn) - 1e-5) / PI).floor();
        if record.outcome != 0 && !seen {
            (9, false)
        } else {
            (order.clamp(0.0, 3.0) as u32, seen)
        }
    };
    let kinds: Vec<(u32, bool)> = traces.iter().map(kind).collect();
    // Orders 0, 1, 2 and more, of the disk and of the sky.
    assert!(
        one_to_one(&shown(gpu, &scene, &fan), &kinds) >= 6,
        "{:?}",
        kinds.iter().collect::<BTreeSet<_>>()
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_methods_agree_on_the_angle_that_a_ray_sweeps() {
    let gpu = gpu();
    let mut scene = views_of(Method::Closed, 768);
    let directions = pixel_directions(&scene, 64, 36);
    let closed = records(gpu, &scene, &directions).unwrap();
    let kind = |record: &GpuTrace| (record.outcome, record.hit_count);
    for method in [Method::Verlet, Method::Mino, Method::KerrSchild] {
        (scene.method, scene.quality.step_scale) = (method, 0.3);
        let others = records(gpu, &scene, &directions).unwrap();
        let both: Vec<f32> = closed
            .iter()
            .zip(&others)
            .filter(|(closed, other)| kind(closed) == kind(other))
            .map(|(closed, other)| (closed.turn - other.turn).abs())
            .collect();
        assert!(
            both.len() > 2000,
            "{method:?}: {} rays of 2304 are of one kind",
            both.len()
        );
        let far = both.iter().filter(|difference| **difference > 0.01).count();
        // The methods' own errors, which grow without bound toward the shadow's edge; half-turns
        // are 3.14.
        assert!(
            far < 30,
            "{method:?}: {far} rays differ by more than 0.01 rad"
        );
    }
    // Without a disk the angle is that to the sky: rotated by it within its plane, the camera's
    // direction is that of the ray's end.
    scene.disk.enabled = false;
    scene.method = Method::Closed;
    for (record, direction) in records(gpu, &scene, &directions)
        .unwrap()
        .iter()
        .zip(&directions)
    {
        if record.outcome == 0 {
            let n = scene.camera.direction();
            let ends = (scene.camera.tetrad() * *direction)
                .reject_from_normalized(n)
                .normalize_or_zero();
            let turn = f64::from(record.turn);
            let sky = turn.cos() * n + turn.sin() * ends;
            // f32's rounding of the angle and of the direction.
            assert!(
                (sky - record.sky.as_dvec3()).length() < 5e-6,
                "{direction}: {turn}"
            );
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_redshift_view_is_blue_above_one_and_red_below() {
    let gpu = gpu();
    let scene = Scene {
        view: View::Redshift,
        ..views_of(Method::Closed, 768)
    };
    let directions = pixel_directions(&scene, 96, 54);
    let (mut blue, mut red) = (0, 0);
    for (light, record) in shown(gpu, &scene, &directions)
        .iter()
        .zip(records(gpu, &scene, &directions).unwrap())
    {
        let [r, _, b] = light.map(f32::from_bits);
        if record.hit_count > 0 && (record.hits[0].g - 1.0).abs() > 0.01 {
            assert_eq!(b > r, record.hits[0].g > 1.0, "{record:?}");
            if b > r { blue += 1 } else { red += 1 }
        }
    }
    assert!(blue > 100 && red > 100, "{blue} blue, {red} red");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_residual_view_is_black_for_a_method_without_steps_and_brighter_for_longer_steps() {
    let gpu = gpu();
    let brightness = |method, step_scale| {
        let mut scene = Scene {
            view: View::Residual,
            ..views_of(method, 768)
        };
        scene.quality.step_scale = step_scale;
        let directions = pixel_directions(&scene, 48, 27);
        let lights = shown(gpu, &scene, &directions);
        lights
            .iter()
            .flatten()
            .map(|bits| f64::from(f32::from_bits(*bits)))
            .sum::<f64>()
    };
    assert_eq!(brightness(Method::Closed, 0.85), 0.0);
    let (fine, coarse) = (
        brightness(Method::Verlet, 0.45),
        brightness(Method::Verlet, 1.55),
    );
    assert!(
        fine > 0.0 && coarse > 1.1 * fine,
        "fine {fine}, coarse {coarse}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_steps_view_is_lighter_for_more_steps_and_black_for_a_method_without_steps() {
    let gpu = gpu();
    for (method, max_steps) in [
        (Method::Verlet, 768),
        (Method::Verlet, 60),
        (Method::Mino, 768),
    ] {
        let scene = Scene {
            view: View::Steps,
            ..views_of(method, max_steps)
        };
        let directions = pixel_directions(&scene, 192, 108);
        let lights = shown(gpu, &scene, &directions);
        let traces = records(gpu, &scene, &directions).unwrap();
        // Light by the number of steps, of the rays that end within the scale.
        let mut by_steps = BTreeMap::new();
        let mut magenta = BTreeSet::new();
        for (light, trace) in lights.iter().zip(&traces) {
            if trace.outcome == 2 {
                magenta.insert(*light);
            } else if (4..=256).contains(&trace.steps) {
                let [r, g, b] = light.map(f32::from_bits);
                let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
                let other = by_steps.insert(trace.steps, luminance);
                // The same shader makes the same colour of the same number.
                assert!(other.is_none_or(|other| other == luminance));
            }
        }
        assert_eq!(!magenta.is_empty(), max_steps == 60, "{method:?}");
        assert!(magenta.len() <= 1, "{method:?}");
        let luminances: Vec<f32> = by_steps.values().copied().collect();
        assert!(
            luminances.len() > 8,
            "{method:?}: {} numbers of steps",
            luminances.len()
        );
        assert!(
            luminances.is_sorted_by(|a, b| a < b),
            "{method:?}: {by_steps:?}"
        );
    }
    let scene = Scene {
        view: View::Steps,
        ..views_of(Method::Closed, 768)
    };
    let directions = pixel_directions(&scene, 48, 27);
    assert!(
        shown(gpu, &scene, &directions)
            .iter()
            .flatten()
            .all(|bits| *bits == 0)
    );
}
