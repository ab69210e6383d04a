//! The ship's keys, and its frames.

use super::frame::ShipFrame;
use super::mission_play::MissionPlay;
use super::ship_flight::{HoldKind, ShipFlight};
use super::words;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::controls::helm::ShipCommand;
use crate::app::controls::refusal::no_observer;
use crate::app::controls::statement::capitalised;
use crate::app::motion::camera_motions::CameraMotions;
use crate::app::motion::flight_step::FlightStep;
use crate::app::motion::hand::HandInputs;
use crate::app::motion::pilot::Pilot;
use crate::app::state::end_card::{Closes, EndCard};
use crate::app::state::helm::Helm;
use crate::app::state::missions::{AskedQuestion, Missions, StartMission};
use crate::app::state::overlays::Overlays;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::window_shot::WindowShot;
use bevy::prelude::*;
use lightfall_core::numbers::with_short_numbers;
use lightfall_core::optics::ship::BoardError;
use lightfall_core::scene::mission::Mission;

/// Takes the controls and leaves them by their key. A journey takes them away.
pub(super) fn take_controls(
    mut commands: MessageReader<AppCommand>,
    mut ship: ResMut<ShipFlight>,
    mut helm: ResMut<Helm>,
    mut camera: CameraMotions,
    mut end_card: ResMut<EndCard>,
    (bindings, preferences): (Res<Bindings>, Res<Preferences>),
    mut editor: SceneEditor,
) {
    for command in commands.read() {
        match command {
            AppCommand::Journey | AppCommand::RestartJourney => ship.leave(),
            AppCommand::TakeControls if ship.is_flown() => {
                ship.leave();
                editor.say("You fly the camera");
            }
            AppCommand::TakeControls => {
                let scene = editor.drawn_scene();
                match ship.board(&scene, preferences.settings.mass()) {
                    Ok(()) => {
                        camera.end();
                        end_card.close();
                        editor.note_departure();
                        editor.say(words::boarded(&bindings));
                    }
                    Err(BoardError::Observer(error)) => editor.say(no_observer(&error, &scene)),
                    Err(error) => editor.say(with_short_numbers(&error.to_string())),
                }
            }
            _ => {}
        }
    }
    set_helm(&ship, &mut helm);
}

/// Notes what the hands fly.
fn set_helm(ship: &ShipFlight, helm: &mut ResMut<Helm>) {
    let flies = match (ship.is_flown(), ship.attempt()) {
        (false, _) => Helm::Camera,
        (true, None) => Helm::Ship,
        (true, Some(attempt)) if attempt.is_over() => Helm::MissionOver,
        (true, Some(_)) => Helm::Mission,
    };
    helm.set_if_neq(flies);
}

/// Does what the keys ask of the ship.
pub(super) fn apply_ship_commands(
    mut commands: MessageReader<ShipCommand>,
    mut ship: ResMut<ShipFlight>,
    (mut play, mut asked): (ResMut<MissionPlay>, ResMut<AskedQuestion>),
    mut end_card: ResMut<EndCard>,
    (missions, mut starts): (Res<Missions>, MessageWriter<StartMission>),
    (bindings, preferences, mut paused): (Res<Bindings>, Res<Preferences>, ResMut<Paused>),
    mut editor: SceneEditor,
) {
    let units = ship.units(&preferences.settings);
    for command in commands.read() {
        let Some(voyage) = ship.voyage() else {
            continue;
        };
        let flying = voyage.flight.ship;
        let leads_on = match command {
            ShipCommand::Checkpoint | ShipCommand::Again => true,
            // Without a next mission the card does not name its key.
            ShipCommand::NextMission => next_mission(&ship, &missions).is_some(),
            _ => false,
        };
        if end_card.is_open() && end_card.closes == Closes::Named {
            // A key of the flight that is pressed as it ends would change what stands still.
            if !leads_on {
                continue;
            }
            end_card.close();
        }
        match command {
            ShipCommand::EngineOff => {
                let followed = ship.heading();
                ship.engine_off();
                editor.say(words::engine_off(followed));
            }
            ShipCommand::HoldOrbit | ShipCommand::Hover
                if ship.hold().is_none() && !ship.can_push() =>
            {
                editor.say(words::no_thrust(&ship));
            }
            ShipCommand::HoldOrbit | ShipCommand::Hover => {
                let kind = match command {
                    ShipCommand::HoldOrbit => HoldKind::Orbit,
                    _ => HoldKind::Still,
                };
                editor.say(match ship.switch_hold(kind) {
                    Ok(_) => words::holding(&ship, kind, units, &bindings),
                    Err(refusal) => capitalised(&refusal.to_string()),
                });
            }
            ShipCommand::Face | ShipCommand::FaceBack => {
                let heading = match command {
                    ShipCommand::Face => ship.face_next(),
                    _ => ship.face_back(),
                };
                editor.say(words::facing(heading, &flying));
            }
            ShipCommand::Look => {
                let look = ship.switch_look();
                editor.say(words::looking(look, &bindings));
            }
            ShipCommand::Faster | ShipCommand::Slower => {
                let faster = *command == ShipCommand::Faster;
                ship.change_pace(if faster { 1 } else { -1 });
                editor.say(words::pace(&ship, units));
            }
            ShipCommand::Checkpoint => {
                asked.close();
                let is_goal = ship.go_back();
                play.go_back(is_goal);
                editor.say(if is_goal {
                    "Back at the last goal"
                } else {
                    "Back at the start"
                });
            }
            ShipCommand::Again => {
                asked.close();
                ship.begin_again();
                play.begin_again();
                paused.0 = false;
                editor.say("The mission from its start");
            }
            // The result is kept first.
            ShipCommand::NextMission if !play.is_told() => {}
            ShipCommand::NextMission => match next_mission(&ship, &missions) {
                Some(next) => drop(starts.write(StartMission(Box::new(next.clone())))),
                None => editor.say("Every mission of the list is reached"),
            },
        }
    }
}

/// The mission of the list to fly after the one under way: the next one that was not reached.
fn next_mission<'a>(ship: &ShipFlight, missions: &'a Missions) -> Option<&'a Mission> {
    missions.next_after(&ship.attempt()?.mission.name)
}

/// Moves the ship for one frame.
pub(crate) fn advance_ship(
    inputs: HandInputs,
    mut pilot: ResMut<Pilot>,
    mut ship: ResMut<ShipFlight>,
    mut helm: ResMut<Helm>,
    (paused, shot, overlays): (Res<Paused>, Res<WindowShot>, Res<Overlays>),
    (bindings, preferences): (Res<Bindings>, Res<Preferences>),
    (mut end_card, asked): (ResMut<EndCard>, Res<AskedQuestion>),
    mut editor: SceneEditor,
) {
    if !ship.is_flown() {
        return;
    }
    ship.change_thrust(std::mem::take(&mut pilot.notches));
    let before = editor.drawn_scene();
    // While a card, the help or the settings are read, or a question is answered, the clocks stand still.
    let reads = end_card.is_open() || asked.question().is_some() || overlays.pause_flights();
    let stands = paused.0 || shot.holds_still() || reads;
    let seconds = inputs.seconds();
    let frame = ShipFrame {
        seconds: if stands { 0.0 } else { seconds },
        turn_seconds: seconds,
        stick: inputs.hand(&pilot).stick(&before, seconds),
        reduced_motion: preferences.settings.reduced_motion,
    };
    if paused.0 && !reads && ship.begins_push(frame.stick) {
        editor.say(words::paused_push(&bindings));
    }
    let (step, news) = ship.advance(&frame, &before);
    match step {
        FlightStep::Idle => editor.say(format!(
            "You fly the camera: {} takes the ship again",
            bindings.label("ship.fly")
        )),
        FlightStep::Moved(next) => editor.fly(&next),
        // A mission has its own card.
        FlightStep::Ended(next) if ship.attempt().is_some() => editor.fly(&next),
        FlightStep::Ended(next) => {
            editor.fly(&next);
            let text = words::ending(&ship, ship.units(&preferences.settings));
            let again = ("scene.undo", "back to where you took the ship");
            end_card.show("The flight ends here", &text, again, None);
            ship.leave();
        }
        FlightStep::Refused(reason) => editor.say(format!(
            "The ship cannot fly on: {}",
            with_short_numbers(&reason)
        )),
    }
    if let Some(news) = news {
        editor.say(words::news(news, &ship, &bindings));
    }
    set_helm(&ship, &mut helm);
}
