//! Whether the player's hands hold anything: a key, a button, the screen or a gamepad's stick.

use super::gamepad::Pads;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;

/// All devices that hands use.
#[derive(SystemParam)]
pub(crate) struct Hands<'w, 's> {
    pub(crate) keys: Res<'w, ButtonInput<KeyCode>>,
    buttons: Res<'w, ButtonInput<MouseButton>>,
    touches: Res<'w, Touches>,
    pads: Pads<'w, 's>,
}

impl Hands<'_, '_> {
    /// Whether a key, a mouse button or a gamepad's part is held, or a finger is on the screen.
    pub(crate) fn hold(&self) -> bool {
        self.keys.get_pressed().next().is_some()
            || self.buttons.get_pressed().next().is_some()
            || self.touches.iter().next().is_some()
            || self.pads.in_use()
    }
}
