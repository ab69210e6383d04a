//! Labels in a drawing, placed so that they cover neither each other nor the drawing.

use bevy_egui::egui::{self, Color32, Pos2, Rect, Stroke, Vec2};

const SIZE: f32 = 12.5;
/// Distances from its place at which a label may stand, in points.
const DISTANCES: [f32; 4] = [9.0, 22.0, 40.0, 64.0];
/// Distance in points beyond which a thin line joins the label to its place.
const LEADER: f32 = 20.0;
/// Directions from its place in which a label may stand.
const DIRECTIONS: [Vec2; 8] = [
    egui::vec2(1.0, -0.6),
    egui::vec2(-1.0, -0.6),
    egui::vec2(1.0, 0.6),
    egui::vec2(-1.0, 0.6),
    egui::vec2(0.0, -1.0),
    egui::vec2(0.0, 1.0),
    egui::vec2(1.0, 0.0),
    egui::vec2(-1.0, 0.0),
];

/// The labels of one drawing.
pub(super) struct Labels {
    painter: egui::Painter,
    bounds: Rect,
    taken: Vec<Rect>,
    /// Points of the drawing that labels leave free.
    drawn: Vec<Pos2>,
}

impl Labels {
    /// No labels yet, within these bounds.
    pub(super) fn within(painter: &egui::Painter, bounds: Rect) -> Self {
        Self {
            painter: painter.clone(),
            bounds: bounds.shrink(3.0),
            taken: Vec::new(),
            drawn: Vec::new(),
        }
    }

    /// Keeps these points free of labels.
    pub(super) fn avoid(&mut self, points: impl IntoIterator<Item = Pos2>) {
        let bounds = self.bounds;
        self.drawn
            .extend(points.into_iter().filter(|point| bounds.contains(*point)));
    }

    /// Keeps a box free of labels.
    pub(super) fn keep_free(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Keeps a straight line free of labels.
    pub(super) fn avoid_line(&mut self, [from, to]: [Pos2; 2]) {
        const PARTS: usize = 40;
        self.avoid((0..=PARTS).map(|i| from.lerp(to, i as f32 / PARTS as f32)));
    }

    /// Writes a label next to a place, unless the place is outside the drawing.
    pub(super) fn write(&mut self, place: Pos2, text: &str, colour: Color32) {
        if !self.bounds.expand(4.0).contains(place) {
            return;
        }
        let font = egui::FontId::proportional(SIZE);
        let painter = &self.painter;
        let galley = painter.layout_no_wrap(text.to_owned(), font, colour);
        let size = galley.size() + egui::vec2(8.0, 4.0);
        let candidates = DISTANCES.into_iter().flat_map(|distance| {
            DIRECTIONS.map(|direction| {
                // The nearest point of the box lies at the distance from the place.
                let sign = |x: f32| if x == 0.0 { 0.0 } else { x.signum() };
                let side = 0.5 * size * egui::vec2(sign(direction.x), sign(direction.y));
                let rect = Rect::from_center_size(place + distance * direction + side, size);
                (self.cost(rect) + 0.4 * distance, distance, rect)
            })
        });
        let best = candidates.min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, distance, rect)) = best else {
            return;
        };
        if distance > LEADER {
            let near = rect.clamp(place);
            painter.line_segment([place, near], Stroke::new(1.0, colour.gamma_multiply(0.6)));
        }
        painter.rect_filled(rect, 3.0, Color32::from_black_alpha(205));
        painter.galley(rect.min + egui::vec2(4.0, 2.0), galley, colour);
        self.taken.push(rect);
    }

    /// How bad a box is: its area over other labels or beyond the edge, and the number of drawn points
    /// below it.
    fn cost(&self, rect: Rect) -> f32 {
        let area = |other: Rect| other.width().max(0.0) * other.height().max(0.0);
        let room = rect.expand(2.0);
        let taken = self.taken.iter().map(|other| area(room.intersect(*other)));
        let outside = rect.area() - area(rect.intersect(self.bounds));
        let below = self.drawn.iter().filter(|point| rect.contains(**point));
        taken.sum::<f32>() + outside + 6.0 * below.count() as f32
    }
}
