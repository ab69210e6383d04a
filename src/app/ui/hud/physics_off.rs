//! The line at the top that is shown while some of the physics is switched off.

use super::board::{Board, TEXT, WARNING};
use super::title::TitleBox;
use crate::app::controls::sections::field_in_words;
use crate::app::ui::screen::{MARGIN, Screen};
use bevy::prelude::*;
use bevy_egui::egui;
use lightfall_core::scene::{FIELDS, Scene, Value};
use lightfall_render::{ComparedScene, ComparisonLayout, CurrentScene};

/// Names the effects that are switched off, as in `Physics off: Doppler shift, beaming`. None if all are
/// on.
#[must_use]
pub fn physics_off(scene: &Scene) -> Option<String> {
    let off: Vec<String> = FIELDS
        .iter()
        .filter(|field| field.key.starts_with("effects."))
        .filter(|field| field.get(scene) == Value::Boolean(false))
        .map(|field| field_in_words(field.key))
        .collect();
    (!off.is_empty()).then(|| format!("Physics off: {}", off.join(", ")))
}

pub(super) fn show_physics_off(
    mut screen: Screen,
    scene: Res<CurrentScene>,
    compared: Res<ComparedScene>,
    title: Res<TitleBox>,
) {
    let (Some(mut line), Some((context, room))) = (physics_off(&scene), screen.room()) else {
        return;
    };
    // In a comparison of different physics, the present scene is on the right side.
    if let Some((pinned, ComparisonLayout::SideBySide { .. })) = compared.drawn()
        && pinned.effects != scene.effects
    {
        line = line.replacen("Physics off", "Right side off", 1);
    }
    let mut board = Board::new(context, "physics off", 1.0);
    board.add_line(board.text(&line, TEXT, WARNING, room.width().max(1.0)), 0.0);
    // In the middle, or below a title that would overlap it.
    let middle = board.place(egui::Align2::CENTER_TOP, room.center_top());
    if let Some(title) = title.0.filter(|title| title.right() >= middle.left()) {
        let below = egui::pos2(room.left(), title.bottom() + 0.5 * MARGIN);
        board.paint(egui::Align2::LEFT_TOP, below);
    } else {
        board.paint(egui::Align2::CENTER_TOP, room.center_top());
    }
}
