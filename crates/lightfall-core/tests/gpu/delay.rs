//! The delays of the shaders against the f64 reference, which tests/physics compares with tabulated
//! values.

mod comparison;

use crate::random::Random;
use comparison::{ARTICLE, CLOSED, CLOSED_INSIDE_SPINNING, Comparison, Differences, ENOUGH, MINO};
use glam::{DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{Method, ObserverKind, Scene};
use std::f64::consts::PI;

/// A static camera at 20 r_s with a disk from the innermost stable orbit to 11 r_s, 50 degrees
/// high.
fn tabulated(method: Method, spin: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene {
        method,
        ..Scene::default()
    };
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (20.0, theta_deg, 0.0);
    scene.camera.fov_deg = 50.0;
    (scene.disk.follow_isco, scene.disk.outer) = (true, 11.0);
    scene
}

/// Every third pixel of 960 x 540, as the shaders get it.
fn pixels(scene: &Scene) -> Vec<DVec3> {
    let size = DVec2::new(960.0, 540.0);
    let pixel = |i: u32| DVec2::new(f64::from(i % 64), f64::from(i / 64)) * 15.0 + 0.5;
    let axes = scene.camera.tetrad_from_camera();
    let directions = (0..64 * 36).map(|i| axes * scene.camera.looking(pixel(i), size));
    directions.map(|d| d.as_vec3().as_dvec3()).collect()
}

/// Random directions, as the shaders get them: a third of them all over the sky, a third toward the
/// hole, and a third at 1e-5 to 0.3 of its radius from the shadow's edge, where the images of high
/// order are.
fn random_directions(random: &mut Random, scene: &Scene, count: u32) -> Vec<DVec3> {
    let reference = Reference::new(scene).unwrap();
    let shadow = 2.6 / scene.camera.r;
    let captured = |direction: DVec3| reference.trace(direction).outcome == Outcome::Captured;
    let direction = |i: u32| {
        let any = random.direction();
        let direction = match i % 3 {
            0 => any,
            1 => DVec3::NEG_X + random.between(0.0, 3.0) * shadow * any,
            _ => {
                let across = DVec3::new(0.0, any.y, any.z).normalize();
                let at = |angle: f64| DVec3::new(-angle.cos(), 0.0, 0.0) + angle.sin() * across;
                let (mut low, mut high) = (0.0, PI);
                if captured(at(low)) && !captured(at(high)) {
                    while high - low > 1e-6 * high.min(PI - high) {
                        let middle = 0.5 * (low + high);
                        if captured(at(middle)) {
                            low = middle
                        } else {
                            high = middle
                        }
                    }
                }
                let off = high.min(PI - high) * random.log_between(1e-5, 0.3);
                at(high
                    + if random.between(0.0, 1.0) < 0.8 {
                        off
                    } else {
                        -off
                    })
            }
        };
        direction.normalize().as_vec3().as_dvec3()
    };
    (0..count).map(direction).collect()
}

/// The places of the cameras, in r_s.
const FAR: [f64; 5] = [2.0, 5.0, 20.0, 1000.0, 1e5];

fn random_scene(random: &mut Random, method: Method, spin: f64, r: f64) -> Scene {
    let mut scene = tabulated(method, spin, random.between(1.0, 179.0));
    scene.camera.r = r;
    scene.observer.kind = ObserverKind::Zamo;
    // From afar aberration would turn the hole away from the directions, and next to the horizon
    // the sky.
    let speed = if (1.1..10.0).contains(&r) || r <= 1.0 {
        random.between(0.0, 0.5)
    } else {
        0.0
    };
    scene.observer.velocity = (speed * random.direction()).to_array();
    scene
}

/// The differences in three random scenes.
fn differences(random: &mut Random, scene: impl Fn(&mut Random) -> Scene) -> Differences {
    let mut off = Differences::default();
    for _ in 0..3 {
        let scene = scene(random);
        off.add(&scene, &random_directions(random, &scene, 400));
    }
    off
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_delays_of_closed_in_random_scenes_are_those_of_the_reference() {
    let mut comparison = Comparison::new(CLOSED);
    for theta in [83.0, 60.0, 0.0] {
        let scene = tabulated(Method::Closed, 0.0, theta);
        let mut off = Differences::default();
        off.add(&scene, &pixels(&scene));
        comparison.add(&format!("closed, pixels, {theta}"), &off);
    }
    let mut random = Random::new();
    for r in [1.0001, 1.2, 1.6].into_iter().chain(FAR) {
        let off = differences(&mut random, |random| {
            random_scene(random, Method::Closed, 0.0, r)
        });
        comparison.add(&format!("closed, {r}"), &off);
    }
    comparison.assert_within_the_bar();
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_delays_of_mino_in_random_scenes_are_those_of_the_reference() {
    let mut comparison = Comparison::new(MINO);
    for (spin, theta) in [(0.0, 83.0), (0.9, 83.0), (0.9, 60.0)] {
        let scene = tabulated(Method::Mino, spin, theta);
        let mut off = Differences::default();
        off.add(&scene, &pixels(&scene));
        comparison.add(&format!("mino, pixels, {spin}, {theta}"), &off);
    }
    let spins = [0.0, 0.3, 0.9, -0.9, 0.998];
    compare_from_outside(&mut comparison, Method::Mino, &spins);
    comparison.assert_within_the_bar();
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_delays_of_closed_with_spin_in_random_scenes_are_those_of_the_reference() {
    let mut comparison = Comparison::new(CLOSED);
    let spins = [0.3, 0.9, -0.9, 0.998];
    compare_from_outside(&mut comparison, Method::Closed, &spins);
    comparison.assert_within_the_bar();
}

/// Adds random scenes of a method from outside the horizon.
fn compare_from_outside(comparison: &mut Comparison, method: Method, spins: &[f64]) {
    let mut random = Random::new();
    for spin in spins {
        for r in FAR {
            let off = differences(&mut random, |random| random_scene(random, method, *spin, r));
            comparison.add(&format!("{method:?}, {spin}, {r}"), &off);
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn inside_the_horizon_the_lags_of_closed_in_random_scenes_are_those_of_the_reference() {
    let mut comparison = Comparison::new(CLOSED);
    compare_inside_the_horizon(&mut comparison, Method::Closed, &[0.0]);
    comparison.assert_within_the_bar();
}

#[test]
#[ignore = "needs a graphics adapter"]
fn inside_the_horizon_the_lags_of_closed_with_spin_in_random_scenes_are_those_of_the_reference() {
    let mut comparison = Comparison::new(CLOSED_INSIDE_SPINNING);
    compare_inside_the_horizon(&mut comparison, Method::Closed, &[0.9]);
    comparison.assert_within_the_bar();
}

#[test]
#[ignore = "needs a graphics adapter"]
fn inside_the_horizon_the_lags_of_mino_in_random_scenes_are_those_of_the_reference() {
    let mut comparison = Comparison::new(MINO);
    compare_inside_the_horizon(&mut comparison, Method::Mino, &[0.0, 0.5, 0.9, -0.9]);
    comparison.assert_within_the_bar();
}

/// Adds random scenes of a method from the horizon to as far as the camera falls.
fn compare_inside_the_horizon(comparison: &mut Comparison, method: Method, spins: &[f64]) {
    let mut random = Random::new();
    for &spin in spins {
        let (horizon, end) = (Kerr { spin }.horizon(), min_infall_radius(Kerr { spin }));
        for depth in [0.0, 0.01, 0.5, 1.0] {
            let mut off = Differences::default();
            // Three scenes, or more if few of their rays meet the disk.
            for i in 0..12 {
                if i >= 3 && off.there.len() >= ENOUGH {
                    break;
                }
                let mut scene = random_scene(&mut random, method, spin, 1.0);
                scene.observer.kind = ObserverKind::Rain;
                scene.camera.r = horizon - depth * (horizon - end);
                off.add(&scene, &random_directions(&mut random, &scene, 600));
            }
            comparison.add(&format!("inside, {method:?}, {spin}, {depth}"), &off);
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn without_lensing_the_delay_in_random_scenes_is_the_distance() {
    let mut comparison = Comparison::new(CLOSED);
    let mut random = Random::new();
    for spin in [0.0, 0.9] {
        let off = differences(&mut random, |random| {
            let mut scene = random_scene(random, Method::Auto, spin, 20.0);
            scene.effects.lensing = false;
            scene
        });
        comparison.add(&format!("straight, {spin}"), &off);
    }
    comparison.assert_within_the_bar();
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_delays_of_the_articles_methods_in_random_scenes_are_those_of_the_reference_at_fine_steps() {
    let mut comparison = Comparison::new(ARTICLE);
    let mut random = Random::new();
    for (method, spin) in [
        (Method::Verlet, 0.0),
        (Method::KerrSchild, 0.0),
        (Method::KerrSchild, 0.9),
        (Method::KerrSchild, -0.9),
    ] {
        for r in [2.0, 5.0, 20.0, 100.0] {
            let off = differences(&mut random, |random| {
                let mut scene = random_scene(random, method, spin, r);
                scene.quality.step_scale = 0.45;
                scene.quality.max_affine = 1e5;
                scene
            });
            comparison.add(&format!("{method:?}, {spin}, {r}"), &off);
        }
    }
    comparison.assert_within_the_bar();
}
