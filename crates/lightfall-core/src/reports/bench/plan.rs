//! What is measured, and how.

use super::measurement::Measurement;
use super::scenes::{BenchScene, scenes};
use super::settings::{Setting, methods_for, settings};
use crate::accuracy::{EDGE_DISTANCES, Ray, Truth, rays_near_edge, rays_over_picture};
use crate::gpu::rays::RayKernel;
use crate::gpu::timing::{Effort, Stage, Stopwatch};
use crate::gpu::{Gpu, GpuError};
use crate::reports::work::ray_work;
use crate::scene::{Method, Scene};
use glam::UVec2;
use std::time::Duration;

/// What is measured, and how thoroughly.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The scenes.
    pub scenes: Vec<BenchScene>,
    /// The methods. Each scene is measured with those of them that can trace it.
    pub methods: Vec<Method>,
    /// Size of the picture whose rays are timed, in pixels.
    pub size: UVec2,
    /// The pipeline stage that traces the timed rays.
    pub stage: Stage,
    /// How many samples of the time are taken.
    pub effort: Effort,
    /// Number of rays whose error is measured: half of them spread over the picture, half near the
    /// shadow's edge.
    pub rays: usize,
    /// Whether each method is measured at a few settings only.
    pub few_settings: bool,
}

impl Plan {
    /// A thorough plan for all built-in scenes and methods, or a quick one.
    #[must_use]
    pub fn new(quick: bool) -> Self {
        Self {
            scenes: scenes(),
            methods: Method::on_gpu(),
            size: if quick {
                UVec2::new(160, 90)
            } else {
                UVec2::new(1920, 1080)
            },
            stage: Stage::Compute,
            effort: Effort {
                min_samples: if quick { 3 } else { 5 },
                max_time: Duration::from_millis(if quick { 30 } else { 300 }),
            },
            rays: if quick { 512 } else { 8192 },
            few_settings: quick,
        }
    }

    /// Number of rows of the report.
    #[must_use]
    pub fn len(&self) -> usize {
        self.scenes
            .iter()
            .map(|scene| self.rows_of(scene).len())
            .sum()
    }

    /// Whether there is nothing to measure.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The part of the time that all methods share, in milliseconds: setting photons up and writing
    /// results, measured with straight lines and no disk.
    ///
    /// # Errors
    /// The picture is too large for the device, or the device failed.
    pub fn floor(&self, gpu: &Gpu) -> Result<f64, GpuError> {
        let mut scene = Scene::default();
        scene.effects.lensing = false;
        scene.disk.enabled = false;
        let stopwatch = Stopwatch::new(gpu, &scene, self.size, self.stage)?;
        Ok(stopwatch.time(gpu, self.effort)?.median_ms)
    }

    /// The work of everything that is measured, in the unit of [`ray_work`].
    #[must_use]
    pub fn work(&self) -> f64 {
        (0..self.scenes.len())
            .map(|scene| self.work_of_scene(scene))
            .sum()
    }

    /// The work of all rows of the scene with this index, or zero if there is none.
    #[must_use]
    pub fn work_of_scene(&self, index: usize) -> f64 {
        let rows = self.scenes.get(index).map(|scene| self.rows_of(scene));
        let work = |setting: &Setting| ray_work(&setting.scene);
        rows.iter().flatten().map(work).sum()
    }

    fn rows_of(&self, bench_scene: &BenchScene) -> Vec<Setting> {
        let methods = methods_for(&bench_scene.scene)
            .into_iter()
            .filter(|method| self.methods.contains(method));
        methods
            .flat_map(|method| settings(&bench_scene.scene, method, self.few_settings))
            .collect()
    }

    /// Measures everything. `done` is called after each step.
    ///
    /// # Errors
    /// A scene cannot be traced, the picture is too large for the device, or the device failed.
    pub fn run(
        &self,
        gpu: &Gpu,
        mut done: impl FnMut(&Step),
    ) -> Result<Vec<Measurement>, GpuError> {
        let mut rows = Vec::new();
        for bench_scene in &self.scenes {
            let mut rays = rays_over_picture(&bench_scene.scene, self.rays - self.rays / 2);
            rays.extend(rays_near_edge(
                &bench_scene.scene,
                self.rays / 2,
                EDGE_DISTANCES,
            ));
            let truth = Truth::of(&bench_scene.scene, rays)?;
            let given: Vec<_> = truth.rays.iter().map(Ray::given).collect();
            let mut compiled: Option<(Method, Stopwatch, RayKernel)> = None;
            let mut answers = Vec::new();
            // Everything is timed before any error is computed: a GPU that waits for the CPU lowers
            // its clock.
            for setting in self.rows_of(bench_scene) {
                let scene = &setting.scene;
                // All settings of a method share one shader.
                let (_, stopwatch, kernel) = match &mut compiled {
                    Some(compiled) if compiled.0 == scene.method => compiled,
                    other => other.insert((
                        scene.method,
                        Stopwatch::new(gpu, scene, self.size, self.stage)?,
                        RayKernel::new(gpu, scene)?,
                    )),
                };
                stopwatch.set_scene(gpu, scene)?;
                let timing = stopwatch.time(gpu, self.effort)?;
                let traces = kernel.trace_camera_rays(gpu, scene, &given)?;
                done(&Step::new(bench_scene, &setting, false));
                answers.push((setting, timing, traces));
            }
            for (setting, timing, traces) in answers {
                let row = Measurement::new(&bench_scene.name, &setting, timing, &truth, &traces);
                done(&Step::new(bench_scene, &setting, true));
                rows.push(row);
            }
        }
        Ok(rows)
    }
}

/// One step of a plan: a setting has been timed, or its error has been computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Name of the scene.
    pub scene: String,
    /// The method with its setting.
    pub setting: String,
    /// Whether the error has been computed too, which completes the row.
    pub completes_row: bool,
    /// Its share of [`Plan::work`], in the same unit.
    pub work: f64,
}

impl Step {
    fn new(bench_scene: &BenchScene, setting: &Setting, completes_row: bool) -> Self {
        Self {
            scene: bench_scene.name.clone(),
            setting: setting.label(),
            completes_row,
            work: 0.5 * ray_work(&setting.scene),
        }
    }
}
