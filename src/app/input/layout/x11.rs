//! The layout that an X server knows, also one that serves Wayland.

use super::is_latin;
use crate::app::controls::key_labels::{KeyLabels, PRINTED};
use crate::app::session::display::x_connection;
use bevy::prelude::KeyCode;
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{ConnectionExt, GetKeyboardMappingReply};

/// An X server's number of a key is the scan code and this.
const FIRST_KEY: u8 = 8;
/// How many layouts, between which the user switches, the server's table holds.
const LAYOUTS: usize = 2;
/// Columns of the table for each layout: without Shift, and with it.
const COLUMNS: usize = 2;

/// The prints of the layout in which a key types this character, or of the first layout with Latin
/// letters. None if no server answers or no layout has this key.
pub(super) fn labels(typed: Option<(KeyCode, char)>) -> Option<KeyLabels> {
    let connection = x_connection().as_ref().ok()?;
    let [first, last] = [
        connection.setup().min_keycode,
        connection.setup().max_keycode,
    ];
    let table = connection
        .get_keyboard_mapping(first, last - first + 1)
        .ok()?
        .reply()
        .ok()?;
    let mut layouts = (0..LAYOUTS).map(|layout| {
        KeyLabels::new(|code| print(&table, usize::from(code + FIRST_KEY - first), layout))
    });
    if let Some((place, typed)) = typed {
        return layouts.find(|labels| labels.agrees(place, typed));
    }
    let layouts: Vec<_> = layouts.collect();
    let with_latin = (0..LAYOUTS).find(|layout| {
        let letters = PRINTED.iter().filter(|(_, usual, _)| usual.is_alphabetic());
        let types_latin = |code: &u8| {
            let row = usize::from(code + FIRST_KEY - first);
            print(&table, row, *layout).is_some_and(is_latin)
        };
        2 * letters
            .clone()
            .filter(|(_, _, code)| types_latin(code))
            .count()
            > letters.count()
    });
    layouts.into_iter().nth(with_latin.unwrap_or_default())
}

/// What a key types in a layout without Shift.
fn print(table: &GetKeyboardMappingReply, row: usize, layout: usize) -> Option<char> {
    let width = usize::from(table.keysyms_per_keycode);
    let column = COLUMNS * layout;
    if column >= width {
        return None;
    }
    let symbol = *table.keysyms.get(row * width + column)?;
    let sign = DEAD_KEYS.iter().find(|(dead, _)| *dead == symbol);
    let typed = sign.map_or_else(
        || xkeysym::Keysym::new(symbol).key_char(),
        |(_, sign)| Some(*sign),
    );
    typed.filter(|typed| !typed.is_control())
}

/// Keys that wait for a letter to put their sign on: the X server's symbols from X11/keysymdef.h.
const DEAD_KEYS: [(u32, char); 9] = [
    (0xFE50, '`'),
    (0xFE51, '´'),
    (0xFE52, '^'),
    (0xFE53, '~'),
    (0xFE57, '¨'),
    (0xFE58, '°'),
    (0xFE5A, 'ˇ'),
    (0xFE5B, '¸'),
    (0xFE5C, '˛'),
];
