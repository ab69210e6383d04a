//! Keys that come after a click on the user interface. Only the frame of the click shows whether a text
//! field takes the keyboard, so these keys wait for the next frame. Then a field has the keyboard and
//! gets every one of them, or the controls get them.

use super::key_modifiers::{give_keys_their_modifiers, place_of_key};
use super::typing::Typing;
use bevy::input::keyboard::KeyboardInput;
use bevy::prelude::*;
use bevy::window::WindowEvent;
use bevy_egui::{EguiContext, EguiInput, EguiPreUpdateSet, PrimaryEguiContext, egui};

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PreUpdate,
        hold_keys_after_click
            .after(give_keys_their_modifiers)
            .before(EguiPreUpdateSet::BeginPass),
    );
}

/// Takes what was typed after a click on the user interface out of this frame's input of egui, and puts
/// what was taken from the last frame before it.
pub(crate) fn hold_keys_after_click(
    mut window: MessageReader<WindowEvent>,
    mut keys: MessageReader<KeyboardInput>,
    mut contexts: Query<(&mut EguiContext, &mut EguiInput), With<PrimaryEguiContext>>,
    mut typing: ResMut<Typing>,
    mut held: Local<Vec<egui::Event>>,
) {
    typing.keys_before_click = None;
    let keys: Vec<&KeyboardInput> = keys.read().collect();
    let Ok((mut context, mut input)) = contexts.single_mut() else {
        return window.clear();
    };
    let events = &mut input.events;
    let before = keys_before_click(window.read(), events, context.get_mut());
    let due = std::mem::take(&mut *held);
    if let Some(before) = before {
        let mut first = 0;
        for key in keys.iter().take(before) {
            first = place_of_key(events, first, key).map_or(first, |place| place + 1);
        }
        held.extend(events.extract_if(first.., |event| is_typed(event)));
    }
    events.splice(0..0, due);
    typing.keys_before_click = before;
}

/// The number of messages of keys that come before the first press or release of the left button over
/// the user interface. `None` without such a click.
fn keys_before_click<'a>(
    messages: impl Iterator<Item = &'a WindowEvent>,
    events: &[egui::Event],
    context: &egui::Context,
) -> Option<usize> {
    let mut clicks = events.iter().filter_map(|event| match event {
        egui::Event::PointerButton {
            pos,
            button: egui::PointerButton::Primary,
            ..
        } => Some(*pos),
        _ => None,
    });
    let mut keys = 0;
    for message in messages {
        match message {
            WindowEvent::KeyboardInput(_) => keys += 1,
            WindowEvent::MouseButtonInput(click) if click.button == MouseButton::Left => {
                let layer = clicks.next().and_then(|place| context.layer_id_at(place));
                if layer.is_some_and(|layer| layer.order != egui::Order::Background) {
                    return Some(keys);
                }
            }
            _ => {}
        }
    }
    None
}

/// Whether an event comes from the keyboard.
fn is_typed(event: &egui::Event) -> bool {
    use egui::Event::{Copy, Cut, Ime, Key, Paste, Text};
    matches!(event, Copy | Cut | Ime(_) | Key { .. } | Paste(_) | Text(_))
}
