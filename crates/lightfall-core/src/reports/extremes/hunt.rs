//! A search at random, but from a seed, for the ray that a method does worst.

use super::{Cause, Kernels, tolerance};
use crate::accuracy::{RayError, Truth, rays_near_edge, rays_over_picture, rays_over_sky};
use crate::geometry::kerr::Kerr;
use crate::gpu::{Gpu, GpuError, GpuScene};
use crate::optics::trace::Trace;
use crate::scene::{Method, ObserverKind, Scene};
use glam::DVec3;
use std::cmp::Ordering;

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

/// A scene's worst ray: of those that nothing explains, if there are any.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Its scene, with the method.
    pub scene: Scene,
    /// Its direction on the observer's axes.
    pub direction: DVec3,
    /// Its backward error, in radians.
    pub backward: f64,
    /// The backward error over the method's bar.
    pub excess: f64,
    /// What explains an error beyond the bar.
    pub cause: Option<Cause>,
    /// How many of the scene's rays are beyond the bar.
    pub beyond: usize,
    /// How many of these nothing explains.
    pub unexplained: usize,
}

impl Hunt {
    /// How many scenes the hunt visits.
    #[must_use]
    pub fn scenes(&self) -> usize {
        self.rays.div_ceil(RAYS_A_SCENE)
    }

    /// Hunts with `auto`'s method in each scene; `done` is told of each scene's worst ray. The
    /// worst of all come back, the worst first, and those before all that nothing explains.
    ///
    /// # ErrorSummary
    /// A device that failed.
    pub fn run(&self, gpu: &Gpu, mut done: impl FnMut(&Found)) -> Result<Vec<Found>, GpuError> {
        let mut random = Random(self.seed);
        let mut kernels = Kernels::default();
        let mut worst = Vec::new();
        for _ in 0..self.scenes() {
            let scene = scene(&mut random);
            let mut rays = rays_over_sky(RAYS_A_SCENE / 4);
            rays.extend(rays_over_picture(&scene, RAYS_A_SCENE / 4));
            rays.extend(rays_near_edge(&scene, RAYS_A_SCENE / 2, [1e-7, 0.3]));
            let truth = Truth::of(&scene, rays)?;
            let traces = kernels.traces(gpu, &scene, &truth)?;
            if let Some(found) = Found::worst(&scene, &truth, &traces) {
                done(&found);
                worst.push(found);
            }
        }
        worst.sort_by(|a, b| b.rank().partial_cmp(&a.rank()).unwrap_or(Ordering::Equal));
        Ok(worst)
    }
}

impl Found {
    fn worst(scene: &Scene, truth: &Truth, traces: &[Trace]) -> Option<Self> {
        let bar = tolerance(scene).backward;
        let errors = truth.judge_to_precision(0.5 * bar, traces);
        let found = |(i, error): (usize, &RayError)| {
            let far = error.backward > bar;
            let cause = far
                .then(|| Cause::of(scene, truth, i, error.backward))
                .flatten();
            let direction = scene.camera.tetrad_from_camera() * truth.rays[i].direction();
            let unexplained = usize::from(far && cause.is_none());
            let (backward, excess, beyond) =
                (error.backward, error.backward / bar, usize::from(far));
            Self {
                scene: scene.clone(),
                direction,
                backward,
                excess,
                cause,
                beyond,
                unexplained,
            }
        };
        let (far, near): (Vec<_>, Vec<_>) = errors
            .iter()
            .enumerate()
            .partition(|(_, error)| error.backward > bar);
        if far.is_empty() {
            return near
                .into_iter()
                .max_by(|a, b| a.1.backward.total_cmp(&b.1.backward))
                .map(found);
        }
        let far: Vec<Self> = far.into_iter().map(found).collect();
        let (beyond, unexplained) = (far.len(), far.iter().map(|found| found.unexplained).sum());
        let worst = far
            .into_iter()
            .reduce(|a, b| if b.rank() > a.rank() { b } else { a })?;
        Some(Self {
            beyond,
            unexplained,
            ..worst
        })
    }

    /// What a ray is told by: whether nothing explains it, and how bad it is.
    fn rank(&self) -> (bool, f64) {
        (self.unexplained > 0, self.excess)
    }

    /// The command that traces this ray again, by the method and by the reference.
    #[must_use]
    pub fn command(&self) -> String {
        let DVec3 { x, y, z } = self.direction;
        let Scene {
            hole,
            camera,
            observer,
            disk,
            method,
            ..
        } = &self.scene;
        let kind = observer.kind.word();
        let [v_r, v_theta, v_phi] = observer.velocity;
        format!(
            "for device in gpu cpu; do echo {x:?},{y:?},{z:?} | lightfall trace --rays - --device $device --method {} \
             --spin {:?} --set camera.r={:?} --set camera.theta_deg={:?} --set camera.fov_deg={:?} --set observer.kind={kind} \
             --set 'observer.velocity=[{v_r:?},{v_theta:?},{v_phi:?}]' --set disk.inner={:?} --set disk.outer={:?}; done",
            method.word(),
            hole.spin,
            camera.r,
            camera.theta_deg,
            camera.fov_deg,
            disk.inner,
            disk.outer,
        )
    }

    /// What there is to say of this ray.
    #[must_use]
    pub fn verdict(&self) -> String {
        let told = format!("{:.2e} rad, {:.2} of its bar", self.backward, self.excess);
        let many = format!(
            "{} rays of the scene are beyond it, {} unexplained",
            self.beyond, self.unexplained
        );
        match &self.cause {
            _ if self.beyond == 0 => told,
            None => format!("{told}: UNEXPLAINED; {many}"),
            Some(Cause { input, backward }) => {
                format!(
                    "{told}: {input} moved by half a unit in f32's last place gives {backward:.2e} rad; {many}"
                )
            }
        }
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
        let horizon = Kerr {
            spin: scene.hole.spin,
        }
        .horizon();
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
