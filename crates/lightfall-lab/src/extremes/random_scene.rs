//! Random scenes.

use glam::DVec3;
use lightfall_gpu::GpuScene;
use lightfall_model::random::Random;
use lightfall_model::scene::{Method, ObserverKind, Scene};

/// A random scene with `auto`'s method, in which the observer can exist.
pub(super) fn random_scene(random: &mut Random) -> Scene {
    loop {
        let mut scene = Scene::default();
        scene.hole.spin = match random.unit() {
            share if share < 0.3 => 0.0,
            share if share < 0.6 => random.between(-0.99, 0.99),
            _ => (1.0 - random.log_between(1e-6, 0.5)) * if random.one_in(2) { -1.0 } else { 1.0 },
        };
        scene.method = Method::BEST;
        let horizon = scene.kerr().horizon();
        scene.camera.r = horizon * (1.0 + random.log_between(1e-4, 1e6));
        scene.camera.theta_deg = match random.unit() {
            share if share < 0.1 => 90.0,
            share if share < 0.2 => 0.0,
            share if share < 0.3 => random.log_between(1e-6, 1.0),
            _ => random.between(0.0, 180.0),
        };
        scene.camera.fov_deg = random
            .between(10.0, 120.0)
            .min((30.0 / scene.camera.r).to_degrees());
        scene.observer.kind = match random.unit() {
            share if share < 0.4 => ObserverKind::Static,
            share if share < 0.6 => ObserverKind::Zamo,
            share if share < 0.8 => ObserverKind::Orbit,
            _ => ObserverKind::Rain,
        };
        if random.one_in(3) {
            let speed = 1.0 - random.log_between(1e-4, 1.0);
            let direction = DVec3::new(
                random.between(-1.0, 1.0),
                random.between(-1.0, 1.0),
                random.between(-1.0, 1.0),
            );
            scene.observer.velocity = (speed * direction.normalize_or_zero()).to_array();
        }
        scene.disk.outer = random.log_between(2.0, 1e4);
        scene.disk.inner = scene.disk.outer * (1.0 - random.log_between(1e-5, 1.0)).max(1e-3);
        if scene.check().is_ok() && GpuScene::for_rays(&scene).is_ok() {
            return scene;
        }
    }
}
