//! A random search, repeatable by its seed, for the ray that a method does worst.

use super::kernels::Kernels;
use super::random::Random;
use super::random_scene::random_scene;
use super::worst_ray::WorstRay;
use crate::accuracy::{Truth, rays_near_edge, rays_over_picture, rays_over_sky};
use crate::gpu::{Gpu, GpuError};
use std::cmp::Ordering;

/// Number of rays of one scene.
const RAYS_PER_SCENE: usize = 2000;
/// Distances of half of them from the shadow's edge, as shares of the shadow's radius: nearer than
/// in the usual sample.
const EDGE_DISTANCES: [f64; 2] = [1e-7, 0.3];

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
    #[must_use]
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
        let mut kernels = Kernels::default();
        let mut worst = Vec::new();
        for _ in 0..self.scenes() {
            let scene = random_scene(&mut random);
            let mut rays = rays_over_sky(RAYS_PER_SCENE / 4);
            rays.extend(rays_over_picture(&scene, RAYS_PER_SCENE / 4));
            rays.extend(rays_near_edge(&scene, RAYS_PER_SCENE / 2, EDGE_DISTANCES));
            let truth = Truth::of(&scene, rays)?;
            let traces = kernels.traces(gpu, &scene, &truth.rays)?;
            if let Some(ray) = WorstRay::of(&scene, &truth, &traces) {
                done(&ray);
                worst.push(ray);
            }
        }
        worst.sort_by(|a, b| b.rank().partial_cmp(&a.rank()).unwrap_or(Ordering::Equal));
        Ok(worst)
    }
}
