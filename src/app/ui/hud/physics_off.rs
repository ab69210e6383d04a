//! The line at the top that is shown while some of the physics is switched off.

use super::board::{Board, TEXT, WARNING};
use crate::app::controls::sections::field_in_words;
use crate::app::ui::layout::Slide;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui::Align2;
use lightfall_core::scene::{FIELDS, Scene, Value};
use lightfall_render::{ComparedScene, CurrentScene};

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
) {
    let (Some(mut line), Some((context, layout))) = (physics_off(&scene), screen.texts()) else {
        return;
    };
    // In a comparison of different physics, the present scene is on the right side.
    if let Some((pinned, layout)) = compared.drawn()
        && layout.divider().is_some()
        && pinned.effects != scene.effects
    {
        line = line.replacen("Physics off", "Right side off", 1);
    }
    let board = Board::new(context, "physics off", 1.0);
    let wish = layout.at(Align2::CENTER_TOP, Slide::Anywhere);
    board.paint_text(layout, wish, (&line, TEXT, WARNING), f32::INFINITY);
}
