//! The errors of the article's methods with shorter steps, larger budgets, a larger radius of
//! escape and a smaller least step.

use super::plan::Plan;
use super::scenes::BenchScene;
use super::settings::able_methods;
use super::studies::{Refinement, Study, refinements};
use crate::import::{or_infinite, or_nan};
use crate::table::table;
use lightfall_accuracy::{ErrorSummary, Ray, Truth, rays_over_picture_and_near_edge};
use lightfall_gpu::rays::RayKernel;
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::numbers::{short_number, three_digits};
use lightfall_model::scene::{AccuracySetting, Method, Scene};
use serde::{Deserialize, Serialize};

/// The errors of one method at one setting of a series in one scene. Angles are in radians unless
/// their name ends in `_px`. The error of an unfinished ray is infinite, and null in JSON.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct RefinementMeasurement {
    /// Name of the scene.
    pub scene: String,
    /// Name of the method.
    pub method: String,
    /// What the series refines.
    pub study: Study,
    /// Scale of the steps.
    pub step_scale: f64,
    /// Budget of steps.
    pub max_steps: u32,
    /// Budget of affine length, in r_s.
    pub max_affine: f64,
    /// Radius of escape, in r_s.
    pub escape_radius: f64,
    /// Least step, in r_s.
    pub min_step: f64,
    /// Number of rays.
    pub rays: usize,
    /// Number of rays that the method gave up.
    pub unfinished: usize,
    /// Number of rays with a wrong outcome or number of hits.
    pub misclassified: usize,
    /// Forward error of the sky direction: its median.
    #[serde(deserialize_with = "or_nan")]
    pub sky_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub sky_p99: f64,
    /// Relative error of the radius of hits: its median.
    #[serde(deserialize_with = "or_nan")]
    pub hit_r_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub hit_r_p99: f64,
    /// Relative error of the g of hits: its median.
    #[serde(deserialize_with = "or_nan")]
    pub hit_g_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub hit_g_p99: f64,
    /// Backward error: its median.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p50: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p99: f64,
    /// Median of the backward error in pixels of the scene's picture.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p50_px: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_infinite")]
    pub backward_p99_px: f64,
    /// Mean number of steps.
    pub steps_mean: f64,
    /// Maximum number of steps.
    pub steps_max: f64,
}

impl RefinementMeasurement {
    fn new(name: &str, refinement: &Refinement, errors: &ErrorSummary) -> Self {
        let scene = &refinement.scene;
        let pixel = scene.pixel_angle();
        let [steps_mean, steps_max] = errors.steps;
        Self {
            scene: name.into(),
            method: scene.method.word().into(),
            study: refinement.study,
            step_scale: scene.quality.step_scale,
            max_steps: scene.quality.max_steps,
            max_affine: scene.quality.max_affine,
            escape_radius: scene.escape_radius(),
            min_step: scene.min_step(),
            rays: errors.rays,
            unfinished: errors.unfinished(),
            misclassified: errors.misclassified,
            sky_p50: errors.sky.p50,
            sky_p99: errors.sky.p99,
            hit_r_p50: errors.hit_r.p50,
            hit_r_p99: errors.hit_r.p99,
            hit_g_p50: errors.hit_g.p50,
            hit_g_p99: errors.hit_g.p99,
            backward_p50: errors.backward.p50,
            backward_p99: errors.backward.p99,
            backward_p50_px: errors.backward.p50 / pixel,
            backward_p99_px: errors.backward.p99 / pixel,
            steps_mean,
            steps_max,
        }
    }

    /// The number that the series refines, for people.
    pub fn label(&self) -> String {
        match self.study {
            Study::StepScale => three_digits(self.step_scale),
            Study::Budget => self.max_steps.to_string(),
            Study::EscapeRadius => three_digits(self.escape_radius),
            Study::LeastStep => three_digits(self.min_step),
        }
    }

    fn is_of(&self, name: &str, refinement: &Refinement) -> bool {
        let scene = &refinement.scene;
        let quality = &scene.quality;
        self.scene == name
            && self.method == scene.method.word()
            && self.study == refinement.study
            && self.max_steps == quality.max_steps
            && [self.step_scale, self.escape_radius, self.min_step]
                == [quality.step_scale, scene.escape_radius(), scene.min_step()]
    }
}

impl Plan {
    /// The methods of the plan that can be refined in a scene.
    pub fn refinable(&self, scene: &Scene) -> impl Iterator<Item = Method> {
        able_methods(scene, &self.methods)
            .filter(|method| method.properties().setting == AccuracySetting::StepScale)
    }

    fn refinements(&self, scene: &Scene) -> Vec<Vec<Refinement>> {
        let methods = self.refinable(scene);
        methods.map(|method| refinements(scene, method)).collect()
    }

    /// Number of rows of [`Plan::run_refinements`].
    pub fn refinement_rows(&self) -> usize {
        let all = self.scenes.iter();
        all.flat_map(|scene| self.refinements(&scene.scene))
            .map(|series| series.len())
            .sum()
    }

    /// Refines the article's methods, with the rays of [`Plan::run`], except the known rows of an
    /// earlier run. `done` is called after each new row. Returns all rows.
    ///
    /// # Errors
    /// A scene cannot be traced, or the device failed.
    pub fn run_refinements(
        &self,
        gpu: &Gpu,
        known: &[RefinementMeasurement],
        mut done: impl FnMut(&RefinementMeasurement),
    ) -> Result<Vec<RefinementMeasurement>, GpuError> {
        let mut rows = Vec::new();
        for BenchScene { name, scene } in &self.scenes {
            // Computed for the first row that is not known.
            let mut truth = None;
            for of_method in self.refinements(scene) {
                let mut kernel = None;
                for refinement in of_method {
                    let is_it = |row: &&RefinementMeasurement| row.is_of(name, &refinement);
                    if let Some(row) = known.iter().find(is_it) {
                        rows.push(row.clone());
                        continue;
                    }
                    let truth = match &mut truth {
                        Some(truth) => truth,
                        none => {
                            let rays = rays_over_picture_and_near_edge(scene, self.rays);
                            none.insert(Truth::of(scene, rays)?)
                        }
                    };
                    // All settings of a method share one shader.
                    let kernel = match &mut kernel {
                        Some(kernel) => kernel,
                        none => none.insert(RayKernel::new(gpu, &refinement.scene)?),
                    };
                    let given: Vec<_> = truth.rays.iter().map(Ray::given).collect();
                    let traces = kernel.trace_camera_rays(gpu, &refinement.scene, &given)?;
                    let errors = ErrorSummary::of(truth, &traces);
                    let row = RefinementMeasurement::new(name, &refinement, &errors);
                    done(&row);
                    rows.push(row);
                }
            }
        }
        Ok(rows)
    }
}

/// The rows as a Markdown table.
pub fn refinement_table(rows: &[RefinementMeasurement]) -> String {
    let cells = |row: &RefinementMeasurement| {
        let errors = [
            row.backward_p50_px,
            row.backward_p99_px,
            row.sky_p50,
            row.sky_p99,
            row.hit_r_p50,
            row.hit_r_p99,
            row.hit_g_p50,
            row.hit_g_p99,
        ];
        format!(
            "{} | {} | {} | {} | {} | {} | {} | {:.0}",
            row.scene,
            row.method,
            row.study.word(),
            row.label(),
            errors.map(short_number).join(" | "),
            row.misclassified,
            row.unfinished,
            row.steps_mean
        )
    };
    table(
        "scene | method | series | value | backward px, median | 99 % | sky rad, median | 99 % | \
         hit r, median | 99 % | hit g, median | 99 % | wrong class | given up | steps",
        rows.iter().map(cells),
    )
}
