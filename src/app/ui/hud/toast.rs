//! Draws the toast at the bottom of the window, above the read-outs.

use super::board::{BRIGHT, Board};
use super::presence::Presence;
use crate::app::state::toast::Toast;
use crate::app::state::window_shot::WindowShot;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;

/// Size of its text, in points.
const TEXT: f32 = 15.0;
/// Largest width of its text, in points.
const MAX_WIDTH: f32 = 620.0;

pub(super) fn show_toast(
    mut screen: Screen,
    toast: Res<Toast>,
    presence: Res<Presence>,
    shot: Res<WindowShot>,
) {
    let is_shown = !toast.text().is_empty() && !shot.holds_still();
    let Some((context, layout)) = screen.messages() else {
        return;
    };
    layout.release();
    if !is_shown {
        return;
    }
    let strength = presence.opacity(toast.since(), toast.left());
    let board = Board::new(context, "toast", strength);
    let wish = layout.above_read_outs(0.0);
    board.paint_text(layout, wish, (toast.text(), TEXT, BRIGHT), MAX_WIDTH);
}
