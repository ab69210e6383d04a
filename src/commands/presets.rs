//! `lightfall presets`: lists, shows and checks presets, and checks missions and journeys.

use super::cli::{PresetsCommand, assignments};
use super::glyphs::note_lacking;
use super::output::print_to;
use super::stop::Stop;
use super::unused::{idle_fields, note_idle_journey};
use crate::app::unknown_controls;
use lightfall_core::gpu::{GpuError, GpuScene};
use lightfall_core::numbers::{counted, four_digits};
use lightfall_core::optics::ship::{Attempt, Outcome, fly};
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::Journey;
use lightfall_core::scene::mission::Mission;
use lightfall_core::scene::presets::PRESETS;
use lightfall_platform::log::say;
use lightfall_platform::storage;
use lightfall_platform::storage::{Opened, SourceError};
use lightfall_render::cost_report;
use std::ffi::OsStr;
use std::fmt::Display;
use std::io::Write;
use std::path::Path;

/// Runs `lightfall presets` and writes the answer to `out`.
///
/// # Errors
/// A preset that does not exist, cannot be read or is wrong; or `out` cannot be written.
pub fn presets(command: &PresetsCommand, out: &mut impl Write) -> Result<(), Stop> {
    let answer = match command {
        PresetsCommand::List => list()?,
        PresetsCommand::Show {
            preset,
            sets,
            needs,
        } => show(preset, sets, *needs)?,
        PresetsCommand::Check { preset } => check(preset)?,
    };
    print_to(&answer, out)
}

/// The built-in presets with their numbers and titles, then the user's own with their files.
fn list() -> Result<String, Stop> {
    let mut list = String::new();
    for preset in PRESETS {
        let scene = preset.scene(&[]).map_err(Stop::refused)?;
        list += &format!("{}  {:14} {}\n", preset.number, preset.name, scene.title);
    }
    for file in storage::own_presets() {
        let name = file.file_stem().unwrap_or_default();
        list += &format!("-  {:14} {}\n", name.display(), file.display());
    }
    Ok(list)
}

/// A preset as a file with all its fields, or what it costs to draw.
fn show(preset: &OsStr, sets: &[String], cost: bool) -> Result<String, Stop> {
    let overrides = assignments(sets).map_err(Stop::refused)?;
    let scene = storage::scene_by_name("presets show", preset, &overrides)?;
    Ok(if cost {
        cost_report(&scene)
    } else {
        scene.to_preset()
    })
}

/// Checks that a preset can be read and its scene traced, or that a mission or a journey can be flown. Of a
/// journey all faults of its text are told, each in a line.
fn check(given: &OsStr) -> Result<String, Stop> {
    let opened =
        storage::open_by_name("presets check", given, &[]).map_err(|error| match error {
            SourceError::Journey(error) => Stop::refused(error.sentences().join("\n")),
            error => error.into(),
        })?;
    match opened {
        Opened::Scene(scene) => check_preset(given, &scene),
        Opened::Mission(mission) => check_mission(given, &mission),
        Opened::Journey(journey) => check_journey(given, *journey),
    }
}

/// What a journey says: it can be flown in its preset, with what its stops switch.
///
/// # Errors
/// A place that it does not lead to.
fn check_journey(given: &OsStr, journey: Journey) -> Result<String, Stop> {
    let path = Path::new(given);
    let scene = journey.stage().plain_scene();
    let journey = storage::flyable_journey(path, journey, scene)?;
    let name = given.display();
    note_idle_journey(path, &journey, scene);
    note_texts(&name, journey.texts());
    let seconds = four_digits(journey.duration);
    let what = match journey.stops.len() {
        0 => format!("a journey of {seconds} s"),
        stops => format!("a journey of {seconds} s with {}", counted(stops, "stop")),
    };
    Ok(format!("{name}: ok, {what}\n"))
}

/// Notes what the window cannot show as it is written: letters without a font, and keys of controls that do
/// not exist.
fn note_texts(name: &impl Display, texts: Vec<&String>) {
    for sentence in unknown_controls(texts.iter().copied()) {
        say(format_args!("lightfall: {name}: {sentence}"));
    }
    note_lacking(name, texts);
}

fn check_preset(preset: &OsStr, scene: &Scene) -> Result<String, Stop> {
    let name = preset.display();
    for idle in idle_fields(preset, scene) {
        say(format_args!("lightfall: {name}: {idle}"));
    }
    note_lacking(&name, [&scene.name, &scene.title]);
    match GpuScene::for_rays(scene) {
        // A preset for the reference is useful, too: `trace --device cpu` runs it.
        Ok(_) | Err(GpuError::MethodOfCpu) => Ok(format!("{name}: ok\n")),
        Err(error) => Err(Stop::refused(format!("{name}: {error}"))),
    }
}

/// Checks that the solution of a mission reaches its goals.
fn check_mission(given: &OsStr, mission: &Mission) -> Result<String, Stop> {
    let name = given.display();
    note_texts(&name, mission.texts());
    if mission.solution.is_empty() {
        return Ok(format!("{name}: ok, a mission without a solution\n"));
    }
    let refused = |fault: String| Stop::refused(format!("{name}: {fault}"));
    let mut attempt = Attempt::new(mission).map_err(|fault| refused(fault.to_string()))?;
    let outcome =
        fly(&mut attempt, &mission.solution).map_err(|fault| refused(fault.to_string()))?;
    let goals = counted(mission.goals.len(), "goal");
    if outcome != Outcome::Success {
        let reached = attempt.reached().len();
        return Err(refused(format!(
            "the solution reaches {reached} of {goals}"
        )));
    }
    let used = four_digits(attempt.voyage().flight.rocket.used());
    Ok(format!(
        "{name}: ok, a mission; its solution reaches {goals} with a rapidity of {used}\n"
    ))
}
