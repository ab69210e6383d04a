//! Camera paths: `lightfall camera`, and the option `--camera` of `lightfall render`.

use super::cli::CameraArgs;
use super::output::print;
use super::scene::{journey_of_frames, on_stage, scene};
use super::stop::Stop;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::camera_path::CameraPath;
use lightfall_core::scene::{Scene, resized};
use lightfall_picture::Sequence;
use lightfall_platform::log::say;
use lightfall_platform::storage::{self, NewFile, WriteError};
use rayon::prelude::*;
use std::io::{BufWriter, Write};
use std::path::Path;

/// Scenes that exist at the same time, so that a long path does not fill the memory.
const SCENES_AT_ONCE: usize = 1024;

/// Writes the camera path of a journey, without drawing.
pub(super) fn camera(args: &CameraArgs) -> Result<(), Stop> {
    check_file(&args.out)?;
    let scene_args = on_stage(&args.scene, args.journey.as_deref())?;
    let mut scene = scene(&scene_args)?;
    if let Some(size) = args.size {
        scene.picture = resized(&scene.picture, size);
        scene
            .check()
            .map_err(|refusal| Stop::refused(format!("--size: {refusal}")))?;
    }
    let journey = journey_of_frames(args.journey.as_deref(), args.fps, &scene)?;
    let frames = args.frames;
    let sequence = Sequence::new(journey, frames, args.fps, &args.out).map_err(Stop::refused)?;
    let numbers: Vec<u32> = (frames.first..=frames.last).collect();
    let path = path_of(&numbers, args.fps, &scene, |number| {
        sequence.scene(&scene, number)
    })?;
    write_path(&args.out, &path)?;
    print(&format!("{}\n", args.out.display()))
}

/// The camera path of the frames with these numbers, whose pictures have the shape of that of `scene`. `get`
/// gives the scene of a frame. Where the exposure is automatic, each frame is metered.
///
/// # Errors
/// The first frame that cannot be drawn, and why.
pub(super) fn path_of(
    numbers: &[u32],
    fps: f64,
    scene: &Scene,
    get: impl Fn(u32) -> Scene + Sync,
) -> Result<CameraPath, Stop> {
    let size = scene.picture.size().as_dvec2();
    let mut path = CameraPath::new(fps, size.x / size.y);
    let exposed = |&number: &u32| -> Result<(u32, Scene), Stop> {
        let drawable = Drawable::new(get(number))
            .map_err(|reason| Stop::refused(format!("frame {number}: {reason}")))?;
        Ok((number, drawable.exposed().into_scene()))
    };
    for some in numbers.chunks(SCENES_AT_ONCE) {
        let scenes: Vec<_> = some.par_iter().map(&exposed).collect();
        for found in scenes {
            let (number, scene) = found?;
            path.add(number, &scene);
        }
    }
    Ok(path)
}

/// Writes a camera path to a file, whose name says the format. The file appears under its name only when it
/// is complete.
///
/// # Errors
/// The name says no format, or the file cannot be written.
pub(super) fn write_path(file: &Path, path: &CameraPath) -> Result<(), Stop> {
    let form = PathForm::of(file)?;
    if form == PathForm::Usd && path.is_beyond_usd() {
        say(format_args!(
            "lightfall: {}: USD has cameras of perspective pictures alone; this one has the place and the turn of \
             the camera, and camera.fov_deg",
            file.display()
        ));
    }
    let mut new = NewFile::create(file).map_err(Stop::failed)?;
    let mut out = BufWriter::new(new.file());
    let written = match form {
        PathForm::Csv => path.write_csv(&mut out),
        PathForm::Usd => path.write_usd(&mut out),
    };
    written
        .and_then(|()| out.flush())
        .map_err(|error| Stop::failed(WriteError::new(file, error)))?;
    drop(out);
    new.finish().map_err(Stop::failed)
}

/// Checks that a camera path can be written to a file, before any work is done for it.
///
/// # Errors
/// The name says no format, or the file cannot be written.
pub(super) fn check_file(file: &Path) -> Result<(), Stop> {
    PathForm::of(file)?;
    storage::check_writable(file).map_err(Stop::failed)
}

/// The format of a camera path.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PathForm {
    /// A table.
    Csv,
    /// A camera in USD, as text.
    Usd,
}

impl PathForm {
    /// The format that the ending of a file's name says.
    fn of(file: &Path) -> Result<Self, Stop> {
        let extension = file.extension().unwrap_or_default().to_string_lossy();
        match extension.to_ascii_lowercase().as_str() {
            "csv" => Ok(Self::Csv),
            "usda" => Ok(Self::Usd),
            "" => Err(Stop::refused(format!(
                "{}: the name has no extension that says which form the camera path has; allowed are .csv and .usda",
                file.display()
            ))),
            _ => Err(Stop::refused(format!(
                "{}: unknown form of a camera path {extension:?}; allowed are .csv and .usda",
                file.display()
            ))),
        }
    }
}
