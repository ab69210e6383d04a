//! What begins a mission while the card with its task is open: the keys and buttons of the ship, and a
//! click. Help, menu and settings leave the card and its clock alone.

use super::clicks::hold_keys_after_click;
use super::gamepad::Pads;
use super::held::ClaimedKeys;
use super::keyboard::{apply_pressed_controls, pressed_with_modifiers};
use super::typing::Typing;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{Action, Control, FlightInput, Modifier};
use crate::app::controls::helm::{button_at_helm, flies_ship, key_at_helm};
use crate::app::state::end_card::{CardButtons, Closes, EndCard};
use crate::app::state::menu::Menu;
use crate::app::state::overlays::Overlays;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PreUpdate,
        // After the controls, which forget claimed keys that are up again: a short press stays claimed
        // for its frame.
        begin_mission
            .after(hold_keys_after_click)
            .after(apply_pressed_controls),
    );
}

fn begin_mission(
    mut inputs: MessageReader<KeyboardInput>,
    (keys, buttons): (Res<ButtonInput<KeyCode>>, Res<ButtonInput<MouseButton>>),
    (bindings, typing): (Res<Bindings>, Res<Typing>),
    (menu, overlays): (Res<Menu>, Res<Overlays>),
    pads: Pads,
    mut claimed: ResMut<ClaimedKeys>,
    windows: Query<&Window, With<PrimaryWindow>>,
    card_buttons: Res<CardButtons>,
    mut end_card: ResMut<EndCard>,
) {
    let presses = pressed_with_modifiers(inputs.read(), &keys);
    let waits = end_card.is_open() && end_card.closes == Closes::Flying;
    if !waits || menu.is_open() || overlays.pause_flights() {
        return;
    }
    let clicks = buttons.get_just_pressed().next().is_some();
    // A card that scrolls is dragged.
    let mut begins = clicks && !card_buttons.have_mouse(&windows);
    begins |= bindings.iter().any(|(control, _)| {
        let action = button_at_helm(control);
        // The triggers push at the ship's controls.
        let flies = matches!(action, Action::Hold(_)) || flies_ship(action);
        flies && pads.pressed(control).is_some()
    });
    for (code, modifier) in presses.into_iter().filter(|_| !typing.is_on()) {
        // A modifier may belong to a key that is pressed after it.
        let is_modifier = Modifier::ALL.iter().any(|it| it.keys().contains(&code));
        let control = bindings.pressed(code, modifier).filter(|_| !is_modifier);
        let Some(control) = control.filter(|control| flies_ship(key_at_helm(control))) else {
            continue;
        };
        begins = true;
        if pushes(control) && !end_card.names(control.id) {
            claimed.0.push(code);
        }
    }
    if begins {
        end_card.close();
    }
}

/// Whether a control pushes while it is held.
fn pushes(control: &Control) -> bool {
    matches!(control.action, Action::Hold(input) if FlightInput::THRUST.contains(&input))
}
