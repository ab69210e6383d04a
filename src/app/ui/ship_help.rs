//! The help at the ship's controls: its keys and buttons, with what they do there.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::control::{Action, AppCommand, Control};
use crate::app::controls::helm::button_at_helm;

/// The heading of the ship's keys.
pub(super) const AT_HELM: &str = "At the ship's controls";

/// Names of controls, and what their keys do together.
type Row = (&'static [&'static str], &'static str);

/// The wheel, among the names of controls. It cannot be bound.
const WHEEL: &str = "wheel";

/// What flies the ship.
const FLYING: [Row; 18] = [
    (&["fly.face", "fly.face_back"], "nose: next heading, back"),
    (&["scene.spin"], "look at the hole, along the nose"),
    (&["fly.orbit"], "hold the orbit at this radius"),
    (&["scene.observer"], "hold still"),
    (&["motion.let_go"], "engine off, all holds off"),
    (
        &["fly.forward", "fly.backward"],
        "push along the nose, against it",
    ),
    (&["fly.left", "fly.right"], "push to the left, to the right"),
    (&["fly.up", "fly.down"], "push up, down"),
    (&["fly.faster"], "four times the thrust"),
    (&["fly.slower"], "a quarter of the thrust"),
    (&[WHEEL], "the thrust that is set"),
    (
        &[
            "fly.look_left",
            "fly.look_right",
            "fly.look_up",
            "fly.look_down",
        ],
        "turn the ship",
    ),
    (&["fly.roll_left", "fly.roll_right"], "roll the ship"),
    (&["motion.slower", "motion.faster"], "time slower, faster"),
    (&["motion.pause"], "pause, go on"),
    (&["ship.map"], "map, and line of the path"),
    (&["ship.missions"], "missions"),
    (&["ship.fly"], "leave the ship"),
];

/// What else there is on a mission.
const ON_MISSION: [Row; 2] = [
    (&["scene.undo"], "back to the last goal, or the start"),
    (&["journey.again"], "the mission from its start"),
];

/// Whether the ship's own rows say what this control does at its controls.
pub(super) fn is_ship_control(id: &str, on_mission: bool) -> bool {
    rows(on_mission).any(|(ids, _)| ids.contains(&id))
}

fn rows(on_mission: bool) -> impl Iterator<Item = Row> {
    let others = on_mission.then_some(ON_MISSION).into_iter().flatten();
    FLYING.into_iter().chain(others)
}

/// The ship's keys, and what they do at its controls.
#[must_use]
pub fn ship_rows(bindings: &Bindings, on_mission: bool) -> Vec<[String; 2]> {
    rows(on_mission)
        .map(|(ids, does)| [keys(bindings, ids), does.to_owned()])
        .filter(|[keys, _]| !keys.is_empty())
        .collect()
}

/// The first keys of these controls.
fn keys(bindings: &Bindings, ids: &[&str]) -> String {
    let name = |id: &&str| match *id {
        WHEEL => WHEEL.to_owned(),
        id => bindings.first_name(id),
    };
    let mut names: Vec<String> = ids.iter().map(name).collect();
    names.retain(|name| !name.is_empty());
    match names.join(" ") {
        arrows if arrows == "Left Right Up Down" => "arrow keys".into(),
        names => names,
    }
}

/// The buttons of a gamepad, and what they do at the ship's controls.
pub(super) fn ship_pad_rows(buttons: &PadBindings) -> Vec<[String; 2]> {
    let bound = buttons.iter().filter(|(_, own)| !own.is_empty());
    bound
        .map(|(control, _)| [buttons.label_of(control), does(control).to_owned()])
        .collect()
}

/// What a control's button does at the ship's controls.
fn does(control: &Control) -> &'static str {
    match (control.id, button_at_helm(control)) {
        ("fly.faster", _) => "push along the nose",
        ("fly.slower", _) => "push against the nose",
        ("fly.up", _) => "push up",
        ("fly.down", _) => "push down",
        (_, Action::Do(command)) => match command {
            AppCommand::OrbitCamera => "hold the orbit at this radius",
            AppCommand::Hover => "hold still",
            AppCommand::LetGo => "engine off, all holds off",
            AppCommand::Face => "nose: next heading",
            AppCommand::Look => "look at the hole, along the nose",
            AppCommand::SlowerTime => "time slower",
            AppCommand::FasterTime => "time faster",
            AppCommand::Map => "map, and line of the path",
            AppCommand::Undo => "back to the last goal, or leave",
            _ => control.description,
        },
        _ => control.description,
    }
}
