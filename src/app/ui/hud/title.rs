//! Shows the name and the title of a scene for some seconds after it was chosen.

use super::board::{BRIGHT, Board, QUIET};
use super::presence::Presence;
use crate::app::state::title::Title;
use crate::app::ui::layout::Slide;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui::Align2;
use lightfall_render::Progress;

/// How long it is shown, fades included, in seconds.
const DURATION: f32 = 6.0;
/// Size of the name, in points.
const NAME: f32 = 26.0;
/// Size of the line below it, in points.
const LINE: f32 = 15.0;
/// Largest width of the line, in points.
const MAX_WIDTH: f32 = 520.0;

pub(super) fn show_title(
    mut screen: Screen,
    time: Res<Time<Real>>,
    progress: Res<Progress>,
    presence: Res<Presence>,
    mut title: ResMut<Title>,
) {
    if !title.is_shown() {
        return;
    }
    let now = time.elapsed();
    let came = *title.came.get_or_insert(now);
    // The seconds count from the scene's first picture, which may take a while to be drawn.
    if title.drawn.is_none() && progress.is_shown() {
        title.drawn = Some(now);
    }
    let since = |moment| now.saturating_sub(moment).as_secs_f32();
    let left = title
        .drawn
        .map_or(DURATION, |drawn| DURATION - since(drawn));
    if left <= 0.0 {
        return title.close();
    }
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let strength = presence.opacity(since(came), left);
    let width = layout.bounds().width().clamp(1.0, MAX_WIDTH);
    let mut board = Board::new(context, "title", strength);
    board.add_line(board.text(&title.name, NAME, BRIGHT, width), 0.0);
    if !title.line.is_empty() {
        board.add_line(board.text(&title.line, LINE, QUIET, width), 2.0);
    }
    board.paint(layout, layout.at(Align2::LEFT_TOP, Slide::Anywhere));
}
