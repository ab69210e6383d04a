//! Panels along the sides of the window, over the picture.

use super::window::{Preferences, Shown};
use super::{inspector, panel};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::egui;
use bevy_egui::input::EguiWantsInput;

/// Which side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Room inside, in points.
const MARGIN: f32 = 8.0;

/// Whether the mouse is over the picture, and not over the user interface. A panel that was just opened, or that the mouse
/// has just come to, counts from its first frame on; egui alone would know of it only after the next one was drawn.
pub(super) fn over_picture(
    wants: Res<EguiWantsInput>,
    shown: Res<Shown>,
    preferences: Res<Preferences>,
    window: Single<&Window, With<PrimaryWindow>>,
) -> bool {
    let beside = |open: bool, width: f32, from_edge: f32| !open || from_edge > width * preferences.settings.ui_scale;
    let free = window.cursor_position().is_none_or(|mouse| {
        beside(shown.inspector && !shown.hidden, inspector::WIDTH, mouse.x)
            && beside(shown.panel && !shown.hidden, panel::WIDTH, window.width() - mouse.x)
    });
    free && !wants.wants_any_pointer_input()
}

/// Shows a panel as high as the window. It is an area of egui's own, so that the mouse over it does nothing to the picture.
pub(super) fn docked(
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
    let area = egui::Area::new(egui::Id::new(name)).fixed_pos([left, screen.top()]).movable(false).constrain(false);
    area.order(egui::Order::Middle).show(context, |ui| {
        let frame = egui::Frame::new().fill(context.global_style().visuals.window_fill).inner_margin(MARGIN);
        frame.show(ui, |ui| {
            let inside = egui::vec2(width, screen.height()) - egui::Vec2::splat(2.0 * MARGIN);
            ui.set_min_size(inside);
            ui.set_max_size(inside);
            contents(ui);
        });
    });
}
