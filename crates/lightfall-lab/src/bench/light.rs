//! The cost of a living disk: the run time of a picture's light with structure, limb darkening and
//! the delay that structure needs, over that of the smooth disk.

use super::plan::Plan;
use super::scenes::BenchScene;
use super::settings::able_methods;
use crate::table::table;
use lightfall_gpu::timing::{Stage, Stopwatch, Timing};
use lightfall_gpu::{Gpu, GpuError, Variant};
use lightfall_model::scene::{DiskStructure, HotSpotKind, LimbDarkening, Method, Scene, SkyMode};
use serde::{Deserialize, Serialize};

/// The run time of one method in one scene.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct LightMeasurement {
    /// Name of the scene.
    pub scene: String,
    /// Name of the method.
    pub method: String,
    /// Median time of a smooth disk's light, in milliseconds.
    pub smooth_ms: f64,
    /// The same with structure of the scene's own number of waves, and limb darkening.
    pub living_ms: f64,
    /// The second over the first.
    pub ratio: f64,
    /// Difference between the 90th and the 10th percentile of the second, in milliseconds.
    pub living_spread_ms: f64,
    /// The clock that the times were read from.
    pub clock: String,
}

impl Plan {
    /// The scenes with a disk, each with the methods of the plan that can trace it.
    fn lit_scenes(&self) -> impl Iterator<Item = (&BenchScene, Method)> {
        let with_disk = self.scenes.iter().filter(|scene| scene.scene.disk.enabled);
        with_disk.flat_map(|bench_scene| {
            let methods = able_methods(&bench_scene.scene, &self.methods);
            methods.map(move |method| (bench_scene, method))
        })
    }

    /// Number of rows of [`Plan::run_light`].
    pub fn light_rows(&self) -> usize {
        self.lit_scenes().count()
    }

    /// Times the light of every scene with a disk, under the procedural sky where it has real
    /// stars, except the known rows of an earlier run. `done` is called after each new row. Returns
    /// all rows.
    ///
    /// # Errors
    /// A scene cannot be traced, the picture is too large for the device, or the device failed.
    pub fn run_light(
        &self,
        gpu: &Gpu,
        known: &[LightMeasurement],
        mut done: impl FnMut(&LightMeasurement),
    ) -> Result<Vec<LightMeasurement>, GpuError> {
        let mut rows = Vec::new();
        for (bench_scene, method) in self.lit_scenes() {
            let is_it = |row: &&LightMeasurement| {
                row.scene == bench_scene.name && row.method == method.word()
            };
            if let Some(row) = known.iter().find(is_it) {
                rows.push(row.clone());
                continue;
            }
            let row = self.light(gpu, bench_scene, method)?;
            done(&row);
            rows.push(row);
        }
        Ok(rows)
    }

    fn light(
        &self,
        gpu: &Gpu,
        bench_scene: &BenchScene,
        method: Method,
    ) -> Result<LightMeasurement, GpuError> {
        let mut smooth = bench_scene.scene.with_method(method);
        // The article's stars are drawn by each ray. Real ones need passes of their own, and maps of
        // the sky need textures, which nothing that is timed alone reads.
        if smooth.sky.mode.is_map() {
            smooth.sky.mode = SkyMode::Procedural;
        }
        let mut living = smooth.clone();
        smooth.disk.structure = DiskStructure::None;
        smooth.disk.limb = LimbDarkening::None;
        smooth.hot_spot.kind = HotSpotKind::None;
        living.disk.limb = LimbDarkening::ElectronScattering;
        if living.disk.structure == DiskStructure::None {
            living.disk.structure = DiskStructure::Turbulent;
        }
        let time = |scene: &Scene| -> Result<Timing, GpuError> {
            let variant = Variant::timed_light(scene);
            Stopwatch::of_variant(gpu, variant, scene, self.size, Stage::Compute)?
                .time(gpu, self.effort)
        };
        let (smooth, living) = (time(&smooth)?, time(&living)?);
        Ok(LightMeasurement {
            scene: bench_scene.name.clone(),
            method: method.word().into(),
            smooth_ms: smooth.median_ms,
            living_ms: living.median_ms,
            ratio: living.median_ms / smooth.median_ms,
            living_spread_ms: living.spread_ms,
            clock: living.clock.word().into(),
        })
    }
}

/// The rows as a Markdown table.
pub fn light_table(rows: &[LightMeasurement]) -> String {
    let cells = |row: &LightMeasurement| {
        format!(
            "{} | {} | {:.4} | {:.4} | {:.2}",
            row.scene, row.method, row.smooth_ms, row.living_ms, row.ratio
        )
    };
    table(
        "scene | method | smooth, ms | living, ms | ratio",
        rows.iter().map(cells),
    )
}
