//! Keyboard and gamepad in the open menu.

use super::actions::{MenuActions, name_and_control};
use crate::app::controls::bindings::Bindings;
use crate::app::input::keyboard::pressed_with_modifiers;
use crate::app::state::menu::MenuEntry;
use bevy::input::ButtonState;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;

/// Deflection beyond which the stick selects the next entry.
const STICK_PUSHED: f32 = 0.6;
/// Deflection below which the stick counts as back in the middle.
const STICK_BACK: f32 = 0.3;

const UP: [KeyCode; 2] = [KeyCode::ArrowUp, KeyCode::KeyW];
const DOWN: [KeyCode; 2] = [KeyCode::ArrowDown, KeyCode::KeyS];
const CHOOSE: [KeyCode; 3] = [KeyCode::Enter, KeyCode::NumpadEnter, KeyCode::Space];
const BACK: [KeyCode; 3] = [KeyCode::Escape, KeyCode::ArrowLeft, KeyCode::Backspace];

/// Moves the selection, chooses it, or goes back; the key that an entry shows chooses that entry. Every
/// press counts, in order, even if several come in one slow frame.
pub(super) fn navigate(
    mut inputs: MessageReader<KeyboardInput>,
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    pads: Query<&Gamepad>,
    window: Single<&Window, With<PrimaryWindow>>,
    mut stick_pushed: Local<bool>,
    mut actions: MenuActions,
) {
    let is_press = |input: &&&KeyboardInput| input.state == ButtonState::Pressed;
    let inputs: Vec<&KeyboardInput> = inputs.read().collect();
    let mut modifiers = pressed_with_modifiers(inputs.iter().copied(), &keys).into_iter();
    for input in inputs.iter().filter(is_press) {
        // Repetitions have no modifiers of their own.
        let press = if input.repeat { None } else { modifiers.next() };
        if !actions.menu.is_open() {
            continue;
        }
        match input.key_code {
            code if UP.contains(&code) => actions.menu.step(-1),
            code if DOWN.contains(&code) => actions.menu.step(1),
            code if CHOOSE.contains(&code) && !input.repeat => {
                let entry = actions.menu.selected();
                actions.choose(entry);
            }
            code if BACK.contains(&code) && !input.repeat => actions.menu.go_back(),
            _ => {
                let control = press.and_then(|(code, modifier)| bindings.pressed(code, modifier));
                let mut entries = actions.menu.entries().into_iter();
                let own = |entry: &MenuEntry| {
                    control.is_some_and(|it| it.id == name_and_control(*entry)[1])
                };
                if let Some(entry) = entries.find(own) {
                    actions.choose(entry);
                }
            }
        }
    }
    let pads = || pads.iter().filter(|_| window.focused);
    let stick: f32 = pads().map(|pad| pad.left_stick().y).sum();
    let pushes = stick.abs() > STICK_PUSHED && !*stick_pushed;
    *stick_pushed = stick.abs() > STICK_PUSHED || (*stick_pushed && stick.abs() > STICK_BACK);
    if !actions.menu.is_open() {
        return;
    }
    let pressed = |button| pads().any(|pad| pad.just_pressed(button));
    if pressed(GamepadButton::DPadUp) || (pushes && stick > 0.0) {
        actions.menu.step(-1);
    }
    if pressed(GamepadButton::DPadDown) || (pushes && stick < 0.0) {
        actions.menu.step(1);
    }
    if pressed(GamepadButton::South) {
        let entry = actions.menu.selected();
        actions.choose(entry);
    } else if pressed(GamepadButton::East) {
        actions.menu.go_back();
    } else if pressed(GamepadButton::Start) {
        actions.choose(MenuEntry::Resume);
    }
}
