//! A search at random, but from a seed, for the ray that a method does worst.

use super::{Kernels, bar};
use crate::gpu::{Gpu, GpuError, GpuScene};
use crate::physics::kerr::Kerr;
use crate::report::error::{Ray, Truth, critical, everywhere, on_picture};
use crate::scene::{Method, ObserverKind, Scene};
use glam::DVec3;

/// Rays of one scene.
const RAYS_A_SCENE: usize = 2000;

/// The generator SplitMix64 (Steele, Lea & Flood 2014): a hunt must find the same prey again.
struct Random(u64);

impl Random {
    /// Evenly from 0 to 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Evenly in the logarithm.
    fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    fn one_in(&mut self, n: u32) -> bool {
        self.unit() * f64::from(n) < 1.0
    }
}

/// A hunt: how many rays, from which seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hunt {
    /// How many rays.
    pub rays: usize,
    /// Where the random numbers begin.
    pub seed: u64,
}

/// A ray worth a look.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Its scene, with the method.
    pub scene: Scene,
    /// Its direction on the observer's legs.
    pub direction: DVec3,
    /// Its backward error, in radians.
    pub backward: f64,
    /// The backward error over the method's bar.
    pub excess: f64,
}

impl Hunt {
    /// How many scenes the hunt visits.
    #[must_use]
    pub fn scenes(&self) -> usize {
        self.rays.div_ceil(RAYS_A_SCENE)
    }

    /// Hunts with `auto`'s method in each scene; `done` is told of each scene's worst ray. The worst of all come back, the
    /// worst first.
    ///
    /// # Errors
    /// A device that failed.
    pub fn run(&self, gpu: &Gpu, mut done: impl FnMut(&Found)) -> Result<Vec<Found>, GpuError> {
        let mut random = Random(self.seed);
        let mut kernels = Kernels::default();
        let mut worst = Vec::new();
        for _ in 0..self.scenes() {
            let scene = scene(&mut random);
            let mut rays = everywhere(RAYS_A_SCENE / 4);
            rays.extend(on_picture(&scene, RAYS_A_SCENE / 4));
            rays.extend(critical(&scene, RAYS_A_SCENE / 2, [1e-7, 0.3]));
            let truth = Truth::of(&scene, rays)?;
            let traces = kernels.traces(gpu, &scene, &truth)?;
            let errors = truth.judge_beyond(0.5 * bar(&scene).backward, &traces);
            let most = errors.iter().zip(&truth.rays).max_by(|a, b| a.0.backward.total_cmp(&b.0.backward));
            if let Some((error, ray)) = most {
                let found = Found::new(&scene, ray, error.backward);
                done(&found);
                worst.push(found);
            }
        }
        worst.sort_by(|a, b| b.excess.total_cmp(&a.excess));
        Ok(worst)
    }
}

impl Found {
    fn new(scene: &Scene, ray: &Ray, backward: f64) -> Self {
        let direction = scene.camera.legs_from_camera() * ray.direction();
        Self { scene: scene.clone(), direction, backward, excess: backward / bar(scene).backward }
    }

    /// The command that traces this ray again.
    #[must_use]
    pub fn command(&self) -> String {
        let DVec3 { x, y, z } = self.direction;
        let Scene { hole, camera, observer, disk, method, .. } = &self.scene;
        let kind = match observer.kind {
            ObserverKind::Static => "static",
            ObserverKind::Zamo => "zamo",
            ObserverKind::Orbit => "orbit",
            ObserverKind::Rain => "rain",
        };
        let [v_r, v_theta, v_phi] = observer.velocity;
        format!(
            "echo {x:?},{y:?},{z:?} | lightfall trace --rays - --method {} --spin {:?} --set camera.r={:?} \
             --set camera.theta_deg={:?} --set observer.kind={kind} --set 'observer.velocity=[{v_r:?},{v_theta:?},{v_phi:?}]' \
             --set disk.inner={:?} --set disk.outer={:?}",
            method.name(),
            hole.spin,
            camera.r,
            camera.theta_deg,
            disk.inner,
            disk.outer,
        )
    }
}

/// A scene at random, drawn by `auto`'s method, that an observer can be in.
fn scene(random: &mut Random) -> Scene {
    loop {
        let mut scene = Scene::default();
        scene.hole.spin = match random.unit() {
            share if share < 0.3 => 0.0,
            share if share < 0.6 => random.between(-0.99, 0.99),
            _ => (1.0 - random.log_between(1e-6, 0.5)) * if random.one_in(2) { -1.0 } else { 1.0 },
        };
        scene.method = Method::for_spin(scene.hole.spin);
        let horizon = Kerr { spin: scene.hole.spin }.horizon();
        scene.camera.r = horizon * (1.0 + random.log_between(1e-4, 1e6));
        scene.camera.theta_deg = match random.unit() {
            share if share < 0.1 => 90.0,
            share if share < 0.2 => 0.0,
            share if share < 0.3 => random.log_between(1e-6, 1.0),
            _ => random.between(0.0, 180.0),
        };
        scene.camera.fov_deg = random.between(10.0, 120.0).min((30.0 / scene.camera.r).to_degrees());
        scene.observer.kind = match random.unit() {
            share if share < 0.4 => ObserverKind::Static,
            share if share < 0.6 => ObserverKind::Zamo,
            share if share < 0.8 => ObserverKind::Orbit,
            _ => ObserverKind::Rain,
        };
        if random.one_in(3) {
            let speed = 1.0 - random.log_between(1e-4, 1.0);
            let direction = DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            scene.observer.velocity = (speed * direction.normalize_or_zero()).to_array();
        }
        scene.disk.outer = random.log_between(2.0, 1e4);
        scene.disk.inner = scene.disk.outer * (1.0 - random.log_between(1e-5, 1.0)).max(1e-3);
        if scene.check().is_ok() && GpuScene::for_rays(&scene).is_ok() {
            return scene;
        }
    }
}
