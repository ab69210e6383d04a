//! The line at the top that stays while some of the physics is switched off.

use super::board::{Board, TEXT, WARNING, free_room};
use crate::app::state::overlays::Overlays;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use lightfall_core::scene::Effects;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_physics_off);
}

/// Names what is switched off, e.g. `Physics off: Doppler shift, beaming`. None while all is on.
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
    overlays: Res<Overlays>,
) -> Result {
    let Some(line) = physics_off(scene.effects).filter(|_| !overlays.hidden) else {
        return Ok(());
    };
    let context = contexts.ctx_mut()?;
    let room = free_room(context, &overlays);
    let mut board = Board::new(context, "physics off", 1.0);
    board.add_line(board.text(&line, TEXT, WARNING, room.width().max(1.0)), 0.0);
    board.paint(egui::Align2::CENTER_TOP, room.center_top());
    Ok(())
}
