//! A clock with one hand.

use crate::app::ui::hud::board::{BRIGHT, QUIET};
use bevy_egui::egui::{Color32, Painter, Pos2, Stroke, vec2};
use std::f32::consts::TAU;

/// Number of strokes around a dial.
const STROKES: usize = 12;

/// Draws a dial whose hand has gone round so often: the whole turns do not show.
pub(super) fn draw_dial(painter: &Painter, middle: Pos2, radius: f32, turns: f64, hand: Color32) {
    painter.circle_stroke(middle, radius, Stroke::new(1.5, QUIET));
    let at = |share: f32, length: f32| {
        let angle = share * TAU;
        middle + length * radius * vec2(angle.sin(), -angle.cos())
    };
    for stroke in 0..STROKES {
        let share = stroke as f32 / STROKES as f32;
        let from = if stroke % 3 == 0 { 0.74 } else { 0.86 };
        painter.line_segment([at(share, from), at(share, 0.96)], Stroke::new(1.0, QUIET));
    }
    let share = turns.rem_euclid(1.0) as f32;
    painter.line_segment([at(share, -0.18), at(share, 0.82)], Stroke::new(2.5, hand));
    painter.circle_filled(middle, 2.5, BRIGHT);
}
