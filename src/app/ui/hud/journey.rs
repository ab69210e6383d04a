//! Shows the title, the captions and the progress of a journey.

use super::board::{BRIGHT, Board, WARNING};
use super::presence::Presence;
use crate::app::controls::bindings::Bindings;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::state::paused::Paused;
use crate::app::ui::layout::{Layout, Slide};
use crate::app::ui::screen::{BOX, Screen};
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2, Rect, vec2};

/// Size of captions, in points.
const CAPTION: f32 = 20.0;
/// Size of the title, in points.
const TITLE: f32 = 32.0;
/// Room for the toast between the read-outs and captions, in points.
const TOAST: f32 = 44.0;
/// Largest width of the words, in points.
const MAX_WIDTH: f32 = 860.0;
/// Height of the progress bar, in points.
const BAR: f32 = 4.0;
/// Radius of the sign of a pause, in points.
const PAUSE: f32 = 24.0;

pub(super) fn show_journey(
    mut screen: Screen,
    player: Res<JourneyPlayer>,
    paused: Res<Paused>,
    presence: Res<Presence>,
    bindings: Res<Bindings>,
) {
    let Some((context, layout)) = screen.texts().filter(|_| player.is_playing()) else {
        return;
    };
    show_progress(context, layout, player.share() as f32);
    show_words((context, layout), &player, &presence, &bindings);
    if paused.0 {
        show_pause(context, layout);
    }
}

fn show_words(
    (context, layout): (&egui::Context, &mut Layout),
    player: &JourneyPlayer,
    presence: &Presence,
    bindings: &Bindings,
) {
    let Some(words) = player.words() else {
        return;
    };
    let strength = presence.opacity(words.since as f32, words.left as f32);
    let board = Board::new(context, "journey", strength);
    let (size, wish) = if words.is_title {
        let mut wish = layout.at(Align2::CENTER_TOP, Slide::Anywhere);
        wish.at.y += 0.12 * layout.bounds().height();
        (TITLE, wish.even_over_hole())
    } else {
        (CAPTION, layout.above_read_outs(TOAST))
    };
    let text = bindings.with_keys(words.text);
    board.paint_caption(layout, wish, (&text, size, BRIGHT), MAX_WIDTH);
}

/// Shows a bar along the lower edge of the window: the share of the journey that has been flown.
fn show_progress(context: &egui::Context, layout: &mut Layout, share: f32) {
    let layer = egui::LayerId::new(egui::Order::Background, "journey progress".into());
    let painter = context.layer_painter(layer);
    let mut bar = context.content_rect();
    bar.min.y = bar.bottom() - BAR;
    layout.take("journey progress", bar);
    painter.rect_filled(bar, 0.0, BOX);
    bar.set_width(bar.width() * share);
    painter.rect_filled(bar, 0.0, WARNING);
}

/// Shows two upright bars near the middle of the upper edge.
fn show_pause(context: &egui::Context, layout: &mut Layout) {
    let layer = egui::LayerId::new(egui::Order::Background, "pause".into());
    let painter = context.layer_painter(layer);
    let wish = layout.at(Align2::CENTER_TOP, Slide::Anywhere);
    let Some(place) = layout.place("pause", vec2(2.0 * PAUSE, 2.0 * PAUSE), wish) else {
        return;
    };
    let centre = place.center();
    painter.circle_filled(centre, PAUSE, BOX);
    for side in [-5.5, 5.5] {
        let upright = Rect::from_center_size(centre + vec2(side, 0.0), vec2(6.0, 20.0));
        painter.rect_filled(upright, 1.0, BRIGHT);
    }
}
