//! The comparison of two scenes: the words at the upper end of the divider, which say what differs.

mod divider;
mod words;

pub use words::differences;

use super::board::{BRIGHT, Board, QUIET, TEXT, free_room};
use super::physics_off::physics_off;
use crate::app::controls::bindings::Bindings;
use crate::app::session::comparison::next_gain;
use crate::app::state::overlays::Overlays;
use crate::app::state::shown_picture::ShownPicture;
use crate::app::state::title::Title;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use divider::show_divider;
use egui::{Align2, Color32, Pos2, Rect, pos2, vec2};
use lightfall_core::scene::Scene;
use lightfall_render::{
    ComparedScene, Comparison, ComparisonLayout, ComparisonMode, DrawnScene, letterbox,
};

/// The divider stays this far from the picture's edges, as a share of its width, so that the mouse
/// finds it.
const MIN_SHARE: f32 = 0.01;
/// Room between the labels and the divider, in points.
const GAP: f32 = 10.0;
/// The most settings that a label lists.
const MAX_SETTINGS: usize = 4;
/// Height of the scene's title in the corner, in points.
const TITLE_HEIGHT: f32 = 76.0;
/// Height of the line that names what is switched off, in points.
const PHYSICS_OFF_HEIGHT: f32 = 36.0;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_comparison);
}

fn show_comparison(
    mut contexts: EguiContexts,
    window: Single<&Window, With<PrimaryWindow>>,
    scene: Res<DrawnScene>,
    compared: Res<ComparedScene>,
    bindings: Res<Bindings>,
    (overlays, title, shown): (Res<Overlays>, Res<Title>, Res<ShownPicture>),
    mut comparison: ResMut<Comparison>,
) -> Result {
    let output = window.physical_size();
    if overlays.hidden || comparison.0.is_none() || output.min_element() == 0 {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let place = letterbox(&scene.picture, output);
    let [corner, size] = [place.offset, place.extent].map(|v| v / context.pixels_per_point());
    let picture = Rect::from_min_size(pos2(corner.x, corner.y), vec2(size.x, size.y));
    let room = free_room(context, &overlays);
    let above = if title.is_shown() {
        TITLE_HEIGHT
    } else if physics_off(scene.effects).is_some() {
        PHYSICS_OFF_HEIGHT
    } else {
        0.0
    };
    let labels = Labels {
        context,
        room: room.with_min_y(room.top() + above),
    };
    let key = |id| bindings.label(id);
    match &*compared {
        ComparedScene::None => {}
        ComparedScene::Undrawable(reason) => labels.show_centred(&[
            ("The pinned settings are not drawn", BRIGHT),
            (reason, QUIET),
        ]),
        ComparedScene::Drawn(drawn) => match drawn.1 {
            ComparisonLayout::SideBySide { columns } => {
                let share = columns as f32 / scene.picture.width.max(1) as f32;
                let x = picture.left() + share * picture.width();
                let height = picture.intersect(context.content_rect()).y_range();
                if room.x_range().contains(x)
                    && let Some(dragged) = show_divider(context, x, height, !overlays.inspector)
                {
                    let share = (dragged - picture.left()) / picture.width().max(1.0);
                    let divider = share.clamp(MIN_SHARE, 1.0 - MIN_SHARE);
                    drag_to(divider, &mut comparison);
                }
                match shown_sides(&shown) {
                    Some([left, right]) => {
                        labels.show("left side", &left, x - GAP, Align2::RIGHT_TOP);
                        labels.show("right side", &right, x + GAP, Align2::LEFT_TOP);
                    }
                    None => labels.show_centred(&[
                        ("Both sides are the same", BRIGHT),
                        (
                            &format!(
                                "Change something, for example {} (lensing): it shows on the right",
                                key("light.lensing")
                            ),
                            QUIET,
                        ),
                    ]),
                }
            }
            ComparisonLayout::Difference { gain } => {
                let what = match shown_sides(&shown) {
                    Some([left, right]) => {
                        format!("{}  |  {}", left.join(", "), right.join(", "))
                    }
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
    Ok(())
}

/// Puts the divider at a share of the picture's width. A divider that is held still is no change.
fn drag_to(divider: f32, comparison: &mut ResMut<Comparison>) {
    let dragged = ComparisonMode::SideBySide { divider };
    let moves = matches!(&comparison.0, Some((_, mode)) if *mode != dragged);
    if moves && let Some((_, mode)) = &mut comparison.0 {
        *mode = dragged;
    }
}

/// What distinguishes the sides of the picture on the screen; `None` if nothing does.
fn shown_sides(shown: &ShownPicture) -> Option<[Vec<String>; 2]> {
    sides(shown.pinned.as_ref()?, &shown.scene)
}

/// What distinguishes each side from the other; `None` if nothing does.
fn sides(pinned: &Scene, current: &Scene) -> Option<[Vec<String>; 2]> {
    let all = differences(pinned, current);
    if all.is_empty() {
        return None;
    }
    let more = all.len().saturating_sub(MAX_SETTINGS);
    let side = |place: usize| {
        let first = all.iter().take(MAX_SETTINGS);
        let mut settings: Vec<String> = first.map(|both| both[place].clone()).collect();
        if more > 0 {
            settings.push(format!("and {more} more"));
        }
        settings
    };
    Some([side(0), side(1)])
}

/// Where the labels go.
struct Labels<'a> {
    context: &'a egui::Context,
    /// Between the panels and below the other texts at the top.
    room: Rect,
}

impl Labels<'_> {
    /// The label of a side. It is left out where the side is too narrow for it.
    fn show(&self, name: &'static str, settings: &[String], x: f32, anchor: Align2) {
        let mut board = Board::new(self.context, name, 1.0);
        let width = settings
            .iter()
            .map(|setting| board.width_of(setting, TEXT))
            .fold(0.0, f32::max);
        // A board has some room inside its edges.
        let width = width + 2.0 * GAP;
        let left = if anchor == Align2::RIGHT_TOP {
            x - width
        } else {
            x
        };
        if left < self.room.left() || left + width > self.room.right() {
            return;
        }
        for setting in settings {
            board.add_line(board.text(setting, TEXT, BRIGHT, f32::INFINITY), 2.0);
        }
        let beside = Rect::from_min_size(pos2(left, self.room.top()), vec2(width, 1.0));
        board.paint(anchor, pos2(x, self.below_legend(beside)));
    }

    /// A label in the middle of the upper edge.
    fn show_centred(&self, lines: &[(&str, Color32)]) {
        let mut board = Board::new(self.context, "comparison", 1.0);
        let width = (self.room.width() - 2.0 * GAP).max(1.0);
        for (line, colour) in lines {
            board.add_line(board.text(line, TEXT, *colour, width), 2.0);
        }
        let place: Pos2 = self.room.center_top();
        board.paint(Align2::CENTER_TOP, place);
    }

    /// The height at which a label of this width is clear of the legend of a view.
    fn below_legend(&self, label: Rect) -> f32 {
        let legend = self.context.memory(|memory| memory.area_rect("legend"));
        let covers = |legend: &Rect| legend.x_range().intersects(label.x_range());
        match legend.filter(covers) {
            Some(legend) if legend.bottom() > label.top() => legend.bottom() + GAP,
            _ => label.top(),
        }
    }
}
