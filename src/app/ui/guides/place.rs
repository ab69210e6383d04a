//! Where directions of the camera's sky lie in the window, and lines through them.

use super::style::Style;
use crate::app::state::hole_in_view::SeenHole;
use bevy::ecs::system::SystemParam;
use bevy::prelude::{Res, Single, With};
use bevy::window::{PrimaryWindow, Window};
use bevy_egui::egui::{self, Color32, Painter, Pos2, Rect, Stroke, Vec2, pos2, vec2};
use glam::{DMat3, DVec2, DVec3};
use lightfall_core::scene::{Camera, Scene};
use lightfall_render::{ComparedScene, ComparisonLayout, DrawnScene, PictureArea};

/// Directions whose places are more than this many picture sizes from the picture's middle are not
/// drawn.
const FARTHEST: f64 = 20.0;
/// Distance in points by which lines go on beyond the picture, so that their ends do not show.
const BEYOND: f32 = 40.0;
/// Width of the dark edge of a line on both sides, in points, and its opacity.
const HALO: f32 = 1.4;
const HALO_ALPHA: u8 = 170;

/// The picture as it lies in the window.
#[derive(SystemParam)]
pub(in crate::app::ui) struct PictureInWindow<'w, 's> {
    window: Single<'w, 's, &'static Window, With<PrimaryWindow>>,
    area: Res<'w, PictureArea>,
    pub(in crate::app::ui) scene: Res<'w, DrawnScene>,
    pub(in crate::app::ui) compared: Res<'w, ComparedScene>,
}

impl PictureInWindow<'_, '_> {
    /// Where the present scene's directions lie.
    pub(in crate::app::ui) fn placement(&self, context: &egui::Context) -> Placement {
        Placement::new(&self.scene, (&self.window, *self.area), context)
    }

    /// The part of the window in which the present scene is shown: in a comparison of two sides it is
    /// on the right one.
    pub(in crate::app::ui) fn shown_part(&self, placement: &Placement) -> Rect {
        let left = self.divider(placement);
        let picture = placement.picture;
        picture.with_min_x(left.map_or(picture.left(), |left| picture.left().max(left)))
    }

    /// The place of the line between two sides that are compared.
    pub(in crate::app::ui) fn divider(&self, placement: &Placement) -> Option<f32> {
        match self.compared.drawn() {
            Some((_, ComparisonLayout::SideBySide { columns })) => {
                Some(placement.of_column(columns))
            }
            _ => None,
        }
    }

    /// The box of the hole.
    pub(in crate::app::ui) fn hole(
        &self,
        context: &egui::Context,
        hole: &SeenHole,
    ) -> Option<Rect> {
        let placement = self.placement(context);
        let middle = placement.of_looking(hole.direction)?;
        let radius = placement.radius(hole.radius, &self.scene);
        Some(Rect::from_center_size(middle, Vec2::splat(2.0 * radius)))
    }

    /// The pixel of the scene's picture below the mouse, from the picture's upper left corner. `None`
    /// outside the picture.
    pub(in crate::app::ui) fn pixel_of_mouse(&self) -> Option<DVec2> {
        self.pixel_at(self.window.cursor_position()?)
    }

    /// The pixel of the scene's picture at a place of the window, in Bevy's logical pixels. `None`
    /// outside the picture.
    pub(in crate::app::ui) fn pixel_at(&self, place: bevy::math::Vec2) -> Option<DVec2> {
        let place = place * self.window.scale_factor();
        let picture = &self.scene.picture;
        let shown = self.area.letterbox(picture, self.window.physical_size());
        let share = ((place - shown.offset) / shown.extent).as_dvec2();
        let inside = share.min_element() >= 0.0 && share.max_element() < 1.0;
        // Rays go through the middle of pixels.
        inside.then(|| (share * picture.size().as_dvec2()).floor() + 0.5)
    }
}

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
    fn new(scene: &Scene, (window, area): (&Window, PictureArea), context: &egui::Context) -> Self {
        let shown = area.letterbox(&scene.picture, window.physical_size());
        let scale = context.pixels_per_point();
        let [offset, extent] = [shown.offset, shown.extent].map(|v| v / scale);
        Self {
            camera: scene.camera,
            size: scene.picture.size().as_dvec2(),
            camera_from_observer: scene.camera.tetrad_from_camera().transpose(),
            picture: Rect::from_min_size(pos2(offset.x, offset.y), vec2(extent.x, extent.y)),
        }
    }

    /// The place of a direction on the observer's axes. None if it is far outside the picture, or if no
    /// picture shows it.
    pub(in crate::app::ui) fn of(&self, direction: DVec3) -> Option<Pos2> {
        self.of_looking(self.camera_from_observer * direction)
    }

    /// As [`of`](Self::of), for a direction on the camera's axes (right, up, forward).
    pub(in crate::app::ui) fn of_looking(&self, looking: DVec3) -> Option<Pos2> {
        let pixel = self.camera.pixel_of(looking, self.size)?;
        let is_near = (pixel / self.size - 0.5).abs().max_element() < FARTHEST;
        is_near.then(|| self.of_pixel(pixel))
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

    /// The place of a boundary between two columns of the scene's picture, from the left.
    pub(in crate::app::ui) fn of_column(&self, column: u32) -> f32 {
        self.of_pixel(DVec2::new(column.into(), 0.0)).x
    }

    /// The parts of a closed curve that lie in or near the picture.
    pub(super) fn visible_parts(&self, curve: &[DVec3]) -> Vec<Vec<Pos2>> {
        let near = self.picture.expand(BEYOND);
        let mut parts: Vec<Vec<Pos2>> = vec![Vec::new()];
        let places: Vec<_> = curve.iter().map(|point| self.of(*point)).collect();
        for (i, here) in places.iter().enumerate() {
            let next = places[(i + 1) % places.len()];
            match (here, next) {
                (Some(here), Some(next)) if near.intersects(Rect::from_two_pos(*here, next)) => {
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
