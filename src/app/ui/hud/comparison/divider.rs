//! The line between two compared scenes, which the mouse drags.

use crate::app::ui::screen::draw_below_boxes;
use bevy_egui::egui;
use egui::{Color32, Rangef, Shape, Stroke, pos2, vec2};

/// Width around the divider within which the mouse takes hold of it, in points.
const GRIP_WIDTH: f32 = 18.0;
/// Radius of the handle in its middle, in points.
const HANDLE_RADIUS: f32 = 13.0;

const LINE: Color32 = Color32::from_gray(240);
const EDGE: Color32 = Color32::from_black_alpha(150);
const ARROW: Color32 = Color32::from_gray(40);

/// Draws the divider, and returns the place that the mouse drags it to. The mouse takes hold of the
/// whole line, or only of its handle if the pixels below the line are for clicks.
pub(super) fn show_divider(
    context: &egui::Context,
    x: f32,
    y: Rangef,
    whole_line: bool,
) -> Option<f32> {
    let grip = if whole_line {
        y
    } else {
        Rangef::point(y.center()).expand(HANDLE_RADIUS)
    };
    let area = egui::Area::new("divider".into())
        .fixed_pos([x - 0.5 * GRIP_WIDTH, grip.min])
        .movable(false)
        .constrain(false)
        .order(egui::Order::Middle);
    let shown = area.show(context, |ui| {
        let grip = vec2(GRIP_WIDTH, grip.span());
        let (_, response) = ui.allocate_exact_size(grip, egui::Sense::drag());
        let held = response.hovered() || response.dragged();
        let response = response.on_hover_and_drag_cursor(egui::CursorIcon::ResizeHorizontal);
        let place = response.interact_pointer_pos();
        let dragged = place.filter(|_| response.dragged()).map(|place| place.x);
        (held, dragged)
    });
    let (held, dragged) = shown.inner;
    draw(context, x, y, held);
    dragged
}

/// Draws the line between two whole pictures, which stays where it is.
pub(super) fn show_border(context: &egui::Context, x: f32, y: Rangef) {
    draw_below_boxes(context, "divider line", context.content_rect(), |painter| {
        draw_line(painter, x, y, 0.0);
    });
}

fn draw_line(painter: &egui::Painter, x: f32, y: Rangef, wider: f32) {
    painter.vline(x, y, Stroke::new(4.0 + wider, EDGE));
    painter.vline(x, y, Stroke::new(2.0 + wider, LINE));
}

/// Draws the line and its handle.
fn draw(context: &egui::Context, x: f32, y: Rangef, held: bool) {
    draw_below_boxes(context, "divider line", context.content_rect(), |painter| {
        draw_line(painter, x, y, if held { 1.0 } else { 0.0 });
        let middle = pos2(x, y.center());
        let fill = if held { Color32::WHITE } else { LINE };
        painter.circle(middle, HANDLE_RADIUS, fill, Stroke::new(1.5, EDGE));
        for side in [-1.0, 1.0] {
            let at = |right: f32, down: f32| middle + vec2(side * right, down);
            let arrow = vec![at(8.5, 0.0), at(3.5, -4.5), at(3.5, 4.5)];
            painter.add(Shape::convex_polygon(arrow, ARROW, Stroke::NONE));
        }
    });
}
