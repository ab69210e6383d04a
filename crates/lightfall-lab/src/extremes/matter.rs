//! The light of matter with depth in the hardest places, against the f64 twin's.

use super::cells::Cell;
use crate::import::or_nan;
use crate::medium::{PassageKernels, Soundness, TrueLight};
use crate::table::table;
use lightfall_accuracy::rays_over_picture;
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::numbers::short_number;
use lightfall_model::scene::DiskStructure;
use serde::{Deserialize, Serialize};

/// The light of a cell.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct MatterVerdict {
    /// What is extreme.
    pub cell: String,
    /// Number of rays.
    pub rays: usize,
    /// Number of rays with light.
    pub lit: usize,
    /// Number of rays that were given up.
    pub unfinished: usize,
    /// Number of rays whose light is no finite number, or negative.
    pub not_finite: usize,
    /// Error of the light, relative to the larger of the ray's light and a hundredth of the 95th percentile
    /// of the cell's rays or of the scene's picture, whichever is brighter: its median. Absent for matter
    /// with structure, whose filaments fall between the nodes of single rays.
    #[serde(deserialize_with = "or_nan")]
    pub light_p50: f64,
    /// Its 95th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub light_p95: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub light_p99: f64,
    /// The largest.
    #[serde(deserialize_with = "or_nan")]
    pub light_max: f64,
    /// quality.max_error_light, which the 95th percentile must not exceed.
    pub bar: f64,
    /// Mean number of samples of a ray that meets the matter.
    #[serde(deserialize_with = "or_nan")]
    pub samples: f64,
    /// Whether every ray has an answer, and the errors are within the bar.
    pub holds: bool,
}

/// Measures the light of every cell. `done` is called with each verdict.
///
/// # Errors
/// A cell cannot be traced, or the device failed.
pub fn measure_matter(
    gpu: &Gpu,
    cells: &[Cell],
    mut done: impl FnMut(&MatterVerdict),
) -> Result<Vec<MatterVerdict>, GpuError> {
    let mut kernels = PassageKernels::default();
    let mut verdicts = Vec::new();
    for cell in cells {
        let verdict = verdict(gpu, &mut kernels, cell)?;
        done(&verdict);
        verdicts.push(verdict);
    }
    Ok(verdicts)
}

fn verdict(
    gpu: &Gpu,
    kernels: &mut PassageKernels,
    Cell {
        name, scene, rays, ..
    }: &Cell,
) -> Result<MatterVerdict, GpuError> {
    let found = kernels.passages(gpu, scene, rays)?;
    let Soundness {
        not_finite,
        unfinished,
        samples,
    } = Soundness::of(&found);
    let smooth = scene.disk.structure == DiskStructure::None && !scene.jets_move();
    let truth = smooth.then(|| {
        let picture = rays_over_picture(scene, rays.len());
        TrueLight::of(scene, rays, &picture)
    });
    let errors = truth.flatten().map(|truth| truth.errors(&found));
    let of = |value: fn(&lightfall_accuracy::LightErrors) -> f64| {
        errors.as_ref().map_or(f64::NAN, value)
    };
    let lit = found.iter().filter(|seen| seen.light.max_element() > 0.0);
    let bar = scene.quality.max_error_light;
    Ok(MatterVerdict {
        cell: name.clone(),
        rays: rays.len(),
        lit: errors.map_or_else(|| lit.count(), |errors| errors.lit),
        unfinished,
        not_finite,
        light_p50: of(|errors| errors.p50),
        light_p95: of(|errors| errors.p95),
        light_p99: of(|errors| errors.p99),
        light_max: of(|errors| errors.max),
        bar,
        samples,
        holds: unfinished == 0
            && not_finite == 0
            && !rays.is_empty()
            && (!smooth || of(|errors| errors.p95) <= bar),
    })
}

/// The verdicts as a Markdown table.
pub fn matter_table(verdicts: &[MatterVerdict]) -> String {
    let cells = |verdict: &MatterVerdict| {
        let errors = [
            verdict.light_p50,
            verdict.light_p95,
            verdict.light_p99,
            verdict.light_max,
        ];
        format!(
            "{} | {} | {} | {} | {} | {} | {:.1} | {}",
            verdict.cell,
            verdict.rays,
            verdict.lit,
            verdict.unfinished,
            verdict.not_finite,
            errors.map(short_number).join(" | "),
            verdict.samples,
            if verdict.holds {
                "holds"
            } else {
                "DOES NOT HOLD"
            },
        )
    };
    table(
        "cell | rays | with light | unfinished | not a number | median error | 95 % | 99 % | largest | \
         samples a ray | verdict",
        verdicts.iter().map(cells),
    )
}
