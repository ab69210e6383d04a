//! Panels along the sides of the window, over the picture.

use crate::app::session::window::Overlays;
use crate::app::ui::{inspector, panel};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, egui};

/// Which side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Right,
}

/// Room inside, in points.
const MARGIN: f32 = 8.0;

/// Whether the mouse is the picture's, and not the user interface's.
#[derive(Resource, Default)]
pub(crate) struct OverPicture(bool);

/// For systems that ask the mouse only where it is the picture's; they run after [`look`].
pub(crate) fn over_picture(over: Res<OverPicture>) -> bool {
    over.0
}

/// Where the mouse is now: egui itself tells only where it was when the last frame was drawn. It
/// knows no panel either that has just been opened.
pub(crate) fn look(
    mut contexts: EguiContexts,
    shown: Res<Overlays>,
    window: Single<&Window, With<PrimaryWindow>>,
    mut over: ResMut<OverPicture>,
) {
    let (Some(mouse), Ok(context)) = (window.cursor_position(), contexts.ctx_mut()) else {
        over.0 = true;
        return;
    };
    let [x, y] = (mouse / context.zoom_factor()).to_array();
    let on_panel = x < shown.left() || context.content_rect().right() - x < shown.right();
    let on_area = context
        .layer_id_at(egui::pos2(x, y))
        .is_some_and(|layer| layer.order != egui::Order::Background);
    over.0 = !(on_panel || on_area || context.egui_is_using_pointer());
}

/// In a window too narrow for both panels the one that was opened last is shown, as long as it is
/// so.
pub(crate) fn make_room(mut contexts: EguiContexts, mut shown: ResMut<Overlays>) {
    let Ok(context) = contexts.ctx_mut() else {
        return;
    };
    let narrow = context.content_rect().width() < panel::WIDTH + inspector::WIDTH;
    let gives_way = if shown.last == Some(Side::Left) {
        Side::Right
    } else {
        Side::Left
    };
    let gives_way = Some(gives_way).filter(|_| shown.panel && shown.inspector && narrow);
    if shown.gives_way != gives_way {
        shown.gives_way = gives_way;
    }
}

/// Shows a panel as high as the window. It is an area of egui's own, so that the mouse over it does
/// nothing to the picture.
pub(crate) fn docked(
    context: &egui::Context,
    name: &'static str,
    side: Side,
    width: f32,
    contents: impl FnOnce(&mut egui::Ui),
) {
    let screen = context.content_rect();
    let width = width.min(screen.width());
    let left = match side {
        Side::Left => screen.left(),
        Side::Right => screen.right() - width,
    };
    let area = egui::Area::new(egui::Id::new(name))
        .fixed_pos([left, screen.top()])
        .movable(false)
        .constrain(false);
    area.order(egui::Order::Middle).show(context, |ui| {
        let frame = egui::Frame::new()
            .fill(context.global_style().visuals.window_fill)
            .inner_margin(MARGIN);
        frame.show(ui, |ui| {
            let inside = egui::vec2(width, screen.height()) - egui::Vec2::splat(2.0 * MARGIN);
            ui.set_min_size(inside);
            ui.set_max_size(inside);
            contents(ui);
        });
    });
}
