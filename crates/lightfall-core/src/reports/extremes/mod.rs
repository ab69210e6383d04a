//! Where methods break: a matrix of the hardest places, each method held against a stated tolerance, and
//! a search at random for what the matrix forgot.

mod cause;
mod cells;
mod grid;
mod hunt;
mod verdict;

pub use cause::Cause;
pub use cells::{Cell, cells};
pub use grid::grid;
pub use hunt::{Found, Hunt};
pub use verdict::{Tolerance, Verdict, markdown, tolerance};

use super::bench::methods_for;
use crate::accuracy::{ErrorSummary, Ray, Truth};
use crate::gpu::rays::RayKernel;
use crate::gpu::{Gpu, GpuError, Variant};
use crate::optics::trace::Trace;
use crate::scene::{Method, Scene};
use std::collections::HashMap;

/// Compiled shaders by variant: most cells share a few.
#[derive(Default)]
struct Kernels(HashMap<Variant, RayKernel>);

impl Kernels {
    /// What the scene's method answers to the rays of `truth`.
    fn traces(&mut self, gpu: &Gpu, scene: &Scene, truth: &Truth) -> Result<Vec<Trace>, GpuError> {
        let given: Vec<_> = truth.rays.iter().map(Ray::given).collect();
        let kernel = match self.0.entry(Variant::rays(scene)) {
            std::collections::hash_map::Entry::Occupied(known) => known.into_mut(),
            std::collections::hash_map::Entry::Vacant(new) => {
                new.insert(RayKernel::new(gpu, scene)?)
            }
        };
        kernel.trace(gpu, scene, &given)
    }
}

/// Measures every method in every cell; `done` is told of each verdict.
///
/// # ErrorSummary
/// A device that failed; a cell that cannot be traced, which none of the program's is.
pub fn run(
    gpu: &Gpu,
    cells: &[Cell],
    methods: &[Method],
    mut done: impl FnMut(&Verdict),
) -> Result<Vec<Verdict>, GpuError> {
    let mut kernels = Kernels::default();
    let mut all = Vec::new();
    for cell in cells {
        let truth = Truth::of(&cell.scene, cell.rays.clone())?;
        for scene in variations(&cell.scene, methods) {
            let verdict = Verdict::new(
                cell,
                &scene,
                &ErrorSummary::of(&truth, &kernels.traces(gpu, &scene, &truth)?),
            );
            done(&verdict);
            all.push(verdict);
        }
    }
    Ok(all)
}

/// The scene by each of the methods that can trace it, by mino twice.
fn variations(scene: &Scene, methods: &[Method]) -> Vec<Scene> {
    let able = methods_for(scene)
        .into_iter()
        .filter(|method| methods.contains(method));
    able.flat_map(|method| {
        let tightest = (method == Method::Mino).then(|| verdict::tightest(scene));
        std::iter::once(Scene {
            method,
            ..scene.clone()
        })
        .chain(tightest)
    })
    .collect()
}

/// How many verdicts there will be.
#[must_use]
pub fn verdicts(cells: &[Cell], methods: &[Method]) -> usize {
    cells
        .iter()
        .map(|cell| variations(&cell.scene, methods).len())
        .sum()
}
