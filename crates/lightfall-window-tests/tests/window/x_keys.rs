//! Keys as X names them.

use bevy::prelude::KeyCode;
use lightfall::app::{Bindable, Control};

/// The X name of a key.
pub fn x_key(code: KeyCode) -> String {
    let name = code.name().unwrap();
    let key = match name {
        "+" => "equal",
        "-" => "minus",
        "Keypad +" => "KP_Add",
        "Keypad -" => "KP_Subtract",
        "," => "comma",
        "." => "period",
        "/" => "slash",
        ";" => "semicolon",
        "'" => "apostrophe",
        "`" => "grave",
        "\\" => "backslash",
        "[" => "bracketleft",
        "]" => "bracketright",
        "Backspace" => "BackSpace",
        "Enter" => "Return",
        "Esc" => "Escape",
        "Space" => "space",
        "PageUp" => "Prior",
        "PageDown" => "Next",
        "Shift" => "Shift_L",
        "Right Shift" => "Shift_R",
        "Ctrl" => "Control_L",
        "Right Ctrl" => "Control_R",
        "Alt" => "Alt_L",
        "Right Alt" => "Alt_R",
        letter if letter.len() == 1 => return letter.to_lowercase(),
        other => other,
    };
    key.into()
}

/// The X names of all keys of a control, each with the control's modifier.
pub fn x_keys(control: &Control) -> Vec<String> {
    let prefix = control.modifier.map_or("", |modifier| modifier.prefix());
    let with_prefix = |code: &KeyCode| format!("{}{}", prefix.to_lowercase(), x_key(*code));
    control.keys.iter().map(with_prefix).collect()
}
