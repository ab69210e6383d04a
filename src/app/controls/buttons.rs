//! The buttons of a gamepad: their names, and which controls have one. They go by their place, and
//! are named as on the most common pad; what is the lowest of the four on the right is A here,
//! whatever is printed on it.

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

/// The controls that have a button where the settings say nothing else, by name. The sticks fly and
/// look, and have no other use, as the mouse has none.
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
    ("picture.bypass", &[GamepadButton::LeftThumb]),
    ("window.screenshot", &[GamepadButton::RightThumb]),
    ("window.panel", &[GamepadButton::Start]),
    ("window.help", &[GamepadButton::Select]),
];

/// The buttons of the control with this name, where the settings say nothing else.
#[must_use]
pub fn default_buttons(id: &str) -> &'static [GamepadButton] {
    DEFAULTS
        .iter()
        .find(|(control, _)| *control == id)
        .map_or(&[], |(_, buttons)| buttons)
}
