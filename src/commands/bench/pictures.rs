//! `lightfall bench --pictures`: the error of whole pictures against their run time.

use crate::commands::stop::Stop;
use crate::picture::{self, HeadlessOptions, PictureError as Failure, Studio};
use glam::UVec2;
use lightfall_core::reports::bench::{
    BenchScene, PICTURE_SETTINGS, PictureError, PictureMeasurement, PictureSetting, measured_part,
};

/// The passes that a picture's sampling decides.
const SAMPLING_PASSES: [&str; 4] = ["geodesic", "edges", "refine", "accumulate"];

/// Number of frames that a pass's time is the median of.
const TIMED_FRAMES: usize = 9;

/// Measures a scene's pictures of this size.
pub(super) fn measure_pictures(
    bench_scene: &BenchScene,
    size: UVec2,
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
    eprintln!("lightfall: bench: {}, the truth", bench_scene.name);
    let (truth, _) = draw(PictureSetting::TRUTH).map_err(|error: Failure| Stop::failed(error))?;
    for setting in PICTURE_SETTINGS {
        let (brightness, picture_ms) = draw(setting).map_err(Stop::failed)?;
        let PictureError { rms, p99, max } = PictureError::between(&brightness, &truth);
        let PictureSetting { antialias, samples } = setting;
        let one_ms = rows
            .first()
            .map_or(picture_ms, |one: &PictureMeasurement| one.picture_ms);
        eprintln!(
            "lightfall: bench: {}, {samples} frames{}",
            bench_scene.name,
            if antialias { ", edges refined" } else { "" }
        );
        rows.push(PictureMeasurement {
            scene: bench_scene.name.clone(),
            antialias,
            samples,
            picture_ms,
            over_one: picture_ms / one_ms,
            rms,
            p99,
            max,
        });
    }
    Ok(rows)
}
