//! The comparison of two scenes: the divider, and the labels at its upper end, which say what differs.

mod divider;
mod words;

pub use words::differences;

use super::board::{BRIGHT, Board, QUIET, TEXT};
use super::physics_off::physics_off;
use crate::app::controls::bindings::Bindings;
use crate::app::session::comparison::next_gain;
use crate::app::state::overlays::Overlays;
use crate::app::state::shown_picture::ShownPicture;
use crate::app::state::title::Title;
use crate::app::ui::guides::Placement;
use crate::app::ui::legend::LEGEND;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::egui;
use divider::show_divider;
use egui::{Align2, Color32, Rect, pos2};
use glam::DVec2;
use lightfall_render::{ComparedScene, Comparison, ComparisonLayout, ComparisonMode, DrawnScene};

/// Minimum distance of the divider from the picture's edges, as a share of its width, so that the mouse
/// can take hold of it.
const MIN_SHARE: f32 = 0.01;
/// Room between the labels and the divider, in points.
const GAP: f32 = 10.0;
/// Largest number of settings in a label.
const MAX_SETTINGS: usize = 4;
/// Height of the scene's title in the corner, in points.
const TITLE_HEIGHT: f32 = 76.0;
/// Height of the line that names what is switched off, in points.
const PHYSICS_OFF_HEIGHT: f32 = 36.0;

pub(super) fn show_comparison(
    mut screen: Screen,
    window: Single<&Window, With<PrimaryWindow>>,
    scene: Res<DrawnScene>,
    compared: Res<ComparedScene>,
    bindings: Res<Bindings>,
    (overlays, title, shown): (Res<Overlays>, Res<Title>, Res<ShownPicture>),
    mut comparison: ResMut<Comparison>,
) {
    let Some((context, room)) = screen.room().filter(|_| comparison.0.is_some()) else {
        return;
    };
    let above = if title.is_shown() {
        TITLE_HEIGHT
    } else if physics_off(&scene).is_some() {
        PHYSICS_OFF_HEIGHT
    } else {
        0.0
    };
    let labels = Labels {
        context,
        room: room.with_min_y(room.top() + above),
    };
    let key = |id| bindings.label(id);
    let sides = shown_sides(&shown);
    match &*compared {
        ComparedScene::None => {}
        ComparedScene::Undrawable(reason) => labels.show_centred(&[
            ("The pinned settings are not drawn", BRIGHT),
            (reason, QUIET),
        ]),
        ComparedScene::Drawn(drawn) => match drawn.1 {
            ComparisonLayout::SideBySide { columns } => {
                let placement = Placement::new(&scene, &window, context);
                let picture = placement.picture;
                let x = placement.of_pixel(DVec2::new(columns.into(), 0.0)).x;
                let height = picture.intersect(context.content_rect()).y_range();
                if room.x_range().contains(x)
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
    /// Between the panels and below the other texts at the top.
    room: Rect,
}

impl Labels<'_> {
    /// Shows the label of a side, unless the side is too narrow for it.
    fn show(&self, name: &'static str, settings: &[String], x: f32, anchor: Align2) {
        let mut board = Board::new(self.context, name, 1.0);
        for setting in settings {
            board.add_line(board.text(setting, TEXT, BRIGHT, f32::INFINITY), 2.0);
        }
        let label = board.place(anchor, pos2(x, self.room.top()));
        if label.left() >= self.room.left() && label.right() <= self.room.right() {
            // The label does not cover the legend of a view.
            let legend = self.context.memory(|memory| memory.area_rect(LEGEND));
            let covered = legend.filter(|legend| legend.intersects(label));
            let y = covered.map_or(label.top(), |legend| legend.bottom() + GAP);
            board.paint(anchor, pos2(x, y));
        }
    }

    /// Shows a label in the middle of the upper edge.
    fn show_centred(&self, lines: &[(&str, Color32)]) {
        let mut board = Board::new(self.context, "comparison", 1.0);
        let width = (self.room.width() - 2.0 * GAP).max(1.0);
        for (line, colour) in lines {
            board.add_line(board.text(line, TEXT, *colour, width), 2.0);
        }
        board.paint(Align2::CENTER_TOP, self.room.center_top());
    }
}
