//! The path of a ray, which the ray inspector shows, against independent integrals and closed
//! forms.

use crate::{assert_close, reference};
use glam::{DVec2, DVec3};
use lightfall_core::accuracy::Ray;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::path::Path;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{ObserverKind, Scene, presets};
use std::f64::consts::PI;

/// Directions across the picture of a scene, ten by six.
fn directions(scene: &Scene) -> Vec<DVec3> {
    let size = DVec2::new(960.0, 540.0);
    let place = |i: usize| {
        DVec2::new((i % 10) as f64 + 0.37, (i / 10) as f64 + 0.41) / DVec2::new(10.0, 6.0)
    };
    (0..60)
        .map(|i| scene.camera.tetrad_from_camera() * scene.camera.looking(place(i) * size, size))
        .collect()
}

fn presets() -> impl Iterator<Item = Scene> {
    presets::PRESETS
        .into_iter()
        .map(|preset| preset.scene(&[]).unwrap())
}

/// Integral of f from `a` to `b` by the midpoint rule in s with x = a + (b - a) s^2 (3 - 2 s). It
/// shares nothing with the code under test.
fn midpoints(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    const PARTS: usize = 400_000;
    let part = |i: usize| {
        let s = (i as f64 + 0.5) / PARTS as f64;
        f(a + (b - a) * s * s * (3.0 - 2.0 * s)) * 6.0 * s * (1.0 - s)
    };
    (0..PARTS).map(part).sum::<f64>() * (b - a) / PARTS as f64
}

#[test]
fn a_path_begins_at_the_camera_and_ends_where_its_trace_ends() {
    for scene in presets() {
        let reference = Reference::new(&scene).unwrap();
        let camera = scene.camera.direction() * scene.camera.r;
        let farthest = 3.0 * scene.camera.r + 60.0;
        for direction in directions(&scene) {
            let (trace, path) = Path::of(&reference, direction, farthest);
            let first = path.points[0];
            assert!(
                first.distance(camera) < 1e-9 * scene.camera.r,
                "{} starts at {first}",
                scene.name
            );
            assert!(
                path.points.iter().all(|place| place.is_finite()),
                "{}",
                scene.name
            );
            let last = *path.points.last().unwrap();
            match trace.outcome {
                // Light is still deflected by about r_s / r beyond the last point.
                Outcome::Sky => {
                    assert!(
                        last.angle_between(trace.sky.unwrap()) < 0.6,
                        "{}: {last} {trace:?}",
                        scene.name
                    );
                }
                _ => assert!(
                    last.length() < 1.1 * 1.0_f64.max(path.closest_r),
                    "{}: ends at {last}",
                    scene.name
                ),
            }
            let nearest = path
                .points
                .iter()
                .map(|place| place.length())
                .fold(f64::INFINITY, f64::min);
            if trace.outcome == Outcome::Sky {
                assert!(path.closest_r <= nearest * (1.0 + 1e-12), "{}", scene.name);
                assert!(
                    nearest < path.closest_r * 1.05,
                    "{}: {nearest} {}",
                    scene.name,
                    path.closest_r
                );
            }
        }
    }
}

/// A backward ray from inside either leaves through the horizon, and ends at the sky or comes back,
/// or its light did not come from outside, and it stays inside.
#[test]
fn paths_from_inside_lead_out_only_where_light_came_in() {
    for spin in [0.0, 0.9] {
        let mut scene = presets::find("2").unwrap().scene(&[]).unwrap();
        scene.hole.spin = spin;
        scene.camera.r = 0.6;
        scene.observer.kind = ObserverKind::Rain;
        scene.disk.enabled = false;
        let horizon = Kerr { spin }.horizon();
        let reference = Reference::new(&scene).unwrap();
        let mut seen = [0, 0];
        for direction in reference::directions(600) {
            let (trace, path) = Path::of(&reference, direction, 60.0);
            let farthest = path
                .points
                .iter()
                .map(|place| place.length())
                .fold(0.0, f64::max);
            if trace.outcome == Outcome::Sky {
                assert!(farthest > 10.0, "spin {spin}, {direction}: {farthest}");
                seen[0] += 1;
            } else if trace.steps == 0 {
                // The reference finds without a step that this light does not come from outside.
                assert!(
                    farthest <= horizon * (1.0 + 1e-9),
                    "spin {spin}, {direction}: {farthest}"
                );
                seen[1] += 1;
            }
        }
        assert!(seen[0] > 5 && seen[1] > 5, "spin {spin}: {seen:?}");
    }
}

#[test]
fn without_spin_the_closest_approach_and_the_swept_angle_follow_the_orbit_equation() {
    let mut scene = Scene::default();
    scene.disk.enabled = false;
    for aside in [0.14, 0.2, 0.5, 1.0] {
        let direction = DVec3::new(-1.0, 0.3 * aside, aside).normalize();
        let inspected = Inspected::new(&scene, direction, None, 60.0).unwrap();
        let (numbers, path) = (&inspected.numbers, &inspected.path);
        // b = r sin(angle) / sqrt(1 - 1/r) for an observer at rest.
        let r = scene.camera.r;
        let sine = direction.y.hypot(direction.z);
        let b = r * sine / (1.0 - 1.0 / r).sqrt();
        assert!((numbers.impact_parameter.unwrap() - b).abs() < 1e-12 * b);
        // At the closest approach b^2 = r^3 / (r - 1).
        let closest = path.closest_r;
        assert!(
            (closest.powi(3) / (closest - 1.0) - b * b).abs() < 1e-10 * b * b,
            "{closest}"
        );
        // phi = integral of du / sqrt(1/b^2 - u^2 + u^3): in from the camera and out to infinity.
        // The substitution u = u0 (1 - s^2) removes the singularity of the inverse square root.
        let u0 = 1.0 / closest;
        let swept = |from: f64| {
            let end = (1.0 - from / u0).sqrt();
            midpoints(0.0, end, |s| {
                let u = u0 * (1.0 - s * s);
                // 1/b^2 - u^2 + u^3 vanishes at u0; this is its quotient by (u0 - u).
                let over = (u0 + u) - (u0 * u0 + u0 * u + u * u);
                2.0 * u0.sqrt() / over.sqrt()
            })
        };
        let expected = swept(1.0 / r) + swept(0.0);
        assert!(
            (path.swept_angle - expected).abs() < 1e-8,
            "{aside}: turned {} and not {expected}",
            path.swept_angle
        );
    }
}

#[test]
fn without_spin_light_from_the_disk_takes_the_time_of_the_orbit_equation() {
    // Straight down onto the disk from far above it, without turning on the way:
    // dt/dr = 1 / ((1 - 1/r) sqrt(1 - b^2 (1 - 1/r) / r^2)).
    let mut scene = Scene::default();
    (scene.camera.r, scene.camera.theta_deg) = (30.0, 20.0);
    let mut counted = 0;
    for aside in [0.10, 0.15, 0.2, 0.25] {
        let inspected = Inspected::new(
            &scene,
            DVec3::new(-1.0, aside, 0.05).normalize(),
            None,
            60.0,
        )
        .unwrap();
        let numbers = &inspected.numbers;
        let (Some(r), Some(delay)) = (numbers.cpu.hit1_r, numbers.hit1_delay) else {
            continue;
        };
        if numbers.closest_r < r * (1.0 - 1e-9) && numbers.half_turns > 1.0 {
            continue;
        }
        let b = numbers.impact_parameter.unwrap();
        let pace =
            |r: f64| 1.0 / ((1.0 - 1.0 / r) * (1.0 - b * b * (1.0 - 1.0 / r) / (r * r)).sqrt());
        let expected = midpoints(r, scene.camera.r, pace);
        assert!(
            (delay - expected).abs() < 1e-8 * expected,
            "{aside}: {delay} and not {expected}"
        );
        counted += 1;
    }
    assert!(
        counted >= 3,
        "only {counted} rays went straight to the disk"
    );
}

#[test]
fn a_second_hit_was_emitted_earlier_by_more_than_the_light_time_of_the_straight_line() {
    let scene = presets::find("extremal").unwrap().scene(&[]).unwrap();
    let mut counted = 0;
    for direction in directions(&scene) {
        let inspected = Inspected::new(&scene, direction, None, 60.0).unwrap();
        let (first, second) = (inspected.numbers.hit1_delay, inspected.numbers.hit2_delay);
        if let (Some(first), Some(second)) = (first, second) {
            let place = |r: f64, phi: f64| DVec2::new(phi.cos(), phi.sin()) * r;
            let cpu = &inspected.numbers.cpu;
            let way = place(cpu.hit1_r.unwrap(), cpu.hit1_phi.unwrap())
                .distance(place(cpu.hit2_r.unwrap(), cpu.hit2_phi.unwrap()));
            assert!(second - first > way, "{first} {second} {way}");
            counted += 1;
        }
    }
    assert!(counted > 0);
}

#[test]
fn an_inspection_has_the_shift_of_the_sky() {
    // Overhead at 1.2 r_s: 1/sqrt(1 - 1/r) at rest, and 1/(1 + sqrt(1/r)) for one who falls from rest
    // far away.
    let mut scene = Scene::default();
    (scene.camera.r, scene.disk.enabled) = (1.2, false);
    let g = |scene: &Scene, direction| {
        let inspected = Inspected::new(scene, direction, None, 60.0).unwrap();
        inspected.numbers.sky_g
    };
    let lapse = (1.0_f64 - 1.0 / 1.2).sqrt();
    assert_close("at rest", g(&scene, DVec3::X).unwrap(), 1.0 / lapse, 1e-12);
    assert_eq!(g(&scene, DVec3::NEG_X), None);
    scene.observer.kind = ObserverKind::Rain;
    let falling = 1.0 / (1.0 + (1.0_f64 / 1.2).sqrt());
    assert_close("falling", g(&scene, DVec3::X).unwrap(), falling, 1e-12);
    // Without the Doppler shift, gravity's part is left.
    scene.effects.doppler = false;
    assert_close("gravity", g(&scene, DVec3::X).unwrap(), 1.0 / lapse, 1e-12);
}

#[test]
fn an_inspection_has_the_numbers_of_trace() {
    for scene in presets() {
        let reference = Reference::new(&scene).unwrap();
        for direction in directions(&scene) {
            let numbers = Inspected::new(&scene, direction, None, 60.0)
                .unwrap()
                .numbers;
            let mut csv = Vec::new();
            let mut writer = lightfall_core::accuracy::rays::TraceWriter::new(&mut csv).unwrap();
            writer
                .write(&reference.trace_with_delays(direction))
                .unwrap();
            writer.finish().unwrap();
            let csv = String::from_utf8(csv).unwrap();
            let mut lines = csv.lines().map(|line| line.split(','));
            let json: serde_json::Value = serde_json::from_str(&numbers.to_json()).unwrap();
            for (name, value) in lines.next().unwrap().zip(lines.next().unwrap()) {
                let shown = &json["cpu"][name];
                match (name, value) {
                    ("outcome", value) => assert_eq!(shown, value),
                    (_, "") => assert!(shown.is_null(), "{name} = {shown}"),
                    // The JSON reader of this test may be wrong in the last digit.
                    _ => {
                        let (shown, value) =
                            (shown.as_f64().unwrap(), value.parse::<f64>().unwrap());
                        assert!(
                            (shown - value).abs() <= f64::EPSILON * value.abs(),
                            "{name}: {shown} and not {value}"
                        );
                    }
                }
            }
            let text = numbers.to_text();
            assert!(
                text.contains(&format!("cpu.outcome = {}\n", numbers.cpu.outcome.word()))
                    && !text.contains("null"),
                "{text}"
            );
        }
    }
}

#[test]
fn an_inspection_compares_the_delays_of_the_hits_that_both_answers_have() {
    let scene = presets::find("extremal").unwrap().scene(&[]).unwrap();
    let reference = Reference::new(&scene).unwrap();
    let axes = scene.camera.tetrad_from_camera();
    let mut counted = [0; 3];
    for toward in directions(&scene) {
        let ray = Ray::toward(axes.transpose() * toward);
        let direction = axes * ray.direction();
        let mut inspected = Inspected::new(&scene, direction, None, 60.0).unwrap();
        let mut given = reference.trace_with_delays(direction);
        let mut hits = given.hits.iter_mut().flatten();
        let mut expected = None;
        // The second delay is off by less than the first, and on the other side.
        for off in [2e-3, -1e-3] {
            if let Some(hit) = hits.next() {
                hit.delay = hit.delay.map(|delay| delay + off);
                expected = expected.or(Some(off));
            }
        }
        inspected.compare(&scene, ray, &given).unwrap();
        let numbers = inspected.numbers;
        let found = numbers.difference.unwrap().hit_t;
        match (found, expected) {
            (Some(found), Some(expected)) => {
                // The rounding of delays of some 50 r_s/c.
                assert!(
                    (found - expected).abs() < 1e-13,
                    "{found} and not {expected}"
                );
                let text = numbers.to_text();
                assert!(
                    text.contains("cpu.hit1_t = ") && text.contains("gpu.hit1_t = "),
                    "{text}"
                );
                assert!(text.contains("difference.hit_t = 0.00"), "{text}");
            }
            (found, expected) => assert_eq!(found, expected),
        }
        counted[given.hits.iter().flatten().count()] += 1;
    }
    assert!(counted[1] > 0 && counted[2] > 0, "{counted:?}");
}

#[test]
fn orders_are_whole_half_turns_and_straight_rays_have_order_zero() {
    let mut seen = 0;
    for mut scene in presets() {
        scene.effects.lensing = false;
        let inspected = |direction| Inspected::new(&scene, direction, None, 60.0).unwrap();
        // Rays without anything to be seen have no order.
        let orders = directions(&scene).into_iter().map(inspected);
        for order in orders.filter_map(|inspected| inspected.numbers.order) {
            assert!(order <= 1, "{}", scene.name);
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen} rays");
    // Light that barely escapes winds about the hole: half a turn more for every factor e^pi nearer
    // to the critical ray.
    let mut scene = Scene::default();
    scene.disk.enabled = false;
    let r = scene.camera.r;
    let critical = (27.0_f64.sqrt() / 2.0 * (1.0 - 1.0 / r).sqrt() / r).asin();
    let turn = |aside: f64| {
        let angle = critical * (1.0 + aside);
        Inspected::new(
            &scene,
            DVec3::new(-angle.cos(), 0.0, angle.sin()),
            None,
            60.0,
        )
        .unwrap()
        .path
        .swept_angle
    };
    let more = turn(1e-7 / PI.exp()) - turn(1e-7);
    assert!((more - PI).abs() < 1e-4, "{more}");
}
