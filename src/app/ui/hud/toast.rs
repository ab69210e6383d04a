//! Draws the toast at the bottom of the window, above the read-outs.

use super::board::{BOTTOM_ROW, BRIGHT, Board, MIN_WIDTH};
use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::app::ui::screen::{MARGIN, free_room};
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

/// Size of its text, in points.
const TEXT: f32 = 15.0;
/// Largest width of its text, in points.
const MAX_WIDTH: f32 = 620.0;

pub(super) fn show_toast(
    mut contexts: EguiContexts,
    toast: Res<Toast>,
    overlays: Res<Overlays>,
    preferences: Res<Preferences>,
) -> Result {
    if toast.text().is_empty() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let mut strength = toast.strength();
    if preferences.settings.reduced_motion {
        strength = strength.ceil();
    }
    let mut board = Board::new(context, "toast", strength);
    // The toast is between the panels, or over them if they leave too little room.
    let mut room = free_room(context, &overlays);
    if room.width() < MIN_WIDTH {
        room = context.content_rect().shrink(MARGIN);
        board.raise();
    }
    let width = (room.width() - 2.0 * MARGIN).clamp(1.0, MAX_WIDTH);
    board.add_line(board.text(toast.text(), TEXT, BRIGHT, width), 0.0);
    let bottom = (room.bottom() - BOTTOM_ROW).max(room.center().y);
    let place = egui::pos2(room.center().x, bottom);
    board.paint(egui::Align2::CENTER_BOTTOM, place);
    Ok(())
}
