//! The projection of the inspector's drawing: from places around the hole to places on the screen.

use bevy_egui::egui::{self, Pos2, Stroke};
use glam::{DMat3, DVec3};

/// From places around the hole to places on the screen.
pub(super) struct Projection {
    pub(super) painter: egui::Painter,
    /// Rows: right, up, toward the viewer.
    pub(super) axes: DMat3,
    pub(super) centre: Pos2,
    pub(super) points_per_length: f64,
    pub(super) horizon: f64,
    /// Whether the camera is inside the horizon. The hole is then only an outline.
    pub(super) inside: bool,
}

impl Projection {
    pub(super) fn point(&self, place: DVec3) -> Pos2 {
        let seen = self.axes * place;
        let far = |length: f64| (length * self.points_per_length).clamp(-1e5, 1e5) as f32;
        Pos2::new(self.centre.x + far(seen.x), self.centre.y - far(seen.y))
    }

    /// Whether the hole covers a place.
    pub(super) fn hidden(&self, place: DVec3) -> bool {
        if self.inside {
            return false;
        }
        let seen = self.axes * place;
        seen.z < 0.0 && seen.x.hypot(seen.y) < self.horizon
    }

    /// Draws a line through places, without the parts that the hole covers.
    pub(super) fn line(&self, places: impl Iterator<Item = DVec3>, stroke: Stroke) {
        let mut run = Vec::new();
        for place in places {
            if self.hidden(place) {
                self.painter.line(std::mem::take(&mut run), stroke);
            } else {
                run.push(self.point(place));
            }
        }
        if run.len() > 1 {
            self.painter.line(run, stroke);
        }
    }
}
