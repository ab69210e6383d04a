//! `lightfall` without a command: opens the window or, where there is no display, draws a picture.

use super::cli::FlyArgs;
use super::console::close_own_console;
use super::glyphs::note_lacking;
use super::kiosk;
use super::output::print;
use super::scene::{
    NO_JOURNEY, drawable, journey, journey_in, note_missing_stars, on_stage, opened, scene, stars,
};
use super::stop::Stop;
use super::unused::{note_idle_preset, note_unused};
use crate::app;
use crate::app::{MonitorFault, Placement, Start};
use bevy::app::App;
use lightfall_core::gpu::ShaderFiles;
use lightfall_core::optics::exposure::exposed;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::journey::Journey;
use lightfall_core::scene::mission::Mission;
use lightfall_core::scene::{Output, Scene, drawn_at_once};
use lightfall_picture as picture;
use lightfall_picture::{HeadlessOptions, Studio};
use lightfall_platform::log::say;
use lightfall_platform::storage::{Opened, file_safe_name};
use std::path::{Path, PathBuf};

/// Flies, with an addition to the window program.
pub(super) fn fly(args: &FlyArgs, addition: impl FnOnce(&mut App)) -> Result<(), Stop> {
    kiosk::check_options(args)?;
    if let Some(journeys) = &args.kiosk {
        return kiosk::show(args, journeys, addition);
    }
    let mut journey_file = args.journey.as_deref();
    if journey_file.is_some_and(|file| file == Path::new(NO_JOURNEY) && !file.exists()) {
        return Err(Stop::refused(format!(
            "--journey {NO_JOURNEY} is for `lightfall render`; the window flies a journey when J is pressed, or at once where --journey names a file"
        )));
    }
    let mut scene_args = on_stage(&args.scene, journey_file)?;
    // What the preset names is opened once, because a pipe can be read only once.
    let (scene, mission, lesson) = match opened(&scene_args)? {
        Opened::Journey(_) if journey_file.is_some() => {
            let named = args.scene.preset.as_deref().unwrap_or_default();
            return Err(Stop::refused(format!(
                "--preset {}: this is a journey or a lesson, and --journey names one, too: one of the two can be flown",
                named.display()
            )));
        }
        Opened::Journey(lesson) => {
            // Lessons open as missions do, each in the preset that it names.
            journey_file = args.scene.preset.as_deref().map(Path::new);
            scene_args.preset = lesson.preset.map(|preset| preset.name.into());
            (scene(&scene_args)?, None, Some(*lesson))
        }
        opened => {
            let (scene, mission) = opened.into_parts();
            (scene, mission, None)
        }
    };
    let stars = stars(&scene_args)?;
    let drawable = drawable(&scene)?;
    if let (Some(mission), true) = (&mission, journey_file.is_some()) {
        return Err(Stop::refused(format!(
            "--journey is for presets, and {:?} is a mission: one of the two can be flown",
            mission.title
        )));
    }
    let journey = match (lesson, journey_file) {
        (Some(lesson), Some(file)) => journey_in(file, lesson, &scene)?,
        _ => journey(journey_file, &scene)?,
    };
    if let Some(folder) = &args.shaders {
        ShaderFiles::read(folder).map_err(|error| Stop::refused(format!("--shaders: {error}")))?;
    }
    let display = app::display();
    let output = if display.is_ok() {
        Output::Window
    } else {
        Output::Still
    };
    let preset = scene_args.preset.as_deref();
    // What a mission sets is nobody's choice of a picture.
    note_idle_preset(preset.filter(|_| mission.is_none()), &scene);
    note_unused(&scene_args, &scene, output, |without| without, |_| None);
    let message = note_missing_stars(&scene_args, &scene, stars);
    if let Err(reason) = display {
        let moment = match (&mission, journey_file) {
            (Some(mission), _) => Moment::Mission(mission),
            (None, Some(file)) => Moment::Journey(&journey, file),
            (None, None) => Moment::Scene,
        };
        return draw_instead(scene, stars, &moment, &reason);
    }
    if let Some(preset) = preset {
        let texts = mission.as_ref().map(|mission| mission.texts());
        let texts = texts.unwrap_or_else(|| vec![&scene.name, &scene.title]);
        note_lacking(preset.display(), texts);
    }
    if let Some(file) = journey_file {
        note_lacking(file.display(), journey.texts());
    }
    if let Some(file) = &scene_args.stars {
        let names = stars.names().iter().map(|star| &star.name);
        note_lacking(format_args!("--stars {}", file.display()), names);
    }
    close_own_console();
    let start = Start::new(drawable, journey);
    let start = Start {
        message,
        stars,
        plays_journey: journey_file.is_some(),
        mission,
        keeps_own_look: scene_args.sets("picture.bypass").map_err(Stop::refused)?,
        shaders: args.shaders.clone().or(start.shaders),
        placement: placement(args),
        ..start
    };
    open(start, addition)
}

/// Where the window opens.
pub(super) fn placement(args: &FlyArgs) -> Placement {
    Placement {
        full_screen: args.fullscreen || args.kiosk.is_some(),
        monitor: args.monitor.map(usize::from),
    }
}

/// Opens the window, with an addition to its program, until it is closed.
pub(super) fn open(start: Start, addition: impl FnOnce(&mut App)) -> Result<(), Stop> {
    let mut program = app::program(start);
    addition(&mut program);
    let no_monitor = program.world().get_resource::<MonitorFault>().cloned();
    app::run(program).map_err(|reason| {
        let refusal = no_monitor.as_ref().and_then(MonitorFault::sentence);
        refusal.map_or_else(|| Stop::failed(reason), Stop::refused)
    })
}

/// What a window would show first.
enum Moment<'a> {
    Scene,
    Journey(&'a Journey, &'a Path),
    Mission(&'a Mission),
}

/// Without a display: draws the scene, or the first moment of the journey or the mission, to a new PNG
/// file in the current folder. `reason` says why there is no display.
fn draw_instead(
    mut scene: Scene,
    stars: &'static Catalogue,
    moment: &Moment,
    reason: &str,
) -> Result<(), Stop> {
    let (name, what) = match moment {
        Moment::Scene => (scene.name.clone(), "the scene".to_owned()),
        Moment::Mission(mission) => (
            mission.name.clone(),
            format!("the start of {:?}", mission.title),
        ),
        Moment::Journey(journey, file) => {
            journey.apply(0.0, &mut scene);
            let name = file
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            (name, format!("the first moment of {}", file.display()))
        }
    };
    let file = unused_file(&name);
    // The file is checked before any work is done for a picture that could not be written.
    picture::check_path(&file).map_err(|error| {
        Stop::failed(format!(
            "no display ({reason}), and no picture can be drawn instead: {error}; start the program in a folder that you \
             may write to, or use `lightfall render -o FILE`"
        ))
    })?;
    say(format_args!(
        "lightfall: no display ({reason}); rendering {what} to a picture instead"
    ));
    let mut scene = exposed(&scene);
    // The picture of a window. Larger ones, which take long, are drawn by `lightfall render` alone.
    scene.picture = drawn_at_once(&scene.picture);
    let size = scene.picture.size();
    let options = HeadlessOptions {
        stars,
        ..HeadlessOptions::default()
    };
    let mut studio =
        Studio::with_options(&picture::filled(&scene), size, options).map_err(Stop::failed)?;
    let still = studio.picture().map_err(Stop::failed)?;
    picture::write_png(&file, &still, &studio.record(&scene))?;
    print(&format!("{}\n", file.display()))
}

/// A file in the current folder that does not exist yet: a picture whose name the user did not
/// choose must not replace another one.
fn unused_file(name: &str) -> PathBuf {
    let name = file_safe_name(name);
    let numbered = (2..).map(|number| format!("lightfall-{name}-{number}.png"));
    std::iter::once(format!("lightfall-{name}.png"))
        .chain(numbered)
        .map(PathBuf::from)
        .find(|file| !file.exists())
        .unwrap_or_else(|| "lightfall.png".into())
}
