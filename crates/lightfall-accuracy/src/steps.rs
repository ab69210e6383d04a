//! The number of steps that a method takes for a picture: the cost of its accuracy setting.

use crate::Ray;
use lightfall_gpu::rays::RayKernel;
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::scene::Scene;

/// The rays go through the centres of a grid with this many columns and rows.
const GRID: [u32; 2] = [48, 27];

/// The numbers of steps of a picture's rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepCount {
    /// Mean over the rays.
    pub mean: f64,
    /// Maximum over the rays.
    pub most: u32,
    /// Number of rays.
    pub rays: usize,
}

impl StepCount {
    /// Traces rays spread evenly over the picture on a GPU, and counts their steps.
    ///
    /// # Errors
    /// The GPU cannot trace the scene, or the device failed.
    pub fn of(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        let rays = Ray::over_grid(scene, GRID);
        let rays: Vec<_> = rays.iter().map(Ray::given).collect();
        let steps: Vec<u32> = RayKernel::new(gpu, scene)?
            .trace_camera_rays(gpu, scene, &rays)?
            .iter()
            .map(|trace| trace.steps)
            .collect();
        let sum: f64 = steps.iter().map(|steps| f64::from(*steps)).sum();
        let most = steps.iter().copied().max().unwrap_or_default();
        Ok(Self {
            mean: sum / steps.len().max(1) as f64,
            most,
            rays: steps.len(),
        })
    }
}
