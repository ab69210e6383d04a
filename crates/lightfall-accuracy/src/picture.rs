//! The backward errors of a picture on a coarse grid, which the view `error` shows.

use super::ray::Ray;
use super::truth::Truth;
use lightfall_gpu::rays::RayKernel;
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::scene::Scene;
use lightfall_optics::trace::Outcome;

/// Precision of the errors, in pixels: the view does not distinguish smaller ones.
const PRECISION_PX: f64 = 1e-4;

/// The backward errors of the GPU's answers to the rays through the centres of a grid of cells
/// (columns and rows) that divides the scene's picture: in pixels of the picture, rows from the
/// top.
///
/// An error is infinite if no turn of the ray explains the answer, and `None` if the ray correctly
/// ends at the horizon without a hit, so that nothing is seen. Errors below a ten-thousandth of a
/// pixel are upper bounds.
///
/// # Errors
/// The GPU cannot trace the scene, or the device failed.
pub fn picture_errors(
    gpu: &Gpu,
    scene: &Scene,
    grid: [u32; 2],
) -> Result<Vec<Option<f64>>, GpuError> {
    let truth = Truth::of(scene, Ray::over_grid(scene, grid))?;
    let directions: Vec<_> = truth.rays.iter().map(Ray::given).collect();
    let given = RayKernel::new(gpu, scene)?.trace_camera_rays(gpu, scene, &directions)?;
    let pixel = scene.pixel_angle();
    let errors = truth.judge_to_precision(PRECISION_PX * pixel, &given);
    let pixels = errors.iter().zip(&truth.traces).map(|(error, trace)| {
        let seen =
            error.misclassified || trace.outcome != Outcome::Captured || trace.hits[0].is_some();
        seen.then_some(error.backward / pixel)
    });
    Ok(pixels.collect())
}
