//! Controls that are held down, on the keyboard or on a gamepad.

use super::gamepad::Pads;
use super::typing::Typing;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{Action, FlightInput};
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;

/// The keys that were pressed with a modifier with which they mean a control. They do not fly until
/// they are pressed again, even if the modifier is let go first.
#[derive(Resource, Default)]
pub(crate) struct ClaimedKeys(pub(super) Vec<KeyCode>);

/// The controls that are held down.
#[derive(SystemParam)]
pub(crate) struct HeldControls<'w, 's> {
    keys: Res<'w, ButtonInput<KeyCode>>,
    bindings: Res<'w, Bindings>,
    claimed: Res<'w, ClaimedKeys>,
    pub(crate) typing: Res<'w, Typing>,
    pub(crate) pads: Pads<'w, 's>,
}

impl HeldControls<'_, '_> {
    /// One input against its opposite, from 1 to -1.
    pub(crate) fn axis(&self, plus: FlightInput, minus: FlightInput) -> f64 {
        self.strength(plus) - self.strength(minus)
    }

    /// Whether a control that moves the camera is held.
    pub(crate) fn any_flight(&self) -> bool {
        FlightInput::THRUST
            .into_iter()
            .any(|input| self.strength(input) > 0.0)
    }

    /// One input against its opposite, from 1 to -1, by keys alone.
    pub(crate) fn key_axis(&self, plus: FlightInput, minus: FlightInput) -> f64 {
        f64::from(i8::from(self.is_by_key(plus)) - i8::from(self.is_by_key(minus)))
    }

    /// How far an input's key or button is pressed, from 0 to 1.
    fn strength(&self, input: FlightInput) -> f64 {
        if self.is_by_key(input) {
            1.0
        } else {
            self.pads.strength(input)
        }
    }

    /// Whether an input's key is pressed.
    fn is_by_key(&self, input: FlightInput) -> bool {
        let holds = |action| matches!(action, Action::Hold(held) if held == input);
        // Modifiers are not asked for: Shift flies faster, Alt slower and Ctrl down.
        // A tap that begins and ends within one slow frame counts for that frame.
        let held = |code: &KeyCode| self.keys.pressed(*code) || self.keys.just_pressed(*code);
        let flies = |code: &KeyCode| held(code) && !self.claimed.0.contains(code);
        let mut controls = self
            .bindings
            .iter()
            .filter(|(control, _)| holds(control.action));
        !self.typing.is_on() && controls.any(|(_, codes)| codes.iter().any(flies))
    }
}
