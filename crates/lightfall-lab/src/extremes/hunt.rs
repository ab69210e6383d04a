//! A random search, repeatable by its seed, for the ray with the largest error of a method.

use super::kernels::Kernels;
use super::random_scene::random_scene;
use super::worst_ray::WorstRay;
use lightfall_accuracy::{Truth, rays_near_edge, rays_over_picture, rays_over_sky};
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::random::Random;
use lightfall_model::scene::Scene;
use rayon::prelude::*;

const RAYS_PER_SCENE: usize = 2000;
/// Distances of half of them from the shadow's edge, as shares of the shadow's radius: nearer than
/// in the usual sample.
const HUNT_DISTANCES: [f64; 2] = [1e-7, 0.3];
/// Number of scenes that are judged in parallel. Most rays of a scene take much less time than its
/// few hard ones, so judging scenes in turn would leave most of a large machine idle.
const SCENES_AT_ONCE: usize = 16;

/// A random search for the ray with the largest error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hunt {
    /// Number of rays.
    pub rays: usize,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Hunt {
    /// The number of scenes that are searched.
    pub fn scenes(&self) -> usize {
        self.rays.div_ceil(RAYS_PER_SCENE)
    }

    /// Searches random scenes, each traced by `auto`'s method. `done` is called with each scene's
    /// worst ray. Returns these rays, unexplained ones first, then by decreasing error.
    ///
    /// # Errors
    /// The device failed.
    pub fn run(
        &self,
        gpu: &Gpu,
        mut done: impl FnMut(&WorstRay),
    ) -> Result<Vec<WorstRay>, GpuError> {
        let mut random = Random::new(self.seed);
        let scenes: Vec<Scene> = (0..self.scenes())
            .map(|_| random_scene(&mut random))
            .collect();
        let mut kernels = Kernels::default();
        let mut worst = Vec::new();
        for scenes in scenes.chunks(SCENES_AT_ONCE) {
            let truths: Vec<Result<Truth, _>> = scenes.par_iter().map(sample).collect();
            let mut answered = Vec::new();
            for (scene, truth) in scenes.iter().zip(truths) {
                let truth = truth?;
                let answers = kernels.traces(gpu, scene, &truth.rays)?;
                answered.push((scene, truth, answers));
            }
            let judged: Vec<Option<WorstRay>> = answered
                .par_iter()
                .map(|(scene, truth, answers)| WorstRay::of(scene, truth, answers))
                .collect();
            for ray in judged.into_iter().flatten() {
                done(&ray);
                worst.push(ray);
            }
        }
        worst.sort_by(|a, b| b.compare(a));
        Ok(worst)
    }
}

/// The rays of a scene, over its sky, over its picture and next to the shadow's edge, and the
/// reference's answers to them.
fn sample(scene: &Scene) -> Result<Truth, ObserverError> {
    let mut rays = rays_over_sky(RAYS_PER_SCENE / 4);
    rays.extend(rays_over_picture(scene, RAYS_PER_SCENE / 4));
    rays.extend(rays_near_edge(scene, RAYS_PER_SCENE / 2, HUNT_DISTANCES));
    Truth::of(scene, rays)
}
