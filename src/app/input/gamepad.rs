//! Gamepads: the sticks fly and look, the buttons are bound as keys are. What reads the hardware is
//! the feature `gamepad`; everything here goes by Bevy's own [`Gamepad`] and does nothing while
//! there is none.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::table::{Action, Control, FlightInput};
use crate::app::state::toast::Toast;
use crate::app::ui::panel::Rebinding;
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

/// Share of a stick's way, and of a trigger's, that counts as none: worn ones do not come back to
/// the middle.
const DEAD_STICK: f64 = 0.15;
const DEAD_TRIGGER: f64 = 0.06;
/// The answer is this power of how far a stick is pushed, so that a little is really a little.
const CURVE: f64 = 2.0;

/// What a stick's place, each axis from -1 to 1, is worth: none in the dead middle, 1 at most, the
/// direction kept.
#[must_use]
pub fn deflection(stick: Vec2) -> DVec2 {
    let stick = stick.as_dvec2();
    stick.normalize_or_zero() * beyond(stick.length(), DEAD_STICK).powf(CURVE)
}

/// What a button's or trigger's place, from 0 to 1, is worth.
#[must_use]
pub fn squeeze(trigger: f32) -> f64 {
    beyond(trigger.into(), DEAD_TRIGGER)
}

/// How far along the way from `dead` to 1. A stick's corners are farther than its sides, and worth
/// no more.
fn beyond(place: f64, dead: f64) -> f64 {
    // A pad that reports nonsense is at rest.
    if place.is_finite() {
        ((place - dead) / (1.0 - dead)).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

/// The gamepads at hand, all of them as one. Nothing that is done with them counts while the window
/// has not the focus, or while a control waits for its new key or button.
#[derive(SystemParam)]
pub(crate) struct Pads<'w, 's> {
    pads: Query<'w, 's, &'static Gamepad>,
    windows: Query<'w, 's, &'static Window, With<PrimaryWindow>>,
    bindings: Res<'w, PadBindings>,
    rebinding: Res<'w, Rebinding>,
}

impl Pads<'_, '_> {
    /// Whether there is one.
    pub(crate) fn any(&self) -> bool {
        !self.pads.is_empty()
    }

    fn heard(&self) -> impl Iterator<Item = &Gamepad> {
        let heard = self.windows.iter().any(|window| window.focused) && !self.rebinding.waits();
        self.pads.iter().filter(move |_| heard)
    }

    /// Where the left stick is: right, up.
    pub(crate) fn left_stick(&self) -> DVec2 {
        self.heard().map(|pad| deflection(pad.left_stick())).sum()
    }

    /// Where the right stick is: right, up.
    pub(crate) fn right_stick(&self) -> DVec2 {
        self.heard().map(|pad| deflection(pad.right_stick())).sum()
    }

    /// How far a motion's buttons are pressed, from 0 to 1.
    pub(crate) fn motion(&self, motion: FlightInput) -> f64 {
        let holds =
            |control: &Control| matches!(control.action, Action::Hold(held) if held == motion);
        let buttons = self
            .bindings
            .iter()
            .filter(|(control, _)| holds(control))
            .flat_map(|(_, buttons)| buttons);
        let places = buttons.flat_map(|button| self.heard().filter_map(|pad| pad.get(*button)));
        places.map(squeeze).fold(0.0, f64::max)
    }

    /// Whether a control's button went down in this frame; if so, its name.
    pub(crate) fn pressed(&self, control: &Control) -> Option<String> {
        let buttons = self.bindings.of(control.id);
        self.heard()
            .any(|pad| pad.any_just_pressed(buttons.iter().copied()))
            .then(|| self.bindings.in_words(control))
    }

    /// Whether a hand is on one.
    pub(crate) fn in_use(&self) -> bool {
        let pushed = |pad: &Gamepad| {
            [pad.left_stick(), pad.right_stick()].map(deflection) != [DVec2::ZERO; 2]
        };
        self.heard()
            .any(|pad| pushed(pad) || pad.get_pressed().next().is_some())
    }
}

pub(crate) fn plugin(app: &mut App) {
    #[cfg(feature = "gamepad")]
    app.add_plugins(bevy_gilrs::GilrsPlugin);
    app.add_systems(Update, tell);
}

/// Says which gamepads come and go.
fn tell(
    mut connections: MessageReader<GamepadConnectionEvent>,
    names: Query<&Name>,
    bindings: Res<Bindings>,
    mut notice: ResMut<Toast>,
) {
    for GamepadConnectionEvent {
        gamepad,
        connection,
    } in connections.read()
    {
        let news = match connection {
            GamepadConnection::Connected { name, .. } => {
                let help = bindings.named("window.help");
                format!(
                    "{name}: the left stick flies, the right one looks around; {help} shows its buttons"
                )
            }
            GamepadConnection::Disconnected => {
                format!(
                    "{} is gone",
                    names.get(*gamepad).map_or("The gamepad", Name::as_str)
                )
            }
        };
        // One that is there from the start does not hide what was wrong with the settings.
        notice.add(&news);
    }
}
