//! Labels in a drawing, placed so that they cover neither each other nor the drawing.

use crate::app::ui::layout::Layout;
use bevy_egui::egui::{self, Color32, Pos2, Rect, Stroke};

const SIZE: f32 = 12.5;
/// Distances from its place at which a label may stand, in points.
const DISTANCES: [f32; 4] = [9.0, 22.0, 40.0, 64.0];
/// Distance in points beyond which a thin line joins the label to its place.
const LEADER: f32 = 20.0;

/// The labels of one drawing.
pub(super) struct Labels {
    painter: egui::Painter,
    layout: Layout,
}

impl Labels {
    /// No labels yet, within these bounds.
    pub(super) fn within(painter: &egui::Painter, bounds: Rect) -> Self {
        Self {
            painter: painter.clone(),
            layout: Layout::within(bounds.shrink(3.0)),
        }
    }

    /// Keeps these points free of labels.
    pub(super) fn avoid(&mut self, points: impl IntoIterator<Item = Pos2>) {
        self.layout.avoid(points);
    }

    /// Keeps a box free of labels.
    pub(super) fn keep_free(&mut self, rect: Rect) {
        self.layout.take("drawing", rect);
    }

    /// Keeps a straight line free of labels.
    pub(super) fn avoid_line(&mut self, [from, to]: [Pos2; 2]) {
        const PARTS: usize = 40;
        self.avoid((0..=PARTS).map(|i| from.lerp(to, i as f32 / PARTS as f32)));
    }

    /// Writes a label next to a place, unless the place is outside the drawing or has no room.
    pub(super) fn write(&mut self, place: Pos2, text: &str, colour: Color32) {
        let bounds = self.layout.bounds();
        if !bounds.expand(4.0).contains(place) {
            return;
        }
        let font = egui::FontId::proportional(SIZE);
        let painter = &self.painter;
        let galley = painter.layout_no_wrap(text.to_owned(), font, colour);
        let size = galley.size() + egui::vec2(8.0, 4.0);
        let rect = self
            .layout
            .place_beside("label", place, size, &DISTANCES, bounds);
        let Some(rect) = rect else {
            return;
        };
        let near = rect.clamp(place);
        if near.distance(place) > LEADER {
            painter.line_segment([place, near], Stroke::new(1.0, colour.gamma_multiply(0.6)));
        }
        painter.rect_filled(rect, 3.0, Color32::from_black_alpha(205));
        painter.galley(rect.min + egui::vec2(4.0, 2.0), galley, colour);
    }
}
