//! The sky's stars and grid as functions of direction.

use crate::light::light_from;
use crate::{all_around, bare_hole, gpu};
use glam::{DVec3, UVec2};
use lightfall_core::gpu::kernel::{table_bytes, uniform};
use lightfall_core::gpu::{Gpu, GpuScene, Variant, bindings};
use lightfall_core::optics::spectrum::table;
use lightfall_core::scene::{Frame, Scene, SkyMode};
use std::f64::consts::TAU;

/// The footprint of a ray that stands for nothing but itself.
const ALONE: &str = "Footprint(vec3<f32>(0.0), vec3<f32>(0.0))";

/// The light of the sky in these directions, by a WGSL expression of `direction`.
fn light(gpu: &Gpu, scene: &Scene, expression: &str, directions: &[DVec3]) -> Vec<DVec3> {
    // A compute entry has no neighbouring rays, by which the picture's shader measures footprints.
    let source = Variant::timed_light(scene).source();
    // A uniform that no expression reads would not be bound; a grid without the star has no spectrum.
    let has_spectrum = source.contains("var<uniform> spectrum");
    let read = if has_spectrum {
        "scene.sky.spot_radius + spectrum[0].x"
    } else {
        "scene.sky.spot_radius"
    };
    let expression = expression.replace("direction", "given.xyz");
    let expression = format!("vec4<f32>({expression}, {read})");
    let numbers = GpuScene::new(scene, &Frame::of(scene).with_whole(UVec2::new(960, 540))).unwrap();
    let mut uniforms = vec![(bindings::SCENE, uniform(&numbers))];
    if has_spectrum {
        uniforms.push((bindings::SPECTRUM, table_bytes(&table())));
    }
    let given = directions
        .iter()
        .map(|direction| direction.as_vec3().extend(0.0));
    let lights = light_from(gpu, &source, &expression, &uniforms, given);
    lights
        .iter()
        .map(|light| light.truncate().as_dvec3())
        .collect()
}

fn sky(mode: SkyMode) -> Scene {
    let mut scene = bare_hole(20.0);
    scene.sky.mode = mode;
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn no_star_is_cut_off_where_charts_meet() {
    let gpu = gpu();
    // The twelve edges of the upright cube, and the eight corners where three charts meet, with the
    // widest images: g = 10.
    let mut seams = Vec::new();
    for i in 0..4000 {
        let t = -1.0 + f64::from(i) / 2000.0;
        for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            seams.extend(
                [
                    DVec3::new(a, b, t),
                    DVec3::new(t, a, b),
                    DVec3::new(b, t, a),
                ]
                .map(DVec3::normalize),
            );
        }
    }
    let layer = "star_layer(direction, 10.0, UPRIGHT, 0u)";
    let scene = sky(SkyMode::Procedural);
    assert!(
        light(gpu, &scene, layer, &seams)
            .iter()
            .all(|light| *light == DVec3::ZERO)
    );
    // The same layer shines elsewhere.
    assert!(
        light(gpu, &scene, layer, &all_around(60_000))
            .iter()
            .filter(|light| light.y > 0.0)
            .count()
            > 1000
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn stars_cover_the_sky_evenly_except_for_their_band() {
    let gpu = gpu();
    // Directions that see a star, layer by layer to distinguish the charts, with wide images: g =
    // 4.
    let directions = all_around(400_000);
    let pole = DVec3::new(2.0, 3.0, 6.0) / 7.0;
    let (mut near, mut far, mut middle, mut corner) = ([0.0; 2], [0.0; 2], [0.0; 2], [0.0; 2]);
    for (direction, light) in directions.iter().zip(light(
        gpu,
        &sky(SkyMode::Procedural),
        "star_layer(direction, 4.0, UPRIGHT, 0u)",
        &directions,
    )) {
        let lit = f64::from(u8::from(light.y > 0.0));
        let sine = direction.dot(pole).abs();
        let size = direction.abs();
        let mut counts = vec![if sine < 0.08 { &mut near } else { &mut far }];
        if sine > 0.4 && size.max_element() > 0.9 {
            counts.push(&mut middle);
        } else if sine > 0.4 && size.min_element() > 0.45 {
            counts.push(&mut corner);
        }
        for count in counts {
            count[0] += lit;
            count[1] += 1.0;
        }
    }
    let [near, far, middle, corner] = [near, far, middle, corner].map(|[lit, all]| lit / all);
    assert!(
        (1.3..2.2).contains(&(near / far)),
        "on the band {near}, off it {far}"
    );
    // A cell in a corner of a face is five times smaller than one in the middle, and five times
    // less likely to hold a star. With a few hundred stars each share is uncertain by a tenth.
    assert!(
        (0.65..1.5).contains(&(corner / middle)),
        "in the corners {corner}, in the middle {middle}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_stars_depend_only_on_the_seed() {
    let gpu = gpu();
    let directions = all_around(50_000);
    let stars = |seed: u32, change: fn(&mut Scene)| {
        let mut scene = sky(SkyMode::Procedural);
        scene.sky.seed = seed;
        change(&mut scene);
        light(
            gpu,
            &scene,
            &format!("sky_light(direction, 1.0, {ALONE})"),
            &directions,
        )
    };
    let one = stars(1, |_| ());
    assert_eq!(
        one,
        stars(1, |scene| (scene.camera.r, scene.camera.yaw_deg) =
            (7.0, 50.0))
    );
    let other = stars(2, |_| ());
    assert!(one.iter().zip(&other).filter(|(a, b)| a != b).count() > 500);
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_sky_is_finite_and_not_negative_for_any_shift() {
    let gpu = gpu();
    let directions = all_around(20_000);
    for mode in [SkyMode::Procedural, SkyMode::Grid] {
        let mut scene = sky(mode);
        (scene.sky.reference_star, scene.sky.brightness) = (true, 1e3);
        for shift in ["0.0", "1e-6", "1.0", "300.0", "1e6", "1e30"] {
            let lights = light(
                gpu,
                &scene,
                &format!("sky_light(direction, f32({shift}), {ALONE})"),
                &directions,
            );
            assert!(
                lights
                    .iter()
                    .all(|light| light.is_finite() && light.min_element() >= 0.0),
                "{mode:?}, g = {shift}"
            );
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn light_from_the_sky_grows_with_the_fourth_power_of_the_shift() {
    let gpu = gpu();
    let mut scene = sky(SkyMode::Grid);
    scene.sky.reference_star = true;
    let star = [DVec3::NEG_X];
    let at = |temperature: f64, g: f64| {
        light(
            gpu,
            &scene,
            &format!("thermal_colour({temperature:?} * {g:?})"),
            &star,
        )[0]
    };
    let seen = |g: f64| {
        light(
            gpu,
            &scene,
            &format!("sky_light(direction, {g:?}, {ALONE})"),
            &star,
        )[0]
    };
    let ratio = seen(1.5) / seen(1.0);
    let expected = at(8000.0, 1.5) / at(8000.0, 1.0) * 1.5_f64.powi(4);
    // A grid line crosses the star's centre and adds a few percent, with the same power.
    assert!(
        (ratio - expected).abs().max_element() < 0.15 * expected.max_element(),
        "{ratio} against {expected}"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_grid_has_its_lines_every_fifteen_degrees_and_keeps_its_width_to_the_poles() {
    let gpu = gpu();
    let scene = sky(SkyMode::Grid);
    let brightness = |points: &[(f64, f64)]| {
        let directions: Vec<DVec3> = points
            .iter()
            .map(|(theta, phi)| {
                let ((st, ct), (sp, cp)) =
                    (theta.to_radians().sin_cos(), phi.to_radians().sin_cos());
                DVec3::new(st * cp, st * sp, ct)
            })
            .collect();
        light(
            gpu,
            &scene,
            &format!("sky_background(direction, 1.0, {ALONE})"),
            &directions,
        )
        .iter()
        .map(|light| light.element_sum())
        .collect::<Vec<_>>()
    };
    // The sky between the lines is not black, so that the hole's shadow shows.
    let [fill] = brightness(&[(50.0, 7.0)])[..] else {
        unreachable!()
    };
    assert!(fill < 0.05, "{fill}");
    for k in 1..12 {
        let theta = 15.0 * f64::from(k);
        let [on, between] = brightness(&[(theta, 7.0), (theta + 7.5, 7.0)])[..] else {
            unreachable!()
        };
        assert!(
            on > fill + 0.2 && between == fill,
            "circle at {theta}: {on}, {between}"
        );
    }
    for k in -12..12 {
        let phi = 15.0 * f64::from(k);
        let [on, between] = brightness(&[(52.0, phi), (52.0, phi + 7.5)])[..] else {
            unreachable!()
        };
        assert!(
            on > fill + 0.2 && between == fill,
            "meridian at {phi}: {on}, {between}"
        );
    }
    // The lit share of a small circle is that of eight lines of constant width: it grows as
    // 1/sin(theta).
    let lit = |theta: f64| {
        let circle: Vec<(f64, f64)> = (0..20_000).map(|i| (theta, f64::from(i) * 0.018)).collect();
        brightness(&circle)
            .iter()
            .filter(|light| **light > fill)
            .count() as f64
            / 20_000.0
            * TAU
            * theta.to_radians().sin()
    };
    let (near, far) = (lit(3.0), lit(10.0));
    assert!(
        (near / far - 1.0).abs() < 0.03,
        "lit length {near} at 3 degrees, {far} at 10"
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn lines_of_the_grid_keep_their_light_however_a_lens_squeezes_them() {
    let scene = sky(SkyMode::Grid);
    // Across three circles, between two meridians: two common lines and a strong one, whose mean is
    // that of all.
    let count = 4000;
    let directions: Vec<DVec3> = (0..count)
        .map(|i| {
            let theta = (7.5 + 45.0 * (f64::from(i) + 0.5) / f64::from(count)).to_radians();
            let phi = 7.5_f64.to_radians();
            DVec3::new(
                theta.sin() * phi.cos(),
                theta.sin() * phi.sin(),
                theta.cos(),
            )
        })
        .collect();
    // The footprint is along theta only, so no meridian is widened.
    let seen = |footprint: f64| {
        let along = "vec3<f32>(direction.z * normalize(direction.xy), -length(direction.xy))";
        let footprint = format!("Footprint({along} * f32({footprint:?}), vec3<f32>(0.0))");
        light(
            gpu(),
            &scene,
            &format!("sky_background(direction, 1.0, {footprint}) - GRID_FILL"),
            &directions,
        )
    };
    let mean = |lights: &[DVec3]| lights.iter().sum::<DVec3>() / f64::from(count);
    let brightest = |lights: &[DVec3]| lights.iter().fold(0.0, |most, light| light.z.max(most));
    let narrow = seen(0.0);
    assert!(brightest(&narrow) > 0.35, "no line is met in its middle");
    let mut last = f64::INFINITY;
    for footprint in [0.01, 0.05, 0.12, 0.2, 1.0] {
        let lights = seen(footprint);
        // Some twenty directions across each narrow line: their mean is right to a percent.
        let ratio = mean(&lights) / mean(&narrow);
        assert!(
            (ratio - 1.0).abs().max_element() < 0.01,
            "{footprint}: {ratio}"
        );
        assert!(
            brightest(&lights) < last,
            "{footprint} does not fade the lines"
        );
        last = brightest(&lights);
    }
    // In the end there is nothing but the mean.
    let flat = seen(1.0);
    assert!(flat.iter().all(|light| light.distance(flat[0]) < 1e-6));
}
