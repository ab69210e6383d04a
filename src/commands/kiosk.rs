//! `lightfall --kiosk`: a window for the visitors of an exhibition.

use super::cli::{FlyArgs, SceneArgs, first_given};
use super::console::{close_own_console, show_no_box};
use super::fly::{open, placement};
use super::glyphs::note_lacking;
use super::scene::{drawable, note_missing_stars, opened, stars};
use super::stop::Stop;
use super::unused::{note_idle_journey, note_idle_preset, note_unused};
use crate::app;
use crate::app::{Exhibition, NO_SOUND, Show, Start};
use bevy::app::App;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::{FLIGHTS, Journey};
use lightfall_core::scene::{Output, Scene};
use lightfall_platform::log::say;
use lightfall_platform::storage;
use lightfall_platform::storage::Opened;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Seconds without a visitor after which the window goes back to its start.
const IDLE_SECONDS: u16 = 60;

/// Checks that the options of a window go together.
///
/// # Errors
/// One that has no meaning without `--kiosk`, or one that has none with it.
pub fn check_options(args: &FlyArgs) -> Result<(), Stop> {
    let is_kiosk = args.kiosk.is_some();
    let faults = [
        (
            "--idle is for --kiosk, whose window goes back to its start after so many seconds without a visitor",
            !is_kiosk && args.idle.is_some(),
        ),
        (
            "--volume is for --kiosk; other windows have Volume on the page Settings of the panel",
            !is_kiosk && args.volume.is_some(),
        ),
        (
            "--journey is for a window without --kiosk, which names its journeys itself: --kiosk FILE",
            is_kiosk && args.journey.is_some(),
        ),
        (
            "--shaders is for work on the shaders, and --kiosk for visitors: one of the two can be used",
            is_kiosk && args.shaders.is_some(),
        ),
    ];
    first_given(faults).map_or(Ok(()), |sentence| Err(Stop::refused(sentence)))
}

/// Shows journeys to visitors, with an addition to the window program.
pub(super) fn show(
    args: &FlyArgs,
    journeys: &[PathBuf],
    addition: impl FnOnce(&mut App),
) -> Result<(), Stop> {
    show_no_box();
    let shows = shows(&args.scene, journeys)?;
    let Some(first) = shows.first() else {
        return Err(Stop::refused("--kiosk needs a journey"));
    };
    // The window begins with the scene of the first journey.
    let mut scene_args = args.scene.clone();
    if scene_args.preset.is_none() {
        scene_args.preset = Some((&first.scene.name).into());
    }
    let stars = stars(&scene_args)?;
    let first_drawn = drawable(&first.scene)?;
    if let Err(reason) = app::display() {
        return Err(Stop::failed(format!(
            "no display ({reason}): --kiosk needs a screen for its visitors"
        )));
    }
    note_idle_preset(args.scene.preset.as_deref(), &first.scene);
    note_unused(
        &scene_args,
        &first.scene,
        Output::Window,
        |without| without,
        |_| None,
    );
    // The window itself says nothing of it to visitors.
    note_missing_stars(&scene_args, &first.scene, stars);
    for Show { journey, .. } in &shows {
        note_lacking(
            format_args!("the journey {:?}", journey.title),
            journey.texts(),
        );
    }
    if args.fullscreen {
        say(format_args!(
            "lightfall: --fullscreen changes nothing: --kiosk covers the whole screen"
        ));
    }
    let volume = f64::from(args.volume.unwrap_or(0)) / 100.0;
    if let Some(note) = NO_SOUND.filter(|_| volume > 0.0) {
        say(format_args!("lightfall: --volume changes nothing: {note}"));
    }
    close_own_console();
    let start = Start::new(first_drawn, first.journey.clone());
    let start = Start {
        stars,
        keeps_own_look: scene_args.sets("picture.bypass").map_err(Stop::refused)?,
        shaders: None,
        placement: placement(args),
        exhibition: Some(Exhibition {
            shows,
            idle: Duration::from_secs(args.idle.unwrap_or(IDLE_SECONDS).into()),
            volume,
        }),
        ..start
    };
    open(start, addition)
}

/// The journeys with these names or files, each in its scene: that of the options where they name a preset,
/// else that of the preset that the journey names, changed as the options say. Without names, the guided
/// journey and the built-in ones without stops.
///
/// # Errors
/// A journey or a scene is wrong, or a part of a journey cannot be flown in its scene.
pub fn shows(args: &SceneArgs, journeys: &[PathBuf]) -> Result<Vec<Show>, Stop> {
    let scene = scene_of_options(args)?;
    let show = |file: &Path, journey: Journey| -> Result<Show, Stop> {
        let scene = match journey.preset {
            Some(preset) if args.preset.is_none() => {
                let overrides = args.overrides().map_err(Stop::refused)?;
                preset.scene(&overrides).map_err(Stop::refused)?
            }
            _ => scene.clone(),
        };
        Drawable::new(scene.clone()).map_err(Stop::refused)?;
        let journey = storage::flyable_journey(file, journey, &scene)?;
        note_idle_journey(file, &journey, &scene);
        Ok(Show::new(scene, journey))
    };
    if !journeys.is_empty() {
        let named = journeys.iter();
        return named
            .map(|file| show(file, storage::journey_by_name(file)?))
            .collect();
    }
    let guided = storage::read_journey(None, &scene)?;
    let others = FLIGHTS.iter().map(|(name, _)| Path::new(*name));
    let others = others.map(|name| show(name, storage::journey_by_name(name)?));
    std::iter::once(show(Path::new("the guided journey"), guided))
        .chain(others)
        .collect()
}

/// The scene that the options name.
fn scene_of_options(args: &SceneArgs) -> Result<Scene, Stop> {
    let named = args.preset.clone().unwrap_or_default();
    let named = named.display();
    match opened(args)? {
        Opened::Scene(scene) => Ok(*scene),
        Opened::Journey(_) => Err(Stop::refused(format!(
            "--preset {named}: this is a journey or a lesson, which visitors see by --kiosk {named}"
        ))),
        Opened::Mission(_) => Err(Stop::refused(format!(
            "--preset {named}: this is a mission, and --kiosk shows journeys alone"
        ))),
    }
}
