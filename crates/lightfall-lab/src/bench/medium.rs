//! The error of light from matter with depth against the run time, and the time of disks with
//! thickness and of jets over that of a sheet.

use super::plan::Plan;
use crate::import::or_nan;
use crate::medium::{PassageKernels, Soundness, TrueLight, jet_scene, thick_scene};
use crate::table::table;
use lightfall_accuracy::{LightErrors, rays_over_picture};
use lightfall_gpu::timing::{Stage, Stopwatch, Timing};
use lightfall_gpu::{Gpu, GpuError, Variant};
use lightfall_model::numbers::short_number;
use lightfall_model::scene::{DiskStructure, LimbDarkening, Method, Scene};
use serde::{Deserialize, Serialize};
use std::cell::LazyCell;

/// The largest errors that are asked for: those with three, four, eight and twelve nodes in a chunk of a
/// disk, and with four, six, nine and twelve in a quarter of a jet.
const MAX_ERRORS: [f64; 4] = [0.1, 0.012, 0.002, 0.0001];

/// The number of waves of the living disks.
const WAVES: u32 = 24;

/// Light of one kind of matter with one number of nodes in one scene.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct MediumMeasurement {
    /// Name of the scene.
    pub scene: String,
    /// What the matter is: `smooth` or `living`, or `thin`, a living disk without thickness and jets.
    pub disk: String,
    /// quality.max_error_light; absent for the thin disk.
    #[serde(deserialize_with = "or_nan")]
    pub max_error: f64,
    /// Number of nodes in a chunk or in a quarter of a jet; 0 for the thin disk.
    pub nodes: u32,
    /// Whether pictures use this number, because the scene does not set an error.
    pub own: bool,
    /// Median time of the picture's light, in milliseconds.
    pub light_ms: f64,
    /// Difference between the 90th and the 10th percentile of that time, in milliseconds.
    pub light_spread_ms: f64,
    /// The clock that the times were read from.
    pub clock: String,
    /// Number of rays whose light was compared; 0 for matter with structure.
    pub rays: usize,
    /// Number of those with light.
    pub lit: usize,
    /// Number of rays whose light is no finite number, or negative.
    pub not_finite: usize,
    /// Number of rays that were given up.
    pub unfinished: usize,
    /// Mean number of samples of a ray that meets the matter.
    #[serde(deserialize_with = "or_nan")]
    pub samples: f64,
    /// Error of the light, relative to the larger of the ray's light and a hundredth of the picture's
    /// 95th percentile: its median.
    #[serde(deserialize_with = "or_nan")]
    pub light_p50: f64,
    /// Its 95th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub light_p95: f64,
    /// Its 99th percentile.
    #[serde(deserialize_with = "or_nan")]
    pub light_p99: f64,
}

impl MediumMeasurement {
    /// The time relative to that of the same scene's thin disk, which is another of these rows. NaN if
    /// none of them has it.
    pub fn time_over_thin(&self, rows: &[Self]) -> f64 {
        let is_thin = |row: &&Self| row.disk == Subject::THIN && row.scene == self.scene;
        let thin = rows.iter().find(is_thin);
        thin.map_or(f64::NAN, |thin| self.light_ms / thin.light_ms)
    }
}

/// A scene of the measurement, and what is asked of it.
struct Subject {
    name: &'static str,
    disk: &'static str,
    scene: Scene,
}

impl Subject {
    const THIN: &str = "thin";
    const SMOOTH: &str = "smooth";
    const LIVING: &str = "living";

    /// Every disk and error of a scene: the thin one first.
    fn of_scene(name: &'static str, scene: &Scene) -> Vec<Self> {
        let subject = |disk, max_error: Option<f64>| {
            let mut scene = scene.with_method(Method::Mino);
            scene.disk.limb = LimbDarkening::ElectronScattering;
            if disk != Self::SMOOTH {
                (scene.disk.structure, scene.disk.waves) = (DiskStructure::Turbulent, WAVES);
            }
            match disk {
                Self::THIN => (scene.disk.thickness, scene.jet.enabled) = (0.0, false),
                Self::SMOOTH => scene.jet.knots = 0.0,
                _ => {}
            }
            if let Some(max_error) = max_error {
                scene.quality.max_error_light = max_error;
            }
            Self { name, disk, scene }
        };
        let smooth = MAX_ERRORS.map(|error| subject(Self::SMOOTH, Some(error)));
        [subject(Self::THIN, None)]
            .into_iter()
            .chain(smooth)
            .chain([subject(Self::LIVING, None)])
            .collect()
    }

    fn nodes(&self) -> u32 {
        nodes(&self.scene)
    }

    /// Whether a scene that sets no error has these nodes.
    fn is_own(&self) -> bool {
        let mut unset = self.scene.clone();
        unset.quality = Scene::default().quality;
        nodes(&unset) == self.nodes()
    }

    fn is(&self, row: &MediumMeasurement) -> bool {
        (row.scene.as_str(), row.disk.as_str(), row.nodes) == (self.name, self.disk, self.nodes())
    }
}

/// The nodes in a chunk of the scene's disk or, where it has no thickness, in a quarter of a jet.
fn nodes(scene: &Scene) -> u32 {
    let variant = Variant::timed_light(scene);
    match variant.medium_nodes {
        0 => variant.jet_nodes,
        nodes => nodes,
    }
}

/// The scenes: edge-on, from above, from near by, as opaque as a disk may be, and jets with a sheet.
fn scenes() -> [(&'static str, Scene); 5] {
    [
        ("edge-on", thick_scene(0.9, [20.0, 83.0], 0.06, 12.0)),
        ("60-degrees", thick_scene(0.9, [20.0, 60.0], 0.1, 3.0)),
        ("close", thick_scene(0.9, [6.5, 80.0], 0.06, 12.0)),
        ("depth-200", thick_scene(0.0, [20.0, 83.0], 0.05, 200.0)),
        ("jets", jet_scene(0.9, [30.0, 70.0])),
    ]
}

impl Plan {
    /// Number of rows of [`Plan::run_medium`].
    pub fn medium_rows(&self) -> usize {
        let rows = scenes().map(|(name, scene)| Subject::of_scene(name, &scene).len());
        rows.into_iter().sum()
    }

    /// Measures the light of matter with depth, except the known rows of an earlier run. `done` is
    /// called after each new row. Returns all rows.
    ///
    /// # Errors
    /// The picture is too large for the device, or the device failed.
    pub fn run_medium(
        &self,
        gpu: &Gpu,
        known: &[MediumMeasurement],
        mut done: impl FnMut(&MediumMeasurement),
    ) -> Result<Vec<MediumMeasurement>, GpuError> {
        let mut rows = Vec::new();
        for (name, scene) in scenes() {
            let subjects = Subject::of_scene(name, &scene);
            // All smooth rows of a scene have one truth, which only a row that is not known needs.
            let smooth = subjects
                .iter()
                .find(|subject| subject.disk == Subject::SMOOTH);
            let smooth = smooth.map(|subject| subject.scene.clone());
            let truth = LazyCell::new(move || {
                let rays = rays_over_picture(smooth.as_ref()?, self.rays);
                TrueLight::of(smooth.as_ref()?, &rays, &rays)
            });
            for subject in subjects {
                if let Some(row) = known.iter().find(|row| subject.is(row)) {
                    rows.push(row.clone());
                    continue;
                }
                let row = self.medium_row(gpu, &subject, &truth)?;
                done(&row);
                rows.push(row);
            }
        }
        Ok(rows)
    }

    fn medium_row(
        &self,
        gpu: &Gpu,
        subject: &Subject,
        truth: &LazyCell<Option<TrueLight>, impl FnOnce() -> Option<TrueLight>>,
    ) -> Result<MediumMeasurement, GpuError> {
        let scene = &subject.scene;
        let variant = Variant::timed_light(scene);
        let stopwatch = Stopwatch::of_variant(gpu, variant, scene, self.size, Stage::Compute)?;
        let timing = stopwatch.time(gpu, self.effort)?;
        let mut row = MediumMeasurement::timed(subject, timing);
        if subject.disk == Subject::SMOOTH {
            let rays = rays_over_picture(scene, self.rays);
            let found = PassageKernels::default().passages(gpu, scene, &rays)?;
            if let Some(truth) = &**truth {
                row.add(rays.len(), Soundness::of(&found), truth.errors(&found));
            }
        }
        Ok(row)
    }
}

impl MediumMeasurement {
    fn timed(subject: &Subject, timing: Timing) -> Self {
        Self {
            scene: subject.name.into(),
            disk: subject.disk.into(),
            max_error: if subject.disk == Subject::THIN {
                f64::NAN
            } else {
                subject.scene.quality.max_error_light
            },
            nodes: subject.nodes(),
            own: subject.is_own(),
            light_ms: timing.median_ms,
            light_spread_ms: timing.spread_ms,
            clock: timing.clock.word().into(),
            rays: 0,
            lit: 0,
            not_finite: 0,
            unfinished: 0,
            samples: f64::NAN,
            light_p50: f64::NAN,
            light_p95: f64::NAN,
            light_p99: f64::NAN,
        }
    }

    fn add(&mut self, rays: usize, sound: Soundness, errors: LightErrors) {
        self.rays = rays;
        (self.not_finite, self.unfinished) = (sound.not_finite, sound.unfinished);
        self.samples = sound.samples;
        self.lit = errors.lit;
        [self.light_p50, self.light_p95, self.light_p99] = [errors.p50, errors.p95, errors.p99];
    }
}

/// The rows as a Markdown table, with each time relative to the thin disk's.
pub fn medium_table(rows: &[MediumMeasurement]) -> String {
    let cells = |row: &MediumMeasurement| {
        let errors = [row.light_p50, row.light_p95, row.light_p99].map(short_number);
        let (nodes, samples) = match row.rays {
            0 => (String::new(), String::new()),
            _ => (row.nodes.to_string(), format!("{:.1}", row.samples)),
        };
        format!(
            "{} | {} | {nodes}{} | {samples} | {:.4} | {:.2} | {} | {} | {}",
            row.scene,
            row.disk,
            if row.own && row.rays > 0 {
                " (own)"
            } else {
                ""
            },
            row.light_ms,
            row.time_over_thin(rows),
            errors.join(" | "),
            row.unfinished,
            row.not_finite,
        )
    };
    table(
        "scene | disk | nodes | samples a ray | ms | over thin | median error | 95 % | 99 % | unfinished | \
         not a number",
        rows.iter().map(cells),
    )
}
