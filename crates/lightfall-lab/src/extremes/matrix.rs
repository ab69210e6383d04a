//! The matrix of cells and methods.

use super::cells::Cell;
use super::kernels::Kernels;
use super::verdict::{Verdict, tightest};
use crate::bench::able_methods;
use crate::work::ray_work;
use lightfall_accuracy::Truth;
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::scene::{Method, Scene};

/// Measures every method in every cell. `done` is called with each verdict and its share of the
/// [`matrix_work`].
///
/// # Errors
/// A cell cannot be traced, or the device failed.
pub fn measure_matrix(
    gpu: &Gpu,
    cells: &[Cell],
    methods: &[Method],
    mut done: impl FnMut(&Verdict, f64),
) -> Result<Vec<Verdict>, GpuError> {
    let mut kernels = Kernels::default();
    let mut verdicts = Vec::new();
    for cell in cells {
        let truth = Truth::of(&cell.scene, cell.rays.clone())?;
        for scene in variations(&cell.scene, methods) {
            let given = kernels.traces(gpu, &scene, &truth.rays)?;
            let verdict = Verdict::new(cell, &scene, &truth, &given);
            done(&verdict, work_of(cell, &scene));
            verdicts.push(verdict);
        }
    }
    Ok(verdicts)
}

/// The scene with each of the methods that can trace it, with mino twice: at the scene's setting
/// and at the tightest.
fn variations(scene: &Scene, methods: &[Method]) -> Vec<Scene> {
    let scenes = able_methods(scene, methods).flat_map(|method| {
        let tightest = (method == Method::Mino).then(|| tightest(scene));
        [scene.with_method(method)].into_iter().chain(tightest)
    });
    scenes.collect()
}

/// The work of measuring these methods in these cells, in any unit.
pub fn matrix_work(cells: &[Cell], methods: &[Method]) -> f64 {
    let work = |cell: &Cell| -> f64 {
        let scenes = variations(&cell.scene, methods);
        scenes.iter().map(|scene| work_of(cell, scene)).sum()
    };
    cells.iter().map(work).sum()
}

pub(super) fn work_of(cell: &Cell, scene: &Scene) -> f64 {
    cell.rays.len() as f64 * ray_work(scene)
}
