//! Error against run time: for each scene, method and setting, how long tracing takes and how wrong
//! it is.

mod equal;
mod frontier;
mod labels;
mod measured;
mod plot;
mod sweep;
mod table;

pub use equal::{AtEqualError, at_equal_error};
pub use frontier::{Margin, auto_margin, is_on_front};
pub use measured::Measured;
pub use plot::plot;
pub use sweep::{Setting, methods_for, settings};
pub use table::short;
pub use table::{Circumstances, csv, json, markdown};

use crate::accuracy::{Truth, rays_near_edge, rays_over_picture};
use crate::gpu::rays::RayKernel;
use crate::gpu::timing::{Effort, Stage, Stopwatch};
use crate::gpu::{Gpu, GpuError};
use crate::scene::{Method, Override, Scene, presets};
use glam::UVec2;
use std::time::Duration;

/// Distances from the shadow's edge of a critical sample, as shares of its radius.
pub const CRITICAL: [f64; 2] = [1e-6, 0.3];

/// A scene that is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// Its name in the report.
    pub name: String,
    /// The scene, whatever its method.
    pub scene: Scene,
}

/// What is to be measured, and how thoroughly.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Which scenes.
    pub subjects: Vec<Subject>,
    /// Which methods; each scene takes those that can trace it.
    pub methods: Vec<Method>,
    /// Rays that are timed: those of a picture of this size.
    pub size: UVec2,
    /// Which stage of the pipeline traces the timed rays.
    pub stage: Stage,
    /// How many runs are timed.
    pub effort: Effort,
    /// Rays that are judged, half of them all over the picture, half next to the shadow's edge.
    pub rays: usize,
    /// Whether each method takes its named settings only.
    pub few_settings: bool,
}

impl Plan {
    /// A thorough plan for all built-in scenes and methods, or a quick one.
    #[must_use]
    pub fn new(quick: bool) -> Self {
        Self {
            subjects: subjects(),
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

    /// How many rows there will be.
    #[must_use]
    pub fn len(&self) -> usize {
        self.subjects
            .iter()
            .map(|subject| self.rows_of(subject).len())
            .sum()
    }

    /// Whether there is nothing to measure.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Time of a run that every method's contains: photons set up and answers written for straight
    /// lines without a disk, in milliseconds.
    ///
    /// # ErrorSummary
    /// A device that failed.
    pub fn floor(&self, gpu: &Gpu) -> Result<f64, GpuError> {
        let mut scene = Scene::default();
        scene.effects.lensing = false;
        scene.disk.enabled = false;
        let stopwatch = Stopwatch::new(gpu, &scene, self.size, self.stage)?;
        Ok(stopwatch.time(gpu, self.effort)?.median_ms)
    }

    fn rows_of(&self, subject: &Subject) -> Vec<Setting> {
        let methods = methods_for(&subject.scene)
            .into_iter()
            .filter(|method| self.methods.contains(method));
        methods
            .flat_map(|method| settings(&subject.scene, method, self.few_settings))
            .collect()
    }

    /// Measures everything; `done` is told of each row as it is measured.
    ///
    /// # ErrorSummary
    /// A device that failed; a scene that cannot be traced, which no scene of the program is.
    pub fn run(
        &self,
        gpu: &Gpu,
        mut done: impl FnMut(&Measured),
    ) -> Result<Vec<Measured>, GpuError> {
        let mut all = Vec::new();
        for subject in &self.subjects {
            let mut rays = rays_over_picture(&subject.scene, self.rays - self.rays / 2);
            rays.extend(rays_near_edge(&subject.scene, self.rays / 2, CRITICAL));
            let truth = Truth::of(&subject.scene, rays)?;
            let given: Vec<_> = truth.rays.iter().map(crate::accuracy::Ray::given).collect();
            let mut made: Option<(Method, Stopwatch, RayKernel)> = None;
            let mut answers = Vec::new();
            // All is timed before anything is judged: a GPU that waits for the CPU in between
            // lowers its clocks.
            for setting in self.rows_of(subject) {
                let scene = &setting.scene;
                // A method's settings share one shader.
                let (_, stopwatch, kernel) = match &mut made {
                    Some(made) if made.0 == scene.method => made,
                    other => other.insert((
                        scene.method,
                        Stopwatch::new(gpu, scene, self.size, self.stage)?,
                        RayKernel::new(gpu, scene)?,
                    )),
                };
                stopwatch.set_scene(gpu, scene)?;
                let timing = stopwatch.time(gpu, self.effort)?;
                let traces = kernel.trace(gpu, scene, &given)?;
                answers.push((setting, timing, traces));
            }
            for (setting, timing, traces) in answers {
                let measured = Measured::new(&subject.name, &setting, timing, &truth, &traces);
                done(&measured);
                all.push(measured);
            }
        }
        Ok(all)
    }
}

/// The scenes of the program: its presets, and the spinning twin of preset 2.
#[must_use]
pub fn subjects() -> Vec<Subject> {
    let preset = |preset: &presets::Preset, name: &str, overrides: &[Override]| {
        preset.scene(overrides).ok().map(|scene| Subject {
            name: name.into(),
            scene,
        })
    };
    let twin = Override {
        option: "--set",
        key: "hole.spin".into(),
        value: "0.9".into(),
    };
    let spinning = presets::PRESETS
        .iter()
        .filter(|preset| preset.number == presets::DEFAULT);
    let spinning = spinning.filter_map(|found| {
        preset(
            found,
            &format!("{}-spinning", found.name),
            std::slice::from_ref(&twin),
        )
    });
    presets::PRESETS
        .iter()
        .filter_map(|found| preset(found, found.name, &[]))
        .chain(spinning)
        .collect()
}
