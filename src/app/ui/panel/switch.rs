//! A switch that says its state.

use crate::app::ui::theme::{ACCENT, TEXT, WEAK_TEXT};
use bevy_egui::egui;

/// Size of the switch without its word, in points.
const SIZE: egui::Vec2 = egui::vec2(34.0, 18.0);

/// Shows a switch with the word "on" or "off". Returns whether it was switched.
pub(super) fn switch(ui: &mut egui::Ui, on: &mut bool) -> bool {
    let whole = egui::vec2(SIZE.x + 34.0, 22.0);
    let (area, response) = ui.allocate_exact_size(whole, egui::Sense::click());
    if response.clicked() {
        *on = !*on;
    }
    let rail = egui::Rect::from_center_size(
        egui::pos2(area.left() + 0.5 * SIZE.x, area.center().y),
        SIZE,
    );
    let visuals = ui.style().interact(&response);
    let radius = 0.5 * SIZE.y;
    let (fill, word, colour, knob) = if *on {
        let fill = ACCENT.gamma_multiply(0.75);
        (fill, "on", TEXT, rail.right() - radius)
    } else {
        (visuals.bg_fill, "off", WEAK_TEXT, rail.left() + radius)
    };
    let painter = ui.painter();
    painter.rect(
        rail,
        radius,
        fill,
        visuals.bg_stroke,
        egui::StrokeKind::Inside,
    );
    painter.circle_filled(
        egui::pos2(knob, rail.center().y),
        radius - 4.0,
        egui::Color32::WHITE,
    );
    painter.text(
        egui::pos2(rail.right() + 8.0, area.center().y),
        egui::Align2::LEFT_CENTER,
        word,
        egui::TextStyle::Body.resolve(ui.style()),
        colour,
    );
    response.clicked()
}
