//! Random scenes of every kind: holes, observers, places, disks, skies and effects, often at the very
//! limits of what can be drawn. Two test programs share them.

use crate::random::Random;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{
    DiskModel, DiskStructure, HotSpotKind, LimbDarkening, Method, ObserverKind, Scene, SkyMode,
};

/// The skies that need no file.
pub const SKIES: [SkyMode; 4] = [
    SkyMode::Stars,
    SkyMode::Procedural,
    SkyMode::Grid,
    SkyMode::Off,
];

/// A random scene that can be drawn, under one of these skies.
pub fn random_scene(random: &mut Random, skies: &[SkyMode]) -> Drawable {
    loop {
        let mut scene = Scene {
            method: random.of(&Method::on_gpu()),
            ..Scene::default()
        };
        set_place(random, &mut scene);
        set_disk(random, &mut scene);
        scene.sky.mode = random.of(skies);
        scene.sky.brightness = random.of(&[1.0, 30.0]);
        scene.sky.reference_star = random.one_in(3);
        let effects = &mut scene.effects;
        for effect in [
            &mut effects.lensing,
            &mut effects.doppler,
            &mut effects.beaming,
            &mut effects.gravitational_shift,
            &mut effects.aberration,
        ] {
            *effect = !random.one_in(8);
        }
        if let Ok(scene) = Drawable::new(scene) {
            return scene;
        }
    }
}

/// The hole, the observer, and where and how it looks: next to horizons and far away, on the axis and
/// in the plane.
fn set_place(random: &mut Random, scene: &mut Scene) {
    scene.hole.spin = match random.integer(0, 3) {
        0 => 0.0,
        1 => random.of(&[-0.999_999, 0.999, 0.999_999]),
        _ => random.between(-1.0, 1.0),
    };
    let horizon = Kerr {
        spin: scene.hole.spin,
    }
    .horizon();
    scene.observer.kind = random.of(&ObserverKind::ALL);
    if random.one_in(3) {
        scene.observer.velocity = [(); 3].map(|()| random.between(-0.57, 0.57));
    }
    let camera = &mut scene.camera;
    camera.r = match random.integer(0, 3) {
        0 => horizon * random.between(0.2, 1.1),
        1 => horizon * (1.0 + random.log_between(1e-4, 1.0)),
        2 => random.log_between(1e2, 1e6),
        _ => random.between(3.0, 30.0),
    };
    camera.theta_deg = match random.integer(0, 3) {
        _ if scene.observer.kind == ObserverKind::Orbit => 90.0,
        0 => random.of(&[0.0, 90.0, 180.0]),
        1 => 90.0 + random.log_between(1e-6, 1.0),
        _ => random.between(0.0, 180.0),
    };
    camera.phi_deg = random.between(-180.0, 180.0);
    camera.fov_deg = random.log_between(5.0, 150.0);
    if random.one_in(2) {
        camera.yaw_deg = random.between(-180.0, 180.0);
        camera.pitch_deg = random.between(-90.0, 90.0);
    }
}

/// The disk and its light.
fn set_disk(random: &mut Random, scene: &mut Scene) {
    let disk = &mut scene.disk;
    disk.enabled = !random.one_in(5);
    disk.outer = random.log_between(2.0, 1e3);
    disk.inner = disk.outer * random.between(0.05, 0.99);
    disk.follow_isco = random.one_in(2);
    disk.model = random.of(&DiskModel::ALL);
    disk.keep_accretion = random.one_in(2);
    disk.temperature_k = random.log_between(100.0, 1e6);
    disk.brightness = random.log_between(1e-3, 1e3);
    disk.edge_taper = random.of(&[0.0, 0.03, 0.5]);
    disk.transmission = random.of(&[0.0, 0.3, 1.0]);
    disk.limb = random.of(&LimbDarkening::ALL);
    disk.structure = random.of(&DiskStructure::ALL);
    disk.contrast = random.between(0.0, 1.5);
    disk.period = random.of(&[0.0, 24.0]);
    disk.time = random.of(&[0.0, 1e3, -1e9]);
    // Around a hole that spins no disk is tilted.
    if scene.hole.spin == 0.0 && random.one_in(2) {
        let tilt_deg = random.between(0.0, 180.0);
        disk.tilt_deg = random.of(&[tilt_deg, 90.0, 180.0]);
        disk.node_deg = random.between(-180.0, 180.0);
    }
    let spot = &mut scene.hot_spot;
    spot.kind = random.of(&HotSpotKind::ALL);
    spot.r = random.between(scene.disk.inner, scene.disk.outer);
    spot.size = random.log_between(0.01, 0.5);
    spot.duration = random.of(&[0.0, 30.0]);
}
