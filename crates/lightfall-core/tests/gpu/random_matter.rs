//! Random scenes with matter with depth: the light of single rays against the converged f64 twin's.
//! A third of them have jets, half of these beside a disk with thickness.

use crate::gpu;
use crate::random::Random;
use lightfall_core::accuracy::{
    LightErrors, Ray, light_floor, rays_over_picture, rays_over_sky, true_passages,
};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::gpu::Drawable;
use lightfall_core::gpu::passages::{GpuPassage, PassageKernel};
use lightfall_core::scene::{
    DiskModel, DiskStructure, LimbDarkening, ObserverKind, Scene, SkyMode,
};

/// Random scenes, each with a shader of its own to compile.
const SCENES: usize = 12;
/// Rays of a scene, half of them over its picture.
const RAYS: usize = 600;
/// Rays that meet the matter: at least so many, and so many of them are compared.
const LIT: [usize; 2] = [30, 60];

/// A random scene with a disk with thickness that can be drawn.
fn random_scene(random: &mut Random) -> Scene {
    loop {
        let mut scene = Scene::default();
        scene.sky.mode = SkyMode::Off;
        set_place(random, &mut scene);
        set_disk(random, &mut scene);
        if random.one_in(3) {
            set_jets(random, &mut scene);
        }
        scene.quality.max_error_light = random.of(&[0.1, 0.02, 0.002]);
        let effects = &mut scene.effects;
        for effect in [
            &mut effects.doppler,
            &mut effects.beaming,
            &mut effects.gravitational_shift,
            &mut effects.aberration,
        ] {
            *effect = !random.one_in(8);
        }
        if let Ok(scene) = Drawable::new(scene) {
            return scene.into_scene();
        }
    }
}

/// The hole, and an observer in the disk's neighbourhood, or inside the horizon.
fn set_place(random: &mut Random, scene: &mut Scene) {
    scene.hole.spin = match random.integer(0, 3) {
        0 => 0.0,
        1 => random.of(&[-0.9999, 0.998, 0.9999]),
        _ => random.between(-1.0, 1.0),
    };
    let spin = scene.hole.spin;
    scene.observer.kind = random.of(&ObserverKind::ALL);
    if random.one_in(3) {
        scene.observer.velocity = [(); 3].map(|()| random.between(-0.5, 0.5));
    }
    let camera = &mut scene.camera;
    camera.r = match random.integer(0, 5) {
        0 => Kerr { spin }.horizon() * random.between(0.5, 1.5),
        _ => random.log_between(1.5, 60.0),
    };
    camera.theta_deg = match random.integer(0, 3) {
        _ if scene.observer.kind == ObserverKind::Orbit => 90.0,
        0 => 90.0 + random.log_between(1e-3, 10.0),
        _ => random.between(0.0, 180.0),
    };
    camera.phi_deg = random.between(-180.0, 180.0);
    camera.fov_deg = random.between(20.0, 90.0);
}

/// The disk and its light.
fn set_disk(random: &mut Random, scene: &mut Scene) {
    scene.disk.follow_isco = random.one_in(2);
    scene.disk.inner = random.log_between(0.6, 12.0);
    scene.disk.outer = scene.inner_edge() * random.log_between(1.3, 20.0);
    let disk = &mut scene.disk;
    disk.model = random.of(&DiskModel::ALL);
    disk.limb = random.of(&LimbDarkening::ALL);
    disk.thickness = random.log_between(0.002, 0.3);
    disk.depth = random.log_between(0.1, 200.0);
    disk.flare = random.of(&[0.0, 0.0, 0.25, -0.25]);
    disk.edge_taper = random.of(&[0.0, 0.03, 0.2, 0.5]);
    disk.outer_taper = random.of(&[0.0, 0.1, 0.45, 0.9]);
    disk.temperature_k = random.log_between(2e3, 1e5);
    if scene.hole.spin == 0.0 && random.one_in(2) {
        scene.disk.tilt_deg = random.between(0.0, 180.0);
        scene.disk.node_deg = random.between(-180.0, 180.0);
    }
}

/// Smooth jets, in every second scene beside a disk without thickness.
fn set_jets(random: &mut Random, scene: &mut Scene) {
    if random.one_in(2) {
        scene.disk.thickness = 0.0;
        scene.disk.transmission = random.of(&[0.0, 0.5]);
    }
    let jet = &mut scene.jet;
    jet.enabled = true;
    jet.knots = 0.0;
    jet.brightness = random.log_between(0.1, 10.0);
    jet.width = random.log_between(0.05, 1.0);
    jet.length = random.log_between(5.0, 200.0);
    jet.speed = random.of(&[0.1, 0.5, 1.5, 20.0]);
    jet.colour = random.log_between(0.1, 20.0);
}

/// A random scene of whose rays enough meet the matter, its rays, and what the GPU finds. Every ray has
/// an end, and light.
fn lit_scene(random: &mut Random) -> (Scene, Vec<Ray>, Vec<GpuPassage>) {
    loop {
        let scene = random_scene(random);
        let mut rays = rays_over_picture(&scene, RAYS / 2);
        rays.extend(rays_over_sky(RAYS / 2));
        let found = found(&scene, &rays);
        if found.iter().filter(|seen| seen.samples > 0).count() >= LIT[0] {
            return (scene, rays, found);
        }
    }
}

fn found(scene: &Scene, rays: &[Ray]) -> Vec<GpuPassage> {
    let given = rays.iter().map(Ray::given);
    let kernel = PassageKernel::new(gpu(), scene).unwrap();
    let found = kernel.passages(gpu(), scene, given).unwrap();
    for (ray, seen) in rays.iter().zip(&found) {
        assert!(
            seen.is_finite() && !seen.is_unfinished(),
            "{ray:?}: {seen:?}\n{}",
            scene.to_preset()
        );
    }
    found
}

#[test]
#[ignore = "needs a graphics adapter"]
fn light_of_matter_in_random_scenes_is_that_of_the_twin() {
    let mut random = Random::new();
    let mut failing = Vec::new();
    for number in 0..SCENES {
        let (scene, mut rays, found) = lit_scene(&mut random);
        // All rays up to the last that is compared, so that the twin may see what the GPU has missed.
        let lit = found
            .iter()
            .enumerate()
            .filter(|(_, seen)| seen.samples > 0);
        let last = lit.take(LIT[1]).last().map_or(0, |(i, _)| i);
        rays.truncate(last + 1);
        let light: Vec<_> = found[..=last].iter().map(|seen| seen.light).collect();
        let truth = true_passages(&scene, &rays, 1e-5).unwrap();
        let truth: Vec<_> = truth.iter().map(|seen| seen.light).collect();
        let floor = light_floor(truth.iter().copied());
        let errors = LightErrors::between(&light, &truth, floor);
        let bar = scene.quality.max_error_light;
        println!("scene {number}, {bar}: {errors:?}");
        if errors.p95.is_nan() || errors.p95 > bar {
            failing.push(format!("scene {number}: {errors:?}\n{}", scene.to_preset()));
        }
    }
    assert!(failing.is_empty(), "{}", failing.join("\n"));
}

#[test]
#[ignore = "needs a graphics adapter"]
fn light_of_structured_matter_in_random_scenes_is_finite() {
    let mut random = Random::new();
    for _ in 0..SCENES {
        let (mut scene, rays, _) = lit_scene(&mut random);
        scene.disk.structure = random.of(&[DiskStructure::Turbulent, DiskStructure::Streaks]);
        (scene.disk.contrast, scene.disk.lumps) =
            (random.between(0.0, 1.5), random.of(&[0.0, 2.0]));
        scene.disk.lanes = random.of(&[0.0, 1.0]);
        scene.disk.time = random.of(&[0.0, 1e3, -1e9]);
        scene.jet.knots = random.between(0.0, 1.5);
        let found = found(&scene, &rays);
        let lit = found.iter().filter(|seen| seen.light.max_element() > 0.0);
        assert!(lit.count() > 0, "{}", scene.to_preset());
    }
}
