//! The guided journey and lessons in the window: their keys, their flight, and what is said at the end.

use super::flight_step::FlightStep;
use super::journey_player::JourneyPlayer;
use super::steering::is_inside;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::input::keyboard::undo_last_change;
use crate::app::state::end_card::{Closes, EndCard, Way};
use crate::app::state::kiosk::Kiosk;
use crate::app::state::lessons::{Lessons, OfferedLesson, StartJourney, next_lesson};
use crate::app::state::overlays::Overlays;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::window_shot::WindowShot;
use bevy::prelude::*;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::Journey;

/// Seconds by which one press goes ahead or back.
const SKIP: f64 = 5.0;
/// The way from the end of a lesson to the next one: the key that begins the next mission after one.
const NEXT_LESSON: Way = ("journey.fly", "next lesson");

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        (
            (apply_journey_commands, go_on_or_back),
            start_chosen_journey,
            advance_journey,
        )
            .chain()
            .after(undo_last_change),
    );
}

pub(super) fn apply_journey_commands(
    mut commands: MessageReader<AppCommand>,
    mut player: ResMut<JourneyPlayer>,
    mut editor: SceneEditor,
    bindings: Res<Bindings>,
    mut end_card: ResMut<EndCard>,
    mut paused: ResMut<Paused>,
    (mut offered, mut starts): (ResMut<OfferedLesson>, MessageWriter<StartJourney>),
) {
    for command in commands.read() {
        if *command == AppCommand::Journey
            && let Some(lesson) = offered.0.take()
        {
            starts.write(StartJourney(lesson));
            continue;
        }
        match command {
            AppCommand::JourneyBack | AppCommand::JourneyAhead => {
                if player.is_playing() {
                    let back = *command == AppCommand::JourneyBack;
                    player.skip(if back { -SKIP } else { SKIP });
                    editor.say(format!("Journey: {}", player.progress()));
                } else {
                    editor.say(format!(
                        "No journey is under way: {} starts it",
                        bindings.label("journey.fly")
                    ));
                }
                continue;
            }
            AppCommand::Journey if player.is_playing() => {
                player.stop();
                editor.say(format!(
                    "The journey stops at {}: {}",
                    player.progress(),
                    how_to_go_on(&bindings, false)
                ));
                end_card.close();
                continue;
            }
            // A fall begins where the journey is left.
            AppCommand::LetGo if player.is_playing() => {
                player.stop();
                continue;
            }
            AppCommand::Journey | AppCommand::RestartJourney => {}
            _ => continue,
        }
        let restarts = *command == AppCommand::RestartJourney;
        start(&mut player, restarts, &mut editor);
        paused.0 = false;
        end_card.close();
    }
    // A key closes the card before its command is read.
    if offered.0.is_some() && !end_card.is_open() {
        offered.0 = None;
    }
}

/// Goes on from a stop, or back to the one before. The pause ends, so that a presenter's remote is
/// enough.
pub(super) fn go_on_or_back(
    mut commands: MessageReader<AppCommand>,
    mut player: ResMut<JourneyPlayer>,
    editor: SceneEditor,
    mut paused: ResMut<Paused>,
) {
    for command in commands.read() {
        match command {
            _ if !player.is_playing() => continue,
            AppCommand::GoOn => player.go_on(&editor.drawn_scene()),
            AppCommand::GoBack => player.go_back(),
            // The hands may have flown from the stop, and come back to it. Otherwise this was the
            // flight to the journey itself.
            AppCommand::Undo if player.rests() && !player.is_there(&editor.drawn_scene()) => {
                player.stop();
                continue;
            }
            _ => continue,
        }
        paused.0 = false;
    }
}

/// Flies the journey that was chosen from a list, or the lesson that comes next. A lesson ends the photo
/// mode, which would hide its words.
fn start_chosen_journey(
    mut starts: MessageReader<StartJourney>,
    mut player: ResMut<JourneyPlayer>,
    mut editor: SceneEditor,
    (mut end_card, mut overlays): (ResMut<EndCard>, ResMut<Overlays>),
    mut paused: ResMut<Paused>,
) {
    for StartJourney(journey) in starts.read() {
        if !journey.stops.is_empty() {
            overlays.hidden = false;
        }
        put_fields_back(&mut player, &mut editor);
        player.take(Journey::clone(journey));
        start(&mut player, true, &mut editor);
        paused.0 = false;
        end_card.close();
    }
}

/// Puts back the fields of the scene that the stops of a journey have switched.
pub(super) fn put_fields_back(player: &mut JourneyPlayer, editor: &mut SceneEditor) {
    if player.base().is_none() {
        return;
    }
    let Some(scene) = player.unswitched(editor.drawn_scene().into_scene()) else {
        return;
    };
    // Another scene was loaded meanwhile.
    if !player.is_at_home(editor.loaded()) {
        return;
    }
    match Drawable::new(scene) {
        Ok(scene) => editor.fly(&scene),
        Err(reason) => editor.say(format!("What the stops have switched stays: {reason}")),
    }
}

/// Goes on with the journey, or begins it again. One that cannot be flown to its end is flown as far as
/// possible.
fn start(player: &mut JourneyPlayer, restarts: bool, editor: &mut SceneEditor) {
    if restarts || player.begins_anew(editor.loaded()) {
        editor.depart(player.stage());
        player.rewind(editor.loaded());
    } else {
        editor.depart(None);
    }
    if restarts {
        player.restart();
    } else {
        player.start(&editor.scene());
    }
    if let Err(fault) = player.check(&editor.scene()) {
        editor.say(format!(
            "This journey cannot be flown to its end here: {fault}"
        ));
    }
}

/// Which keys go on with a journey that was left, or begin it `anew` where it cannot go on.
fn how_to_go_on(bindings: &Bindings, anew: bool) -> String {
    let [on, again] = ["journey.fly", "journey.again"].map(|id| bindings.label(id));
    if anew {
        return format!("{on} begins again");
    }
    format!("{on} goes on, {again} begins again")
}

pub(super) fn advance_journey(
    time: Res<Time>,
    mut player: ResMut<JourneyPlayer>,
    mut editor: SceneEditor,
    preferences: Res<Preferences>,
    bindings: Res<Bindings>,
    (paused, shot, kiosk): (Res<Paused>, Res<WindowShot>, Res<Kiosk>),
    mut end_card: ResMut<EndCard>,
    (mut lessons, mut offered): (ResMut<Lessons>, ResMut<OfferedLesson>),
) {
    if !player.is_playing() {
        return;
    }
    if player.rests() {
        // Another scene ends the journey. Here the camera may be anywhere.
        if player.is_at_home(editor.loaded()) {
            player.follow(&editor.drawn_scene());
        } else {
            player.stop();
        }
        return;
    }
    let calm = preferences.settings.reduced_motion;
    // A paused journey still notices that something else moves the camera, and follows a skip.
    let seconds = if paused.0 || shot.holds_still() {
        0.0
    } else {
        time.delta_secs_f64()
    };
    match player.advance(seconds, &editor.drawn_scene(), calm) {
        FlightStep::Idle => editor.say(format!(
            "You are flying by hand. The journey waits at {}: {}",
            player.progress(),
            how_to_go_on(&bindings, player.begins_anew(editor.loaded()))
        )),
        FlightStep::Moved(next) => editor.fly(&next),
        FlightStep::Ended(next) => {
            editor.fly(&next);
            let [title, ending] = player.last_words().map(|text| bindings.with_keys(text));
            if kiosk.is_on() {
                // The next journey begins by itself.
                *end_card = EndCard::new(&title, &ending, Vec::new(), Closes::Anything);
                return;
            }
            let again = ("journey.again", "fly it again");
            let fall = (!is_inside(&next)).then_some(("motion.let_go", "let go and fall"));
            end_card.show(&title, &ending, again, fall);
            offered.0 = lesson_after(&player, &mut lessons);
            end_card.details = lesson_details(&player, offered.0.as_deref());
            if offered.0.is_some() {
                end_card.ways.insert(0, NEXT_LESSON);
            }
        }
        FlightStep::Refused(reason) => editor.say(format!("The journey cannot go on: {reason}")),
    }
}

/// What the card at the end of a lesson says besides: how its questions were answered, and what comes next.
/// Empty for other journeys.
fn lesson_details(player: &JourneyPlayer, next: Option<&Journey>) -> String {
    if player.journey().stops.is_empty() {
        return String::new();
    }
    let next = next.map(|lesson| format!("Next lesson: {}", lesson.title));
    let lines: Vec<String> = player.score().into_iter().chain(next).collect();
    lines.join("\n")
}

/// The lesson of the list that comes after the one that has ended. None after other journeys.
fn lesson_after(player: &JourneyPlayer, lessons: &mut Lessons) -> Option<Box<Journey>> {
    let journey = player.journey();
    if journey.stops.is_empty() {
        return None;
    }
    // One that the command line names comes before any list is read. The menu says what is wrong with files.
    if lessons.0.is_empty() {
        drop(lessons.read());
    }
    next_lesson(&lessons.0, &journey.title).map(|lesson| Box::new(lesson.clone()))
}
