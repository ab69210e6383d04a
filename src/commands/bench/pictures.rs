//! `lightfall bench --pictures`: the error of whole pictures against their run time.

use super::SAMPLE_SHARE;
use crate::commands::circumstances::circumstances_of;
use crate::commands::cli::BenchArgs;
use crate::commands::kept_rows::KeptRows;
use crate::commands::progress::Progress;
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_core::gpu::Gpu;
use lightfall_lab::bench::{
    BenchScene, PICTURE_SETTINGS, PictureError, PictureMeasurement, PictureSetting, Plan,
    TRUE_SAMPLES, measured_part, pictures_table, with_smooth_disk,
};
use lightfall_picture::{self as picture, HeadlessOptions, PictureError as Failure, Studio};

/// The passes that a picture's sampling decides.
const SAMPLING_PASSES: [&str; 4] = ["geodesic", "edges", "refine", "accumulate"];

/// Number of frames that a pass's time is the median of.
const TIMED_FRAMES: usize = 9;

/// Measures the error and the time of pictures, and prints and writes the report.
pub(super) fn bench_pictures(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let plan = &Plan {
        scenes: plan.scenes.iter().flat_map(with_smooth_disk).collect(),
        ..plan.clone()
    };
    let mut kept = KeptRows::open(&args.report, "pictures", circumstances_of(plan, gpu));
    let scenes = plan.scenes.len() - kept.rows().len() / PICTURE_SETTINGS.len();
    let work = scenes as f64 * frames_of_a_scene();
    let mut progress = Progress::new("bench", work, SAMPLE_SHARE * work);
    for scene in &plan.scenes {
        // The rows of a scene share the truth, which takes the longest, so they are kept together.
        let is_known = |row: &PictureMeasurement| row.scene == scene.name;
        if !kept.rows().iter().any(is_known) {
            let rows = measure_pictures(scene, plan.size, |setting| {
                let PictureSetting { antialias, samples } = setting;
                let refined = if antialias { ", edges refined" } else { "" };
                let task = format!("{}, {samples} frames{refined}", scene.name);
                progress.advance(task, f64::from(samples));
            })?;
            rows.into_iter().for_each(|row| kept.add(row));
        }
    }
    progress.finish();
    let rows = kept.rows();
    kept.finish(&rows, &pictures_table(&rows))
}

/// Number of frames that are drawn for the truth and all settings of a scene.
fn frames_of_a_scene() -> f64 {
    let frames = PICTURE_SETTINGS.iter().map(|setting| setting.samples);
    f64::from(TRUE_SAMPLES + frames.sum::<u32>())
}

/// Measures a scene's pictures of this size. `done` is called with each setting that has been drawn.
fn measure_pictures(
    bench_scene: &BenchScene,
    size: UVec2,
    mut done: impl FnMut(PictureSetting),
) -> Result<Vec<PictureMeasurement>, Stop> {
    let mut scene = bench_scene.scene.clone();
    (scene.picture.width, scene.picture.height) = (size.x, size.y);
    (scene.picture.grid_width, scene.picture.grid_height) = (size.x, size.y);
    let options = HeadlessOptions {
        timed: true,
        light: true,
        ..HeadlessOptions::default()
    };
    let single = PictureSetting::new(false, 1).of(&scene);
    let mut studio = Studio::with_options(&single, size, options).map_err(Stop::failed)?;
    let mut draw = |setting: PictureSetting| {
        let drawn = setting.of(&scene);
        studio.show(&drawn)?;
        let captured = studio.light()?;
        let part = measured_part([size.x, size.y]);
        let brightness = picture::brightness(&captured, part, drawn.picture.exposure_ev);
        let times = studio.time(TIMED_FRAMES)?;
        let frame_ms: f64 = times
            .iter()
            .filter(|time| SAMPLING_PASSES.contains(&time.pass.as_str()))
            .map(|time| time.median_ms)
            .sum();
        Ok((brightness, frame_ms * f64::from(setting.samples)))
    };
    let mut rows = Vec::new();
    let (truth, _) = draw(PictureSetting::TRUTH).map_err(|error: Failure| Stop::failed(error))?;
    done(PictureSetting::TRUTH);
    for setting in PICTURE_SETTINGS {
        let (brightness, picture_ms) = draw(setting).map_err(Stop::failed)?;
        let PictureSetting { antialias, samples } = setting;
        let one_ms = rows
            .first()
            .map_or(picture_ms, |one: &PictureMeasurement| one.picture_ms);
        done(setting);
        rows.push(PictureMeasurement {
            scene: bench_scene.name.clone(),
            antialias,
            samples,
            picture_ms,
            over_one: picture_ms / one_ms,
            error: PictureError::between(&brightness, &truth),
        });
    }
    Ok(rows)
}
