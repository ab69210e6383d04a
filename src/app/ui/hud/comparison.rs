//! The comparison of two scenes: the divider, and the labels at its upper end, which say what differs.

mod divider;
mod words;

pub use words::differences;

use super::board::{BRIGHT, Board, QUIET, TEXT};
use crate::app::controls::bindings::Bindings;
use crate::app::session::comparison::next_gain;
use crate::app::state::overlays::Overlays;
use crate::app::state::shown_picture::ShownPicture;
use crate::app::ui::layout::{Layout, Slide, Wish};
use crate::app::ui::picture_in_window::PictureInWindow;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui;
use divider::{show_border, show_divider};
use egui::{Align2, Color32, pos2};
use lightfall_render::{ComparedScene, Comparison, ComparisonLayout, ComparisonMode};

/// Minimum distance of the divider from the picture's edges, as a share of its width, so that the mouse
/// can take hold of it.
const MIN_SHARE: f32 = 0.01;
/// Room between the labels and the divider, in points.
const GAP: f32 = 10.0;
/// Largest number of settings in a label.
const MAX_SETTINGS: usize = 4;

pub(super) fn show_comparison(
    mut screen: Screen,
    picture: PictureInWindow,
    bindings: Res<Bindings>,
    (overlays, shown): (Res<Overlays>, Res<ShownPicture>),
    mut comparison: ResMut<Comparison>,
) {
    let Some((context, layout)) = screen.texts().filter(|_| comparison.0.is_some()) else {
        return;
    };
    let room = layout.bounds();
    let mut labels = Labels { context, layout };
    let key = |id| bindings.label(id);
    let sides = shown_sides(&shown);
    match &*picture.compared {
        ComparedScene::None => {}
        ComparedScene::Undrawable(reason) => labels.show_centred(&[
            ("The pinned settings are not drawn", BRIGHT),
            (reason, QUIET),
        ]),
        ComparedScene::Drawn(scenes) => match scenes.layout {
            ComparisonLayout::SideBySide { .. } | ComparisonLayout::TwoPictures { .. } => {
                let x = picture.divider(context).unwrap_or_default();
                let picture = picture.whole(context);
                let height = picture.intersect(context.content_rect()).y_range();
                let is_visible = room.x_range().contains(x);
                if is_visible && scenes.layout.is_two_pictures() {
                    show_border(context, x, height);
                } else if is_visible
                    && let Some(dragged) = show_divider(context, x, height, !overlays.inspector)
                {
                    let share = (dragged - picture.left()) / picture.width().max(1.0);
                    let divider = share.clamp(MIN_SHARE, 1.0 - MIN_SHARE);
                    drag_to(divider, &mut comparison);
                }
                if let Some([left, right]) = sides {
                    labels.show("left side", &left, x - GAP, Align2::RIGHT_TOP);
                    labels.show("right side", &right, x + GAP, Align2::LEFT_TOP);
                } else {
                    let hint = format!(
                        "Change something, for example {} (lensing): it shows on the right",
                        key("light.lensing")
                    );
                    labels.show_centred(&[("Both sides are the same", BRIGHT), (&hint, QUIET)]);
                }
            }
            ComparisonLayout::Difference { gain } => {
                let what = match sides {
                    Some(sides) => sides.map(|side| side.join(", ")).join("  |  "),
                    None => format!(
                        "Black, because nothing differs. Change something, for example {} (lensing)",
                        key("light.lensing")
                    ),
                };
                let keys = format!(
                    "{}: ×{} · {}: side by side",
                    key("picture.difference"),
                    next_gain(gain as u32),
                    key("picture.compare")
                );
                labels.show_centred(&[
                    (&format!("Difference ×{gain}"), BRIGHT),
                    (&what, BRIGHT),
                    (&keys, QUIET),
                ]);
            }
        },
    }
}

/// Puts the divider at a share of the picture's width. A divider that is held still does not count as
/// a change.
fn drag_to(divider: f32, comparison: &mut ResMut<Comparison>) {
    let dragged = ComparisonMode::SideBySide { divider };
    let moves = matches!(&comparison.0, Some((_, mode)) if *mode != dragged);
    if moves && let Some((_, mode)) = &mut comparison.0 {
        *mode = dragged;
    }
}

/// The settings in which each side of the picture on the screen differs from the other. `None` if the
/// sides are the same.
fn shown_sides(shown: &ShownPicture) -> Option<[Vec<String>; 2]> {
    let all = differences(shown.pinned.as_ref()?, &shown.scene);
    let more = all.len().saturating_sub(MAX_SETTINGS);
    let side = |place: usize| {
        let first = all.iter().take(MAX_SETTINGS);
        let more = (more > 0).then(|| format!("and {more} more"));
        first.map(|both| both[place].clone()).chain(more).collect()
    };
    (!all.is_empty()).then(|| [0, 1].map(side))
}

/// The labels' surroundings.
struct Labels<'a> {
    context: &'a egui::Context,
    layout: &'a mut Layout,
}

impl Labels<'_> {
    /// Shows the label of a side, unless the side is too narrow for it.
    fn show(&mut self, name: &'static str, settings: &[String], x: f32, anchor: Align2) {
        let mut board = Board::new(self.context, name, 1.0);
        for setting in settings {
            board.add_line(board.text(setting, TEXT, BRIGHT, f32::INFINITY), 2.0);
        }
        let wish = Wish {
            anchor,
            at: pos2(x, self.layout.bounds().top()),
            slide: Slide::Upright,
            covers_hole: false,
        };
        board.paint(self.layout, wish);
    }

    /// Shows a label in the middle of the upper edge.
    fn show_centred(&mut self, lines: &[(&str, Color32)]) {
        let mut board = Board::new(self.context, "comparison", 1.0);
        let width = (self.layout.bounds().width() - 2.0 * GAP).max(1.0);
        for (line, colour) in lines {
            board.add_line(board.text(line, TEXT, *colour, width), 2.0);
        }
        let wish = self.layout.at(Align2::CENTER_TOP, Slide::Anywhere);
        board.paint(self.layout, wish);
    }
}
