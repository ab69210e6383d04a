//! Shows the title, the captions and the progress of a journey.

use super::board::{BOTTOM_ROW, BRIGHT, Board, WARNING};
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::state::paused::Paused;
use crate::app::state::preferences::Preferences;
use crate::app::ui::screen::{BOX, MARGIN, Screen};
use bevy::prelude::*;
use bevy_egui::egui;

/// Size of captions, in points.
const CAPTION: f32 = 20.0;
/// Size of the title, in points.
const TITLE: f32 = 32.0;
/// Room for the toast between the read-outs and captions, in points.
const TOAST: f32 = 44.0;
/// Largest width of the words, in points.
const MAX_WIDTH: f32 = 860.0;
/// Seconds in which words fade in and fade out.
const FADE: f64 = 0.4;
/// Height of the progress bar, in points.
const BAR: f32 = 4.0;

pub(super) fn show_journey(
    mut screen: Screen,
    player: Res<JourneyPlayer>,
    paused: Res<Paused>,
    preferences: Res<Preferences>,
) {
    let Some((context, room)) = screen.room().filter(|_| player.is_playing()) else {
        return;
    };
    show_words(context, room, &player, preferences.settings.reduced_motion);
    show_progress(context, player.share() as f32);
    if paused.0 {
        show_pause(context, room.center_top());
    }
}

fn show_words(
    context: &egui::Context,
    room: egui::Rect,
    player: &JourneyPlayer,
    reduced_motion: bool,
) {
    let Some(words) = player.words() else {
        return;
    };
    let strength = if reduced_motion {
        1.0
    } else {
        (words.since.min(words.left) / FADE).clamp(0.0, 1.0) as f32
    };
    let width = (room.width() - 2.0 * MARGIN).clamp(1.0, MAX_WIDTH);
    let mut board = Board::new(context, "journey", strength);
    let (size, anchor, y) = if words.is_title {
        let top = room.top() + 0.12 * room.height();
        (TITLE, egui::Align2::CENTER_TOP, top)
    } else {
        let bottom = (room.bottom() - BOTTOM_ROW - TOAST).max(room.center().y);
        (CAPTION, egui::Align2::CENTER_BOTTOM, bottom)
    };
    board.add_line(board.text(words.text, size, BRIGHT, width), 0.0);
    board.paint(anchor, egui::pos2(room.center().x, y));
}

/// Shows a bar along the lower edge of the window: the share of the journey that has been flown.
fn show_progress(context: &egui::Context, share: f32) {
    let layer = egui::LayerId::new(egui::Order::Background, "journey progress".into());
    let painter = context.layer_painter(layer);
    let mut bar = context.content_rect();
    bar.min.y = bar.bottom() - BAR;
    painter.rect_filled(bar, 0.0, BOX);
    bar.set_width(bar.width() * share);
    painter.rect_filled(bar, 0.0, WARNING);
}

/// Shows two upright bars below the middle of the upper edge.
fn show_pause(context: &egui::Context, top: egui::Pos2) {
    let layer = egui::LayerId::new(egui::Order::Background, "pause".into());
    let painter = context.layer_painter(layer);
    let centre = top + egui::vec2(0.0, 60.0);
    painter.circle_filled(centre, 24.0, BOX);
    for side in [-5.5, 5.5] {
        let size = egui::vec2(6.0, 20.0);
        let upright = egui::Rect::from_center_size(centre + egui::vec2(side, 0.0), size);
        painter.rect_filled(upright, 1.0, BRIGHT);
    }
}
