//! The backward error all over a picture, on a coarse grid: what the view `error` shows.

use super::ray::Ray;
use super::truth::Truth;
use crate::gpu::rays::RayKernel;
use crate::gpu::{Gpu, GpuError};
use crate::optics::trace::Outcome;
use crate::scene::Scene;
use glam::DVec2;

/// Least error that is looked at closer, in pixels: what an answer is off by bounds its backward
/// error, and below this no eye tells one from the other.
const FINE: f64 = 1e-4;

/// The backward error of the GPU's answers to the rays through the middles of the cells of `grid`,
/// columns and rows, that the scene's picture is divided into: in pixels of that picture, rows from
/// the top; infinite where no turn of the ray explains the answer; none where the ray rightly ends
/// unseen at the horizon. Errors below a ten-thousandth of a pixel may be overstated, but not
/// beyond that.
///
/// # Errors
/// A scene that the GPU cannot trace, or a device that failed.
pub fn over_picture(
    gpu: &Gpu,
    scene: &Scene,
    grid: [u32; 2],
) -> Result<Vec<Option<f64>>, GpuError> {
    let size = DVec2::new(f64::from(grid[0]), f64::from(grid[1]));
    let picture = DVec2::new(
        f64::from(scene.picture.width),
        f64::from(scene.picture.height),
    );
    let places = (0..grid[1]).flat_map(|row| (0..grid[0]).map(move |column| [column, row]));
    let rays = places.map(|[column, row]| {
        let cell = DVec2::new(f64::from(column), f64::from(row)) + 0.5;
        Ray::toward(scene.camera.looking(cell / size * picture, picture))
    });
    let truth = Truth::of(scene, rays.collect())?;
    let directions: Vec<_> = truth.rays.iter().map(Ray::given).collect();
    let given = RayKernel::new(gpu, scene)?.trace(gpu, scene, &directions)?;
    let pixel = scene.camera.pixel_angle(picture.y);
    let errors = truth.judge_beyond(FINE * pixel, &given);
    let pixels = errors.iter().zip(&truth.traces).map(|(error, trace)| {
        let seen =
            error.misclassified || trace.outcome != Outcome::Captured || trace.hits[0].is_some();
        seen.then_some(error.backward / pixel)
    });
    Ok(pixels.collect())
}
