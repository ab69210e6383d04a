//! The shaders, run on the machine's graphics adapter. Tests that need one are ignored unless
//! `--include-ignored` asks for them.
#![allow(
    clippy::print_stderr,
    reason = "what a test says is read beside its result"
)]
#![allow(clippy::unwrap_used, reason = "a test that cannot continue has failed")]

mod adapter;
mod adapter_request;
mod background_device;
mod bench_rows;
mod bench_run;
#[path = "../physics/bisect.rs"]
mod bisect;
mod camera;
mod cells;
mod choice;
mod closed;
mod closed_kerr;
mod delay;
mod disk;
mod effects;
mod elementary;
mod elliptic;
mod error_map;
mod extremes;
mod finite_light;
mod functions;
mod hot_spot;
#[path = "../physics/hot_spot_flux.rs"]
mod hot_spot_flux;
mod inside;
mod jet;
mod kerr_schild;
mod layout;
mod light;
#[path = "../physics/light_without_spin.rs"]
mod light_without_spin;
mod limb;
mod matter_places;
mod medium;
mod medium_measurements;
mod mino;
#[path = "../physics/moved_camera.rs"]
mod moved_camera;
mod narrow_ring;
mod observers;
mod omissions;
mod part_headers;
mod plane;
mod presentation;
mod projection;
#[path = "../physics/projection_pairs.rs"]
mod projection_pairs;
mod promises;
#[path = "../physics/random.rs"]
mod random;
mod random_matter;
mod random_scene;
mod refine;
mod refusals;
mod requirements;
mod shader_files;
mod shaders;
mod shadow;
mod sky;
mod spectrum;
mod stars;
mod structure;
#[path = "../physics/structure_field.rs"]
mod structure_field;
#[path = "../physics/tabulated_images.rs"]
mod tabulated_images;
mod tilted_disk;
mod uniforms;
mod variants;
mod verlet;
mod views;

use adapter::gpu;
use glam::DVec3;
use lightfall_core::gpu::rays;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::{Method, Scene};

/// WGSL for [`light::light_from`]: the light that comes from a direction on the observer's axes.
const ALONG: &str = "light_along(photon_from(given.xyz))";

/// A scene with only the hole and a static camera at `r`, traced by the article's method in
/// balanced quality.
fn bare_hole(r: f64) -> Scene {
    let mut scene = Scene {
        method: Method::Verlet,
        ..Scene::default()
    };
    scene.camera.r = r;
    scene.camera.theta_deg = 80.2;
    scene.camera.phi_deg = 25.0;
    scene.disk.enabled = false;
    scene
}

/// The view of the edge-on preset as in the article's measurements: 20 r_s, 9.8 degrees above
/// the disk.
fn edge_on() -> Scene {
    let mut scene = bare_hole(20.0);
    scene.disk.enabled = true;
    scene
}

/// Directions on the observer's axes through the centres of a grid of `columns` x `rows` pixels.
fn pixel_directions(scene: &Scene, columns: u32, rows: u32) -> Vec<DVec3> {
    let tan_half = (scene.camera.fov_deg.to_radians() / 2.0).tan();
    let aspect = f64::from(columns) / f64::from(rows);
    let across = |i: u32, count: u32| (2.0 * f64::from(i) + 1.0) / f64::from(count) - 1.0;
    let pixels =
        (0..rows).flat_map(|y| (0..columns).map(move |x| (across(x, columns), -across(y, rows))));
    pixels
        .map(|(x, y)| {
            let direction = DVec3::new(x * aspect * tan_half, y * tan_half, 1.0).normalize();
            scene.camera.tetrad_from_camera() * direction
        })
        .collect()
}

/// Directions spread evenly over the sphere (a golden spiral).
fn all_around(count: u32) -> Vec<DVec3> {
    let turn = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let direction = |i: u32| {
        let x = 1.0 - f64::from(2 * i + 1) / f64::from(count);
        let (sin, cos) = (turn * f64::from(i)).sin_cos();
        DVec3::new(x, (1.0 - x * x).sqrt() * cos, (1.0 - x * x).sqrt() * sin)
    };
    (0..count).map(direction).collect()
}

/// The direction, on the observer's axes, at an angle `alpha` from the hole's centre, toward
/// increasing phi.
fn direction_off_centre(alpha: f64) -> DVec3 {
    DVec3::new(-alpha.cos(), 0.0, alpha.sin())
}

/// The traces of a scene's rays, each with the reference's.
fn with_truths(scene: &Scene, directions: &[DVec3]) -> impl Iterator<Item = (Trace, Trace)> {
    let reference = Reference::new(scene).unwrap();
    let found = rays::trace(gpu(), scene, directions).unwrap();
    let truths = directions.iter().map(move |d| reference.trace(*d));
    found.into_iter().zip(truths)
}

/// The median of numbers.
fn median(values: &[f64]) -> f64 {
    quantile(values, 0.5)
}

/// The value that a `share` of the numbers does not exceed.
fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[((sorted.len() - 1) as f64 * share).round() as usize]
}
