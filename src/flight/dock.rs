//! Panels along the sides of the window, over the picture.

use bevy_egui::egui;

/// Which side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
}

/// Room inside, in points.
const MARGIN: f32 = 8.0;

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
