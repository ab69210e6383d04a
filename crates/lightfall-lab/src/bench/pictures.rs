//! The error of whole pictures against the time that their rays take: single rays, means of several
//! frames, and refined edges.

use super::scenes::BenchScene;
use crate::table::table;
use lightfall_model::scene::{DiskStructure, LimbDarkening, Scene, SkyMode};
use serde::{Deserialize, Serialize};

/// Frames of the truth: the mean of as many rays in every pixel, at the places of
/// [`pixel_offset`](lightfall_optics::pixel_samples::pixel_offset).
pub const TRUE_SAMPLES: u32 = 1024;

/// Width and height of the part of a picture 540 pixels high whose error is measured, about its
/// middle, in pixels.
const CROP_SIDE: u32 = 240;
const CROP_OF_HEIGHT: u32 = 540;

/// How a picture is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PictureSetting {
    /// Whether edges are refined.
    pub antialias: bool,
    /// Frames that are averaged.
    pub samples: u32,
}

/// What is measured: single rays and means of frames, without and with refined edges.
pub const PICTURE_SETTINGS: [PictureSetting; 7] = [
    PictureSetting::new(false, 1),
    PictureSetting::new(false, 4),
    PictureSetting::new(false, 16),
    PictureSetting::new(false, 64),
    PictureSetting::new(true, 1),
    PictureSetting::new(true, 4),
    PictureSetting::new(true, 16),
];

impl PictureSetting {
    /// A setting.
    pub const fn new(antialias: bool, samples: u32) -> Self {
        Self { antialias, samples }
    }

    /// The setting of the truth.
    pub const TRUTH: Self = Self::new(false, TRUE_SAMPLES);

    /// The scene with this setting, without the effects that do not depend on rays through pixels:
    /// stars, bloom, and an exposure that depends on the picture.
    pub fn of(self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        scene.sky.mode = SkyMode::Off;
        scene.sky.reference_star = false;
        scene.picture.bloom = 0.0;
        scene.picture.automatic_exposure = false;
        scene.picture.antialias = self.antialias;
        scene.picture.samples = self.samples;
        scene
    }
}

/// The scene, and in front of it the same with a smooth disk, where its disk has structure: what is
/// left of the error of refined edges is mostly that of the structure's filter.
pub fn with_smooth_disk(bench_scene: &BenchScene) -> Vec<BenchScene> {
    let mut smooth = BenchScene {
        name: format!("{}-smooth", bench_scene.name),
        ..bench_scene.clone()
    };
    smooth.scene.disk.structure = DiskStructure::None;
    smooth.scene.disk.limb = LimbDarkening::None;
    let has_structure =
        bench_scene.scene.disk.enabled && bench_scene.scene.disk.structure != DiskStructure::None;
    has_structure
        .then_some(smooth)
        .into_iter()
        .chain([bench_scene.clone()])
        .collect()
}

/// The error of a part of a picture: of the brightness that a screen shows, from 0 to 1, at each
/// pixel.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
pub struct PictureError {
    /// Root of the mean of its square.
    pub rms: f64,
    /// Its 99th percentile.
    pub p99: f64,
    /// Its maximum.
    pub max: f64,
}

impl PictureError {
    /// The difference of the brightness of one part of two pictures; NaN where there is no pixel.
    pub fn between(found: &[f64], truth: &[f64]) -> Self {
        let mut errors: Vec<f64> = found
            .iter()
            .zip(truth)
            .map(|(a, b)| (a - b).abs())
            .collect();
        errors.sort_by(f64::total_cmp);
        let squares: f64 = errors.iter().map(|error| error * error).sum();
        let at = |share: f64| {
            let index = (errors.len().saturating_sub(1) as f64 * share).round() as usize;
            errors.get(index).copied().unwrap_or(f64::NAN)
        };
        Self {
            rms: (squares / errors.len() as f64).sqrt(),
            p99: at(0.99),
            max: at(1.0),
        }
    }
}

/// The part of a picture of this size whose error is measured: its left, top, width and height, in
/// pixels.
pub fn measured_part([width, height]: [u32; 2]) -> [u32; 4] {
    let side = (height * CROP_SIDE / CROP_OF_HEIGHT).clamp(1, width.min(height).max(1));
    [(width - side) / 2, (height - side) / 2, side, side]
}

/// A picture's error and time.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct PictureMeasurement {
    /// Name of the scene.
    pub scene: String,
    /// Whether edges are refined.
    pub antialias: bool,
    /// Frames that are averaged.
    pub samples: u32,
    /// Time of all passes that trace, refine and average, in all frames, in milliseconds.
    pub picture_ms: f64,
    /// The same over that of one ray a pixel.
    pub over_one: f64,
    /// The error.
    #[serde(flatten)]
    pub error: PictureError,
}

/// The rows as a Markdown table.
pub fn pictures_table(rows: &[PictureMeasurement]) -> String {
    let cells = |row: &PictureMeasurement| {
        let rays = if row.antialias {
            "edges refined"
        } else {
            "single rays"
        };
        let PictureError { rms, p99, max } = row.error;
        format!(
            "{} | {rays} | {} | {:.2} | {:.2} | {rms:.4} | {p99:.4} | {max:.3}",
            row.scene, row.samples, row.picture_ms, row.over_one
        )
    };
    table(
        "scene | rays | frames | ms | over one ray | rms error | 99 % | largest",
        rows.iter().map(cells),
    )
}
