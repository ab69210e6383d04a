//! The line at the top that is shown while some of the physics is switched off.

use super::board::{Board, MARGIN, TEXT, WARNING, free_room};
use super::title::{TitleBox, show_title};
use crate::app::state::overlays::Overlays;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use lightfall_core::scene::Effects;
use lightfall_render::{ComparedScene, ComparisonLayout, CurrentScene};

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_physics_off.after(show_title));
}

/// Names the effects that are switched off, as in `Physics off: Doppler shift, beaming`. None if all are
/// on.
#[must_use]
pub fn physics_off(effects: Effects) -> Option<String> {
    let off: Vec<&str> = [
        (effects.lensing, "lensing"),
        (effects.doppler, "Doppler shift"),
        (effects.beaming, "beaming"),
        (effects.gravitational_shift, "gravitational shift"),
        (effects.aberration, "aberration"),
    ]
    .into_iter()
    .filter(|(on, _)| !on)
    .map(|(_, name)| name)
    .collect();
    (!off.is_empty()).then(|| format!("Physics off: {}", off.join(", ")))
}

fn show_physics_off(
    mut contexts: EguiContexts,
    scene: Res<CurrentScene>,
    compared: Res<ComparedScene>,
    overlays: Res<Overlays>,
    title: Res<TitleBox>,
) -> Result {
    let Some(mut line) = physics_off(scene.effects).filter(|_| !overlays.hidden) else {
        return Ok(());
    };
    // In a comparison of different physics, the present scene is on the right side.
    if let Some((pinned, ComparisonLayout::SideBySide { .. })) = compared.drawn()
        && pinned.effects != scene.effects
    {
        line = line.replacen("Physics off", "Right side off", 1);
    }
    let context = contexts.ctx_mut()?;
    let room = free_room(context, &overlays);
    let mut board = Board::new(context, "physics off", 1.0);
    board.add_line(board.text(&line, TEXT, WARNING, room.width().max(1.0)), 0.0);
    // In the middle, or below a title that would overlap it.
    let middle = room.center().x - 0.5 * board.width_of(&line, TEXT) - MARGIN;
    if title.0.right() < middle {
        board.paint(egui::Align2::CENTER_TOP, room.center_top());
    } else {
        let below = egui::pos2(room.left(), title.0.bottom() + 0.5 * MARGIN);
        board.paint(egui::Align2::LEFT_TOP, below);
    }
    Ok(())
}
