//! The plan of a measurement.

use super::measurement::Measurement;
use super::scenes::{BenchScene, scenes};
use super::settings::{Setting, able_methods, settings};
use crate::work::ray_work;
use glam::UVec2;
use lightfall_accuracy::{Ray, Truth, rays_over_picture_and_near_edge};
use lightfall_gpu::rays::RayKernel;
use lightfall_gpu::timing::{Effort, Stage, Stopwatch, Timing};
use lightfall_gpu::{Gpu, GpuError};
use lightfall_model::scene::{Method, Scene};
use lightfall_optics::trace::Trace;
use std::time::Duration;

/// The scenes, methods and settings of a measurement, and its effort.
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
    pub fn len(&self) -> usize {
        self.scenes
            .iter()
            .map(|scene| self.rows_of(scene).len())
            .sum()
    }

    /// Whether there is nothing to measure.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The time that all methods share, in milliseconds, for making photons and writing results:
    /// measured with straight lines and no disk.
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

    /// The work of measuring the rows of each scene that are not known, in the unit of
    /// [`ray_work`].
    pub fn work(&self, known: &[Measurement]) -> Vec<f64> {
        let work = |scene: &BenchScene| {
            let left = self.rows_of(scene).into_iter();
            let left = left.filter(|setting| find(known, scene, setting).is_none());
            left.map(|setting| ray_work(&setting.scene)).sum()
        };
        self.scenes.iter().map(work).collect()
    }

    fn rows_of(&self, bench_scene: &BenchScene) -> Vec<Setting> {
        let scene = &bench_scene.scene;
        able_methods(scene, &self.methods)
            .flat_map(|method| settings(scene, method, self.few_settings))
            .collect()
    }

    /// Measures everything except the known rows of an earlier run. `done` is called after each
    /// step. Returns all rows.
    ///
    /// # Errors
    /// A scene cannot be traced, the picture is too large for the device, or the device failed.
    pub fn run(
        &self,
        gpu: &Gpu,
        known: &[Measurement],
        mut done: impl FnMut(&Step),
    ) -> Result<Vec<Measurement>, GpuError> {
        let mut rows = Vec::new();
        for bench_scene in &self.scenes {
            let all = self.rows_of(bench_scene);
            let row_of = |setting: &Setting| find(known, bench_scene, setting).cloned();
            let known_rows: Option<Vec<Measurement>> = all.iter().map(row_of).collect();
            if let Some(known_rows) = known_rows {
                rows.extend(known_rows);
                continue;
            }
            let rays = rays_over_picture_and_near_edge(&bench_scene.scene, self.rays);
            let truth = Truth::of(&bench_scene.scene, rays)?;
            let given: Vec<_> = truth.rays.iter().map(Ray::given).collect();
            let mut compiled: Option<(Method, Stopwatch, RayKernel)> = None;
            let mut answers = Vec::new();
            // Everything is timed before any error is computed: a GPU that waits for the CPU lowers
            // its clock.
            for setting in all {
                if let Some(row) = row_of(&setting) {
                    answers.push(Answer::Known(Box::new(row)));
                    continue;
                }
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
                done(&Step::new(bench_scene, &setting, None));
                answers.push(Answer::New(Box::new(setting), timing, traces));
            }
            for answer in answers {
                rows.push(match answer {
                    Answer::Known(row) => *row,
                    Answer::New(setting, timing, traces) => {
                        let name = &bench_scene.name;
                        let row = Measurement::new(name, &setting, timing, &truth, &traces);
                        done(&Step::new(bench_scene, &setting, Some(&row)));
                        row
                    }
                });
            }
        }
        Ok(rows)
    }
}

/// The known row of a scene at a setting.
fn find<'a>(
    known: &'a [Measurement],
    bench_scene: &BenchScene,
    setting: &Setting,
) -> Option<&'a Measurement> {
    known.iter().find(|row| {
        row.scene == bench_scene.name
            && row.method == setting.scene.method.word()
            && row.setting.as_deref() == setting.key
            && row.value == setting.key.map(|_| setting.value)
    })
}

/// A row whose error is still to be computed, or one that an earlier run has measured.
enum Answer {
    Known(Box<Measurement>),
    New(Box<Setting>, Timing, Vec<Trace>),
}

/// One step of a plan: a setting has been timed, or its error has been computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Name of the scene.
    pub scene: String,
    /// The method with its setting.
    pub setting: String,
    /// The row, if the error has been computed too, which completes it.
    pub row: Option<Measurement>,
    /// Its share of [`Plan::work`], in the same unit.
    pub work: f64,
}

impl Step {
    fn new(bench_scene: &BenchScene, setting: &Setting, row: Option<&Measurement>) -> Self {
        Self {
            scene: bench_scene.name.clone(),
            setting: setting.label(),
            row: row.cloned(),
            work: 0.5 * ray_work(&setting.scene),
        }
    }
}
