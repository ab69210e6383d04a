//! The matrix of cells and methods.

use super::cells::Cell;
use super::kernels::Kernels;
use super::verdict::{Verdict, tightest};
use crate::accuracy::{ErrorSummary, Truth};
use crate::gpu::{Gpu, GpuError};
use crate::reports::bench::methods_for;
use crate::scene::{Method, Scene};

/// Measures every method in every cell. `done` is called with each verdict.
///
/// # Errors
/// A cell cannot be traced, or the device failed.
pub fn measure_matrix(
    gpu: &Gpu,
    cells: &[Cell],
    methods: &[Method],
    mut done: impl FnMut(&Verdict),
) -> Result<Vec<Verdict>, GpuError> {
    let mut kernels = Kernels::default();
    let mut verdicts = Vec::new();
    for cell in cells {
        let truth = Truth::of(&cell.scene, cell.rays.clone())?;
        for scene in variations(&cell.scene, methods) {
            let verdict = Verdict::new(
                cell,
                &scene,
                &ErrorSummary::of(&truth, &kernels.traces(gpu, &scene, &truth)?),
            );
            done(&verdict);
            verdicts.push(verdict);
        }
    }
    Ok(verdicts)
}

/// The scene with each of the methods that can trace it, with mino twice: at the scene's setting
/// and at the tightest.
fn variations(scene: &Scene, methods: &[Method]) -> Vec<Scene> {
    let able = methods_for(scene)
        .into_iter()
        .filter(|method| methods.contains(method));
    able.flat_map(|method| {
        let tightest = (method == Method::Mino).then(|| tightest(scene));
        std::iter::once(Scene {
            method,
            ..scene.clone()
        })
        .chain(tightest)
    })
    .collect()
}

/// The number of verdicts that [`measure_matrix`] returns.
#[must_use]
pub fn verdict_count(cells: &[Cell], methods: &[Method]) -> usize {
    cells
        .iter()
        .map(|cell| variations(&cell.scene, methods).len())
        .sum()
}
