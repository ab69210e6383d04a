//! What keys and buttons do at the ship's controls, where this is not what they do elsewhere.

use super::control::{Action, AppCommand, Control, FlightInput};
use bevy::prelude::Message;

/// What a control asks of the ship.
#[derive(Message, Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShipCommand {
    /// Switch the engine off, and end what holds and turns the ship.
    EngineOff,
    /// Hold the orbit at this radius, or stop holding it.
    HoldOrbit,
    /// Hold still, or stop holding still.
    Hover,
    /// Turn the nose to the next heading.
    Face,
    /// Turn the nose to the heading before.
    FaceBack,
    /// Look at the hole, or along the nose.
    Look,
    /// Let time run faster.
    Faster,
    /// Let time run slower.
    Slower,
    /// Go back to the last goal of the mission, or to its start.
    Checkpoint,
    /// Begin the mission again.
    Again,
    /// Begin the next mission that is not yet reached.
    NextMission,
}

/// What a command asks of the ship at its controls, on a mission or after its end. `None` if it is not for
/// the ship.
pub(crate) fn ship_command(
    command: AppCommand,
    on_mission: bool,
    is_over: bool,
) -> Option<ShipCommand> {
    Some(match command {
        AppCommand::LetGo => ShipCommand::EngineOff,
        AppCommand::OrbitCamera => ShipCommand::HoldOrbit,
        AppCommand::Hover => ShipCommand::Hover,
        AppCommand::Face => ShipCommand::Face,
        AppCommand::FaceBack => ShipCommand::FaceBack,
        AppCommand::Look => ShipCommand::Look,
        AppCommand::FasterTime => ShipCommand::Faster,
        AppCommand::SlowerTime => ShipCommand::Slower,
        AppCommand::Undo if on_mission => ShipCommand::Checkpoint,
        AppCommand::RestartJourney if on_mission => ShipCommand::Again,
        AppCommand::Journey if is_over => ShipCommand::NextMission,
        _ => return None,
    })
}

/// Whether an action at the ship's controls flies the ship: it pushes, turns or orders it.
pub(crate) fn flies_ship(action: Action) -> bool {
    use FlightInput::{Faster, Narrower, Slower, Wider};
    match action {
        Action::Hold(input) => !matches!(input, Faster | Slower | Narrower | Wider),
        Action::Do(command) => ship_command(command, true, false).is_some(),
        Action::Edit(_) | Action::Load(_) | Action::StepPreset(_) => false,
    }
}

/// What a control's key does at the ship's controls.
pub(crate) fn key_at_helm(control: &Control) -> Action {
    match control.id {
        "scene.observer" => Action::Do(AppCommand::Hover),
        "fly.face_back" => Action::Do(AppCommand::FaceBack),
        // Another spin would leave the ship.
        "scene.spin" => Action::Do(AppCommand::Look),
        _ => control.action,
    }
}

/// What a control's gamepad button does at the ship's controls. The triggers push.
pub(crate) fn button_at_helm(control: &Control) -> Action {
    Action::Do(match control.id {
        "journey.fly" => AppCommand::OrbitCamera,
        "scene.spin" => AppCommand::Face,
        "preset.previous" => AppCommand::SlowerTime,
        "preset.next" => AppCommand::FasterTime,
        "fly.orbit" => AppCommand::Hover,
        "fly.face" => AppCommand::Look,
        // The menu has the help.
        "window.help" => AppCommand::Map,
        _ => return key_at_helm(control),
    })
}
