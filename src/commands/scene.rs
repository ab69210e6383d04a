//! The scene and the journey that a command line asks for.

use super::cli::SceneArgs;
use super::stop::Stop;
use super::unused::note_idle_journey;
use lightfall_core::gpu;
use lightfall_core::gpu::{AdapterName, Drawable, Gpu};
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::journey::Journey;
use lightfall_core::scene::{Override, Scene, presets};
use lightfall_platform::log::say;
use lightfall_platform::storage;
use lightfall_platform::storage::Opened;
use std::path::Path;

/// The option that names a preset or a mission, in errors.
const OPTION: &str = "--preset";

/// The scene that the options describe.
///
/// # Errors
/// A preset that does not exist, cannot be read or is wrong; or a wrong override.
pub fn scene(args: &SceneArgs) -> Result<Scene, Stop> {
    let overrides = args.overrides().map_err(Stop::refused)?;
    match &args.preset {
        None => default_scene(&overrides),
        Some(preset) => Ok(storage::scene_by_name(OPTION, preset, &overrides)?),
    }
}

/// The scene or the mission that the options describe.
///
/// # Errors
/// As those of [`scene`], and a mission that is wrong.
pub fn opened(args: &SceneArgs) -> Result<Opened, Stop> {
    let overrides = args.overrides().map_err(Stop::refused)?;
    opened_with(args, &overrides)
}

/// The scene that the options name, or that of a mission's start, with these overrides in place of the
/// options' own.
pub(super) fn scene_with(args: &SceneArgs, overrides: &[Override]) -> Result<Scene, Stop> {
    let (scene, _) = opened_with(args, overrides)?.into_parts();
    Ok(scene)
}

fn opened_with(args: &SceneArgs, overrides: &[Override]) -> Result<Opened, Stop> {
    match &args.preset {
        None => default_scene(overrides).map(|scene| Opened::Scene(Box::new(scene))),
        Some(preset) => Ok(storage::open_by_name(OPTION, preset, overrides)?),
    }
}

fn default_scene(overrides: &[Override]) -> Result<Scene, Stop> {
    let preset = presets::PRESETS[presets::DEFAULT - 1];
    preset.scene(overrides).map_err(Stop::refused)
}

/// The options with the preset of a lesson, where they name a lesson and no preset: its stops are about
/// that scene.
///
/// # Errors
/// The journey cannot be read or is wrong.
pub(super) fn on_stage(args: &SceneArgs, journey: Option<&Path>) -> Result<SceneArgs, Stop> {
    let mut args = args.clone();
    let file = journey.filter(|file| *file != Path::new(NO_JOURNEY) && args.preset.is_none());
    if let Some(file) = file {
        let journey = storage::journey_by_name(file)?;
        let preset = journey.preset.filter(|_| !journey.stops.is_empty());
        args.preset = preset.map(|preset| preset.name.into());
    }
    Ok(args)
}

/// The word that stands for no journey where pictures are rendered.
pub(super) const NO_JOURNEY: &str = "none";

/// The journey of a file through `scene`, or the built-in journey.
///
/// # Errors
/// The file cannot be read or is wrong, or a part of the journey cannot be flown in `scene`.
pub fn journey(file: Option<&Path>, scene: &Scene) -> Result<Journey, Stop> {
    match file {
        Some(file) => journey_in(file, storage::journey_by_name(file)?, scene),
        None => Ok(storage::read_journey(None, scene)?),
    }
}

/// As [`journey`], with so many frames a second in a camera path that counts frames. `None` if the file is the
/// word for no journey.
///
/// # Errors
/// As those of [`journey`].
pub(super) fn journey_of_frames(
    file: Option<&Path>,
    fps: f64,
    scene: &Scene,
) -> Result<Option<Journey>, Stop> {
    match file {
        Some(file) if file == Path::new(NO_JOURNEY) => Ok(None),
        Some(file) => journey_in(file, storage::journey_at_rate(file, fps)?, scene).map(Some),
        None => journey(None, scene).map(Some),
    }
}

/// A journey that was read, for `scene`. `file` is its file or its name.
///
/// # Errors
/// A part of the journey cannot be flown in `scene`.
pub(super) fn journey_in(file: &Path, journey: Journey, scene: &Scene) -> Result<Journey, Stop> {
    let journey = storage::flyable_journey(file, journey, scene)?;
    note_idle_journey(file, &journey, scene);
    Ok(journey)
}

/// The stars that the options name, or the built-in catalogue. The program has one catalogue as long
/// as it runs.
///
/// # Errors
/// The file cannot be read or is wrong.
pub(super) fn stars(args: &SceneArgs) -> Result<&'static Catalogue, Stop> {
    match &args.stars {
        None => Ok(Catalogue::built_in()),
        Some(file) => {
            let catalogue = storage::read_stars(file)
                .map_err(|error| Stop::refused(format!("--stars {error}")))?;
            for remark in catalogue.remarks() {
                say(format_args!(
                    "lightfall: --stars {}: {remark}",
                    file.display()
                ));
            }
            Ok(Box::leak(Box::new(catalogue)))
        }
    }
}

/// Says so if the preset is in a picture of other stars than these. Returns the sentence.
pub(super) fn note_missing_stars(
    args: &SceneArgs,
    scene: &Scene,
    stars: &Catalogue,
) -> Option<String> {
    let remark = storage::missing_stars(args.preset.as_deref()?, scene, stars)?;
    say(format_args!("lightfall: {remark}"));
    Some(remark)
}

/// Checks that the scene can be drawn, and that there is a graphics device. Says so where it is
/// another one than was to be expected.
pub(super) fn drawable(scene: &Scene) -> Result<Drawable, Stop> {
    let drawable = Drawable::new(scene.clone()).map_err(Stop::refused)?;
    let adapter = gpu::working_adapter().map_err(Stop::without_device)?;
    if !adapter.failures.is_empty() {
        say(format_args!(
            "lightfall: using {}, because another adapter cannot be used: {}",
            adapter.description,
            adapter.failures.join("; ")
        ));
    }
    storage::note_adapter(adapter.description);
    storage::note_scene(scene);
    Ok(drawable)
}

/// Opens a device for rays, without a window.
pub(super) fn device() -> Result<Gpu, Stop> {
    let gpu = Gpu::headless().map_err(Stop::without_device)?;
    storage::note_adapter(AdapterName::of(&gpu.info).to_string());
    Ok(gpu)
}
