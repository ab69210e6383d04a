//! What visitors do in a frame, by any device.

use super::gamepad::Pads;
use super::held::ClaimedKeys;
use crate::app::state::kiosk_round::VisitorInput;
use bevy::ecs::system::SystemParam;
use bevy::input::keyboard::KeyboardInput;
use bevy::input::mouse::AccumulatedMouseScroll;
use bevy::input::touch::{TouchInput, TouchPhase};
use bevy::prelude::*;

/// The devices that visitors use. A key that is held counts once: something may lie on it.
#[derive(SystemParam)]
pub(crate) struct Visitors<'w, 's> {
    keyboard: MessageReader<'w, 's, KeyboardInput>,
    touches: MessageReader<'w, 's, TouchInput>,
    pointer: MessageReader<'w, 's, CursorMoved>,
    buttons: Res<'w, ButtonInput<MouseButton>>,
    wheel: Res<'w, AccumulatedMouseScroll>,
    keys: Res<'w, ButtonInput<KeyCode>>,
    claimed: ResMut<'w, ClaimedKeys>,
    pads: Pads<'w, 's>,
    pad_was_used: Local<'s, bool>,
}

impl Visitors<'_, '_> {
    /// What they did in this frame.
    pub(crate) fn input(&mut self) -> VisitorInput {
        let pad_was_used = std::mem::replace(&mut *self.pad_was_used, self.pads.in_use());
        // Every message is read, so that none counts twice.
        let [mut acts, mut moves] = [false; 2];
        for input in self.keyboard.read().filter(|input| !input.repeat) {
            acts |= input.state.is_pressed();
            moves = true;
        }
        for touch in self.touches.read() {
            acts |= touch.phase == TouchPhase::Started;
            moves = true;
        }
        moves |= self.pointer.read().count() > 0 || *self.pad_was_used;
        acts |= self.buttons.get_just_pressed().next().is_some()
            || self.wheel.delta != Vec2::ZERO
            || *self.pad_was_used && !pad_was_used;
        match (acts, moves) {
            (true, _) => VisitorInput::Acts,
            (false, true) => VisitorInput::Moves,
            (false, false) => VisitorInput::Nothing,
        }
    }

    /// Lets keys that are held now do nothing until they are pressed again.
    pub(crate) fn claim_held_keys(&mut self) {
        self.claimed.0.extend(self.keys.get_pressed());
    }
}
