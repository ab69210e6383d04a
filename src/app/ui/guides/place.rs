//! Where directions of the camera's sky lie in the window, and lines through them.

use super::style::Style;
use bevy_egui::egui::{Color32, Painter, Pos2, Rect, Stroke, vec2};
use glam::{DMat3, DVec2, DVec3};
use lightfall_core::scene::{Camera, Scene};

/// Directions whose places are more than this many picture sizes from the picture's middle are not
/// drawn.
const FARTHEST: f64 = 20.0;
/// Distance in points by which lines go on beyond the picture, so that their ends do not show.
const BEYOND: f32 = 40.0;
/// Width of the dark edge of a line on both sides, in points, and its opacity.
const HALO: f32 = 1.4;
const HALO_ALPHA: u8 = 170;

/// From directions to places of the window, in points.
pub(in crate::app::ui) struct Placement {
    camera: Camera,
    /// Size of the scene's picture, in pixels.
    size: DVec2,
    camera_from_observer: DMat3,
    /// The part of the window that the picture fills.
    pub(in crate::app::ui) picture: Rect,
}

impl Placement {
    /// For a scene whose picture fills this part of the window.
    pub(in crate::app::ui) fn new(scene: &Scene, picture: Rect) -> Self {
        Self {
            camera: scene.camera,
            size: scene.picture.size().as_dvec2(),
            camera_from_observer: scene.camera.tetrad_from_camera().transpose(),
            picture,
        }
    }

    /// The place of a direction on the observer's axes. None if it is far outside the picture, or if no
    /// picture shows it.
    pub(in crate::app::ui) fn of(&self, direction: DVec3) -> Option<Pos2> {
        self.of_looking(self.camera_from_observer * direction)
    }

    /// As [`of`](Self::of), for a direction on the camera's axes (right, up, forward). None outside a
    /// fisheye picture's circle, too.
    pub(in crate::app::ui) fn of_looking(&self, looking: DVec3) -> Option<Pos2> {
        let pixel = self.camera.pixel_of(looking, self.size)?;
        let is_near = (pixel / self.size - 0.5).abs().max_element() < FARTHEST;
        let is_shown = self.camera.coverage(pixel, self.size) > 0.0;
        (is_near && is_shown).then(|| self.of_pixel(pixel))
    }

    /// Whether the line between neighbouring points of a curve is short: where a picture shows the
    /// whole sky, points on both sides of its seam are as far apart as they can be.
    pub(in crate::app::ui) fn is_short(&self, here: Pos2, next: Pos2) -> bool {
        self.camera.field_deg().is_some() || (here.x - next.x).abs() < 0.5 * self.picture.width()
    }

    /// The length in points of an angle about a direction in the middle of the picture.
    pub(in crate::app::ui) fn radius(&self, angle: f64, scene: &Scene) -> f32 {
        let pixels = angle / scene.pixel_angle();
        pixels as f32 * self.picture.height() / self.size.y as f32
    }

    /// The place of a point of the scene's picture, in pixels from its upper left corner.
    pub(in crate::app::ui) fn of_pixel(&self, pixel: DVec2) -> Pos2 {
        let [across, down] = (pixel / self.size).as_vec2().to_array();
        self.picture.min + vec2(across, down) * self.picture.size()
    }

    /// The parts of a closed curve that lie in or near the picture.
    pub(super) fn visible_parts(&self, curve: &[DVec3]) -> Vec<Vec<Pos2>> {
        let near = self.picture.expand(BEYOND);
        let mut parts: Vec<Vec<Pos2>> = vec![Vec::new()];
        let places: Vec<_> = curve.iter().map(|point| self.of(*point)).collect();
        for (i, here) in places.iter().enumerate() {
            let next = places[(i + 1) % places.len()];
            match (here, next) {
                (Some(here), Some(next))
                    if near.intersects(Rect::from_two_pos(*here, next))
                        && self.is_short(*here, next) =>
                {
                    if let Some(part) = parts.last_mut() {
                        if part.is_empty() {
                            part.push(*here);
                        }
                        part.push(next);
                    }
                }
                _ => parts.push(Vec::new()),
            }
        }
        parts.retain(|part| part.len() > 1);
        parts
    }
}

/// Draws a line with a dark edge, so that it is visible on bright and on dark pictures. `strength` is
/// its opacity.
pub(super) fn draw_line(painter: &Painter, line: &[Pos2], style: Style, strength: f32) {
    let dark = Color32::from_black_alpha((f32::from(HALO_ALPHA) * strength) as u8);
    let strokes = [
        Stroke::new(style.width + 2.0 * HALO, dark),
        Stroke::new(style.width, style.colour.gamma_multiply(strength)),
    ];
    for stroke in strokes {
        painter.extend(style.dashed(line, stroke));
    }
}
