//! Keyboard and gamepad in the open menu.

use super::MenuActions;
use crate::app::state::menu::MenuEntry;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;

/// The stick selects the next entry when it is pushed farther than this.
const STICK_PUSHED: f32 = 0.6;
/// The stick is back in the middle below this.
const STICK_BACK: f32 = 0.3;

const UP: [KeyCode; 2] = [KeyCode::ArrowUp, KeyCode::KeyW];
const DOWN: [KeyCode; 2] = [KeyCode::ArrowDown, KeyCode::KeyS];
const CHOOSE: [KeyCode; 3] = [KeyCode::Enter, KeyCode::NumpadEnter, KeyCode::Space];
const BACK: [KeyCode; 3] = [KeyCode::Escape, KeyCode::ArrowLeft, KeyCode::Backspace];

/// Moves the selection, chooses it, or goes back.
pub(super) fn navigate(
    keys: Res<ButtonInput<KeyCode>>,
    pads: Query<&Gamepad>,
    window: Single<&Window, With<PrimaryWindow>>,
    mut stick_pushed: Local<bool>,
    mut actions: MenuActions,
) {
    if !actions.menu.is_open() {
        return;
    }
    let pads = || pads.iter().filter(|_| window.focused);
    let pressed = |button| pads().any(|pad| pad.just_pressed(button));
    let stick: f32 = pads().map(|pad| pad.left_stick().y).sum();
    let pushes = stick.abs() > STICK_PUSHED && !*stick_pushed;
    *stick_pushed = stick.abs() > STICK_PUSHED || (*stick_pushed && stick.abs() > STICK_BACK);

    if keys.any_just_pressed(UP) || pressed(GamepadButton::DPadUp) || (pushes && stick > 0.0) {
        actions.menu.step(-1);
    }
    if keys.any_just_pressed(DOWN) || pressed(GamepadButton::DPadDown) || (pushes && stick < 0.0) {
        actions.menu.step(1);
    }
    if keys.any_just_pressed(CHOOSE) || pressed(GamepadButton::South) {
        let entry = actions.menu.selected();
        actions.choose(entry);
    } else if keys.any_just_pressed(BACK) || pressed(GamepadButton::East) {
        actions.menu.go_back();
    } else if pressed(GamepadButton::Start) {
        actions.choose(MenuEntry::Resume);
    }
}
