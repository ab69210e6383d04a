//! The buttons of a gamepad: their names, and the controls that are bound to them by default.
//! Buttons are known by their place and named as on the most common pad: the lowest of the four on
//! the right is A here, whatever is printed on it.

use bevy::prelude::GamepadButton;

/// Every button that a control can be bound to, with its name.
pub(crate) const NAMES: &[(GamepadButton, &str)] = &[
    (GamepadButton::South, "A"),
    (GamepadButton::East, "B"),
    (GamepadButton::West, "X"),
    (GamepadButton::North, "Y"),
    (GamepadButton::LeftTrigger, "LB"),
    (GamepadButton::RightTrigger, "RB"),
    (GamepadButton::LeftTrigger2, "LT"),
    (GamepadButton::RightTrigger2, "RT"),
    (GamepadButton::Select, "View"),
    (GamepadButton::Start, "Menu"),
    (GamepadButton::Mode, "Guide"),
    (GamepadButton::LeftThumb, "L3"),
    (GamepadButton::RightThumb, "R3"),
    (GamepadButton::DPadUp, "D-Up"),
    (GamepadButton::DPadDown, "D-Down"),
    (GamepadButton::DPadLeft, "D-Left"),
    (GamepadButton::DPadRight, "D-Right"),
    (GamepadButton::C, "C"),
    (GamepadButton::Z, "Z"),
];

/// The controls that have default buttons, by name. The sticks fly and look; like the mouse, they
/// cannot be bound to anything else.
const DEFAULTS: &[(&str, &[GamepadButton])] = &[
    ("fly.up", &[GamepadButton::DPadUp]),
    ("fly.down", &[GamepadButton::DPadDown]),
    ("fly.roll_left", &[GamepadButton::LeftTrigger]),
    ("fly.roll_right", &[GamepadButton::RightTrigger]),
    ("fly.faster", &[GamepadButton::RightTrigger2]),
    ("fly.slower", &[GamepadButton::LeftTrigger2]),
    ("journey.fly", &[GamepadButton::South]),
    ("motion.let_go", &[GamepadButton::East]),
    ("scene.undo", &[GamepadButton::West]),
    ("scene.spin", &[GamepadButton::North]),
    ("preset.previous", &[GamepadButton::DPadLeft]),
    ("preset.next", &[GamepadButton::DPadRight]),
    ("fly.orbit", &[GamepadButton::LeftThumb]),
    ("fly.face", &[GamepadButton::RightThumb]),
    ("fly.escape", &[GamepadButton::Start]),
    ("window.help", &[GamepadButton::Select]),
];

/// The default buttons of the control with this name.
#[must_use]
pub fn default_buttons(id: &str) -> &'static [GamepadButton] {
    DEFAULTS
        .iter()
        .find(|(control, _)| *control == id)
        .map_or(&[], |(_, buttons)| buttons)
}
