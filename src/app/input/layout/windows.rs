//! The layout that Windows has set for this program.

use crate::app::controls::key_labels::KeyLabels;
use bevy::prelude::KeyCode;
use windows_sys::Win32::UI::Input::KeyboardAndMouse::{
    GetKeyboardLayout, MAPVK_VK_TO_CHAR, MAPVK_VSC_TO_VK_EX, MapVirtualKeyExW,
};

/// The bit that marks a key which waits for a letter to put its sign on.
const DEAD: u32 = 1 << 31;

/// The prints of the layout. None if it does not type this character, which may be right where the
/// layout has just been switched.
#[expect(
    unsafe_code,
    reason = "Windows has no other interface to its keyboard layouts"
)]
pub(super) fn labels(typed: Option<(KeyCode, char)>) -> Option<KeyLabels> {
    // SAFETY: these functions take numbers and return numbers.
    let print = |code: u8| unsafe {
        let layout = GetKeyboardLayout(0);
        let key = MapVirtualKeyExW(u32::from(code), MAPVK_VSC_TO_VK_EX, layout);
        char::from_u32(MapVirtualKeyExW(key, MAPVK_VK_TO_CHAR, layout) & !DEAD)
    };
    let labels = KeyLabels::new(|code| print(code).filter(|print| !print.is_control()));
    match typed {
        Some((place, typed)) if !labels.agrees(place, typed) => None,
        _ => Some(labels),
    }
}
