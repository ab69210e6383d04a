//! The layout of the keyboard: asked of the system where it can be asked, and learned from what the
//! keys type elsewhere.

#[cfg_attr(target_os = "linux", path = "x11.rs")]
#[cfg_attr(windows, path = "windows.rs")]
#[cfg_attr(not(any(target_os = "linux", windows)), path = "unknown.rs")]
mod system;

use crate::app::controls::bindings::Bindings;
use crate::app::controls::key_labels::KeyLabels;
use crate::app::state::preferences::Preferences;
use bevy::ecs::system::NonSendMarker;
use bevy::input::keyboard::{Key, KeyboardInput};
use bevy::prelude::*;
use bevy::window::WindowFocused;

/// The layout as the program starts. US where the system does not tell.
pub(crate) fn current_labels() -> KeyLabels {
    system::labels(None).unwrap_or_default()
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PreUpdate,
        follow_layout
            .after(bevy::input::InputSystems)
            .before(super::keyboard::apply_pressed_controls),
    );
}

/// Binds the controls anew when a key types something else than the known layout says, or when the
/// window gets the focus and the layout has changed meanwhile. Windows has a layout for each thread,
/// and the main one's counts.
fn follow_layout(
    mut inputs: MessageReader<KeyboardInput>,
    mut focused: MessageReader<WindowFocused>,
    keys: Res<ButtonInput<KeyCode>>,
    preferences: Res<Preferences>,
    mut bindings: ResMut<Bindings>,
    _on_main_thread: NonSendMarker,
) {
    let mut labels = bindings.labels().clone();
    if focused.read().any(|change| change.focused)
        && let Some(asked) = system::labels(None)
    {
        labels = asked;
    }
    for input in inputs.read().filter(|input| input.state.is_pressed()) {
        let Some(typed) = typed_plainly(input, &keys) else {
            continue;
        };
        if labels.agrees(input.key_code, typed) {
            continue;
        }
        // Letters of other scripts tell nothing of the Latin ones that their keyboards have, too.
        let tells = !typed.is_alphabetic() || is_latin(typed);
        match system::labels(tells.then_some((input.key_code, typed))) {
            Some(asked) => labels = asked,
            None if tells => labels.learn(input.key_code, typed),
            None => {}
        }
    }
    // A table that cannot be read with this layout leaves the keys as they are.
    if labels != *bindings.labels()
        && let Ok(bound) = Bindings::new(&preferences.settings.keys, &labels)
    {
        *bindings = bound;
    }
}

/// The letter or sign that a key types. None while Shift or Alt changes it; Ctrl does not.
fn typed_plainly(input: &KeyboardInput, keys: &ButtonInput<KeyCode>) -> Option<char> {
    use KeyCode::{AltLeft, AltRight, ShiftLeft, ShiftRight};
    let held = |code: KeyCode| keys.pressed(code) || keys.just_released(code);
    let Key::Character(text) = &input.logical_key else {
        return None;
    };
    let mut typed = text.chars();
    match (typed.next(), typed.next()) {
        (Some(typed), None)
            if !typed.is_control()
                && ![AltLeft, AltRight, ShiftLeft, ShiftRight]
                    .into_iter()
                    .any(held) =>
        {
            Some(typed)
        }
        _ => None,
    }
}

/// Whether a letter belongs to the Latin script: Basic Latin to Latin Extended-B.
pub(super) fn is_latin(letter: char) -> bool {
    letter.is_alphabetic() && letter <= '\u{24F}'
}
