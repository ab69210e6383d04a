//! Shows the name and the title of a scene for some seconds after it was chosen.

use super::board::{BRIGHT, Board, QUIET};
use super::presence::Presence;
use crate::app::state::title::Title;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui;
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

/// The box of the title, in points. None while no title is shown.
#[derive(Resource, Default)]
pub(super) struct TitleBox(pub(super) Option<egui::Rect>);

pub(super) fn show_title(
    mut screen: Screen,
    time: Res<Time<Real>>,
    progress: Res<Progress>,
    presence: Res<Presence>,
    mut title: ResMut<Title>,
    mut title_box: ResMut<TitleBox>,
) {
    title_box.0 = None;
    if !title.is_shown() {
        return;
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
        return title.close();
    }
    let Some((context, room)) = screen.room() else {
        return;
    };
    let strength = left.min(presence.grown(now.saturating_sub(came)));
    let width = room.width().clamp(1.0, MAX_WIDTH);
    let mut board = Board::new(context, "title", strength);
    board.add_line(board.text(&title.name, NAME, BRIGHT, width), 0.0);
    if !title.line.is_empty() {
        board.add_line(board.text(&title.line, LINE, QUIET, width), 2.0);
    }
    title_box.0 = Some(board.paint(egui::Align2::LEFT_TOP, room.left_top()));
}
