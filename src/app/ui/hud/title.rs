//! Shows the name and the title of a scene for some seconds after it was chosen.

use super::board::{BRIGHT, Board, QUIET, free_room};
use super::presence::{Presence, keep_fading};
use crate::app::state::overlays::Overlays;
use crate::app::state::title::Title;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use lightfall_render::Progress;
use std::time::Duration;

/// How long it is shown, fades included.
const DURATION: Duration = Duration::from_secs(6);
/// Size of the name, in points.
const NAME: f32 = 26.0;
/// Size of the line below it, in points.
const LINE: f32 = 15.0;
/// Largest width of the line, in points.
const MAX_WIDTH: f32 = 520.0;

/// The box of the title, in points. It is empty while no title is shown.
#[derive(Resource)]
pub(super) struct TitleBox(pub(super) egui::Rect);

pub(super) fn plugin(app: &mut App) {
    app.insert_resource(TitleBox(egui::Rect::NOTHING))
        .add_systems(EguiPrimaryContextPass, show_title);
}

pub(super) fn show_title(
    mut contexts: EguiContexts,
    time: Res<Time<Real>>,
    progress: Res<Progress>,
    presence: Res<Presence>,
    overlays: Res<Overlays>,
    mut title: ResMut<Title>,
    mut title_box: ResMut<TitleBox>,
) -> Result {
    title_box.0 = egui::Rect::NOTHING;
    if !title.is_shown() {
        return Ok(());
    }
    let now = time.elapsed();
    let came = *title.came.get_or_insert(now);
    // The seconds count from the scene's first picture, which may take a while to be drawn.
    if title.drawn.is_none() && progress.is_shown() {
        title.drawn = Some(now);
    }
    let left = title
        .drawn
        .map_or(1.0, |drawn| presence.left(drawn + DURATION));
    if left <= 0.0 {
        title.close();
    }
    if left <= 0.0 || overlays.hidden {
        return Ok(());
    }
    let strength = left.min(presence.grown(now.saturating_sub(came)));
    let context = contexts.ctx_mut()?;
    keep_fading(context, strength);
    let room = free_room(context, &overlays);
    let width = room.width().clamp(1.0, MAX_WIDTH);
    let mut board = Board::new(context, "title", strength);
    board.add_line(board.text(&title.name, NAME, BRIGHT, width), 0.0);
    if !title.line.is_empty() {
        board.add_line(board.text(&title.line, LINE, QUIET, width), 2.0);
    }
    title_box.0 = board.paint(egui::Align2::LEFT_TOP, room.left_top());
    Ok(())
}
