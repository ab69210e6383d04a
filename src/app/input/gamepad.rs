//! Gamepads: the sticks fly and look, and the buttons are bound to controls as keys are. The
//! feature `gamepad` reads the hardware. Everything here uses Bevy's own [`Gamepad`] and does
//! nothing while there is none.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::control::{Action, Control, FlightInput};
use crate::app::state::kiosk::outside_kiosk;
use crate::app::state::menu::Menu;
use crate::app::state::rebinding::Rebinding;
use crate::app::state::toast::Toast;
use bevy::ecs::system::SystemParam;
use bevy::input::gamepad::{GamepadConnection, GamepadConnectionEvent};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use glam::DVec2;

/// A note for users of a build that reads no gamepad; `None` in one that does.
pub const NO_GAMEPAD: Option<&str> = if cfg!(feature = "gamepad") {
    None
} else {
    Some(
        "This build reads no gamepad; ./play makes one that does where libudev-dev and pkg-config are installed.",
    )
};

/// Share of a stick's travel that counts as none: worn sticks do not return to the middle.
const STICK_DEAD_ZONE: f64 = 0.15;
/// Share of a trigger's travel that counts as none.
const TRIGGER_DEAD_ZONE: f64 = 0.06;
/// A stick's response is this power of how far it is pushed, so that small movements are fine.
const RESPONSE_EXPONENT: f64 = 2.0;

/// The response to a stick's position, each axis from -1 to 1: zero in the dead zone, of length 1
/// at most, in the direction of the stick.
#[must_use]
pub fn deflection(stick: Vec2) -> DVec2 {
    let stick = stick.as_dvec2();
    stick.normalize_or_zero() * beyond(stick.length(), STICK_DEAD_ZONE).powf(RESPONSE_EXPONENT)
}

/// The response to a button's or trigger's position, from 0 to 1.
#[must_use]
pub fn squeeze(trigger: f32) -> f64 {
    beyond(trigger.into(), TRIGGER_DEAD_ZONE)
}

/// How far a position is along the way from `dead` to 1. A stick's corners are farther away than
/// its sides, and count no more.
fn beyond(position: f64, dead: f64) -> f64 {
    // A pad that reports no number is at rest.
    if position.is_finite() {
        ((position - dead) / (1.0 - dead)).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

/// All gamepads, as if they were one. They do nothing while the window lacks the focus, while the
/// menu is open, or while a control waits for its new key or button.
#[derive(SystemParam)]
pub(crate) struct Pads<'w, 's> {
    pads: Query<'w, 's, &'static Gamepad>,
    windows: Query<'w, 's, &'static Window, With<PrimaryWindow>>,
    bindings: Res<'w, PadBindings>,
    rebinding: Res<'w, Rebinding>,
    menu: Res<'w, Menu>,
}

impl Pads<'_, '_> {
    /// Whether there is a gamepad.
    pub(crate) fn any(&self) -> bool {
        !self.pads.is_empty()
    }

    fn active(&self) -> impl Iterator<Item = &Gamepad> {
        let active = self.windows.iter().any(|window| window.focused)
            && self.rebinding.0.is_none()
            && !self.menu.is_open();
        self.pads.iter().filter(move |_| active)
    }

    /// The response to the left stick: right, up.
    pub(crate) fn left_stick(&self) -> DVec2 {
        self.active().map(|pad| deflection(pad.left_stick())).sum()
    }

    /// The response to the right stick: right, up.
    pub(crate) fn right_stick(&self) -> DVec2 {
        self.active().map(|pad| deflection(pad.right_stick())).sum()
    }

    /// How far an input's buttons are pressed, from 0 to 1.
    pub(crate) fn strength(&self, input: FlightInput) -> f64 {
        let holds =
            |control: &Control| matches!(control.action, Action::Hold(held) if held == input);
        let buttons = self
            .bindings
            .iter()
            .filter(|(control, _)| holds(control))
            .flat_map(|(_, buttons)| buttons);
        let positions = buttons.flat_map(|button| self.active().filter_map(|pad| pad.get(*button)));
        positions.map(squeeze).fold(0.0, f64::max)
    }

    /// The name of a control's button, if the button went down in this frame.
    pub(crate) fn pressed(&self, control: &Control) -> Option<String> {
        let buttons = self.bindings.of(control.id);
        self.active()
            .any(|pad| pad.any_just_pressed(buttons.iter().copied()))
            .then(|| self.bindings.label_of(control))
    }

    /// Whether a stick or a button is being used.
    pub(crate) fn in_use(&self) -> bool {
        let pushed = |pad: &Gamepad| {
            [pad.left_stick(), pad.right_stick()].map(deflection) != [DVec2::ZERO; 2]
        };
        self.active()
            .any(|pad| pushed(pad) || pad.get_pressed().next().is_some())
    }
}

pub(crate) fn plugin(app: &mut App) {
    #[cfg(feature = "gamepad")]
    app.add_plugins(bevy_gilrs::GilrsPlugin);
    app.add_systems(Update, announce_gamepads.run_if(outside_kiosk));
}

/// Says which gamepads are connected and disconnected.
fn announce_gamepads(
    mut connections: MessageReader<GamepadConnectionEvent>,
    names: Query<&Name>,
    bindings: Res<Bindings>,
    mut toast: ResMut<Toast>,
) {
    for GamepadConnectionEvent {
        gamepad,
        connection,
    } in connections.read()
    {
        let news = match connection {
            GamepadConnection::Connected { name, .. } => {
                let help = bindings.first_label("window.help");
                format!(
                    "{name}: the left stick flies, the right one looks around; {help} shows its buttons"
                )
            }
            GamepadConnection::Disconnected => {
                format!(
                    "{} was disconnected",
                    names.get(*gamepad).map_or("The gamepad", Name::as_str)
                )
            }
        };
        // A gamepad found at the start must not hide what was wrong with the settings.
        toast.add(&news);
    }
}
