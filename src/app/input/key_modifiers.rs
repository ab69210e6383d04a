//! The modifiers of each key that a text field gets. bevy_egui knows only those that are held at the
//! end of a frame, so that a Ctrl+A that comes and goes within one slow frame would type an `a`.

use bevy::input::keyboard::{Key, KeyboardFocusLost, KeyboardInput};
use bevy::prelude::*;
use bevy_egui::helpers::{bevy_to_egui_key, bevy_to_egui_physical_key};
use bevy_egui::{EguiInput, EguiPreUpdateSet, PrimaryEguiContext, egui};

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PreUpdate,
        give_keys_their_modifiers
            .after(EguiPreUpdateSet::ProcessInput)
            .before(EguiPreUpdateSet::BeginPass),
    );
}

/// Follows the keys in their order. Each key gets the modifiers that were held with it, and a key
/// that was pressed with Ctrl types nothing.
pub(crate) fn give_keys_their_modifiers(
    mut keys: MessageReader<KeyboardInput>,
    mut focus_lost: MessageReader<KeyboardFocusLost>,
    mut inputs: Query<&mut EguiInput, With<PrimaryEguiContext>>,
    mut held: Local<egui::Modifiers>,
) {
    if focus_lost.read().count() > 0 {
        *held = egui::Modifiers::NONE;
    }
    let pressed: Vec<_> = keys
        .read()
        .map(|input| {
            hold(&mut held, &input.logical_key, input.state.is_pressed());
            (input, *held)
        })
        .collect();
    for mut input in &mut inputs {
        let events = &mut input.events;
        let mut next = 0;
        for (message, modifiers) in &pressed {
            let Some(mut place) = place_of_key(events, next, message) else {
                continue;
            };
            if let egui::Event::Key { modifiers: of, .. } = &mut events[place] {
                *of = *modifiers;
            }
            // The text of a key comes right before the key. Ctrl with Alt is AltGr, which types.
            let types = !modifiers.command || modifiers.alt;
            let own_text = match &message.logical_key {
                Key::Character(text) if message.state.is_pressed() => text.as_str(),
                Key::Space if message.state.is_pressed() => " ",
                _ => "",
            };
            let before = place.checked_sub(1).map(|before| &events[before]);
            let typed = matches!(before, Some(egui::Event::Text(text)) if text == own_text);
            if typed && !types {
                events.remove(place - 1);
                place -= 1;
            }
            next = place + 1;
        }
    }
}

/// The place of a key's event among those from the place `first` on.
pub(super) fn place_of_key(
    events: &[egui::Event],
    first: usize,
    message: &KeyboardInput,
) -> Option<usize> {
    let key = bevy_to_egui_key(&message.logical_key)
        .or_else(|| bevy_to_egui_physical_key(&message.key_code));
    let found = events.iter().skip(first).position(|event| {
        matches!(event, egui::Event::Key { key: of, pressed, .. }
            if Some(*of) == key && *pressed == message.state.is_pressed())
    });
    found.map(|found| first + found)
}

/// Holds a modifier, or lets it go.
fn hold(held: &mut egui::Modifiers, key: &Key, pressed: bool) {
    let mac = cfg!(target_os = "macos");
    match key {
        Key::Shift => held.shift = pressed,
        Key::Alt => held.alt = pressed,
        Key::Control => {
            held.ctrl = pressed;
            if !mac {
                held.command = pressed;
            }
        }
        Key::Super | Key::Meta if mac => {
            (held.command, held.mac_cmd) = (pressed, pressed);
        }
        _ => {}
    }
}
