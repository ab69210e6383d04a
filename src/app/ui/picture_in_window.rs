//! The picture as it lies in the window: which scene and which pixel a place of the window shows, and
//! where a scene's directions lie. A comparison shows two scenes.

use super::guides::Placement;
use crate::app::state::hole_in_view::SeenHole;
use bevy::ecs::system::SystemParam;
use bevy::prelude::{Res, Single, With};
use bevy::window::{PrimaryWindow, Window};
use bevy_egui::egui::{self, Rect, Vec2, pos2, vec2};
use glam::DVec2;
use lightfall_core::scene::Scene;
use lightfall_render::{ComparedScene, ComparisonLayout, DrawnScene, Letterbox, PictureArea};

/// The picture as it lies in the window.
#[derive(SystemParam)]
pub(in crate::app::ui) struct PictureInWindow<'w, 's> {
    window: Single<'w, 's, &'static Window, With<PrimaryWindow>>,
    area: Res<'w, PictureArea>,
    scene: Res<'w, DrawnScene>,
    pub(in crate::app::ui) compared: Res<'w, ComparedScene>,
}

/// Which of two compared scenes. Alone, a scene is the current one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::app::ui) enum SceneSide {
    Pinned,
    Current,
}

impl PictureInWindow<'_, '_> {
    /// The current scene as it is drawn.
    pub(in crate::app::ui) fn scene(&self) -> &Scene {
        self.compared.drawn_current(&self.scene).scene()
    }

    /// A scene as it is drawn; `None` if it is not.
    pub(in crate::app::ui) fn scene_of(&self, side: SceneSide) -> Option<&Scene> {
        match side {
            SceneSide::Current => Some(self.scene()),
            SceneSide::Pinned => self.compared.drawn().map(|(pinned, _)| pinned.scene()),
        }
    }

    /// Where the current scene's directions lie.
    pub(in crate::app::ui) fn placement(&self, context: &egui::Context) -> Placement {
        self.place(self.scene(), SceneSide::Current, context)
    }

    /// Where the directions of a scene lie; `None` if it is not drawn.
    pub(in crate::app::ui) fn placement_of(
        &self,
        side: SceneSide,
        context: &egui::Context,
    ) -> Option<Placement> {
        Some(self.place(self.scene_of(side)?, side, context))
    }

    /// Where the directions of a scene on this side lie. Of two whole pictures each has its own columns.
    fn place(&self, scene: &Scene, side: SceneSide, context: &egui::Context) -> Placement {
        let own = if self.has_two_pictures() {
            self.shown_part(side, context)
        } else {
            self.whole(context)
        };
        Placement::new(scene, own)
    }

    fn has_two_pictures(&self) -> bool {
        let drawn = self.compared.drawn();
        drawn.is_some_and(|(_, layout)| layout.is_two_pictures())
    }

    /// The part of the window that all of the picture fills, in points.
    pub(in crate::app::ui) fn whole(&self, context: &egui::Context) -> Rect {
        let shown = self.letterbox();
        let scale = context.pixels_per_point();
        let [offset, extent] = [shown.offset, shown.extent].map(|v| v / scale);
        Rect::from_min_size(pos2(offset.x, offset.y), vec2(extent.x, extent.y))
    }

    /// The part of the window in which a scene is shown: in a comparison of two sides the pinned one is
    /// on the left.
    pub(in crate::app::ui) fn shown_part(&self, side: SceneSide, context: &egui::Context) -> Rect {
        let whole = self.whole(context);
        match (self.divider(context), side) {
            (None, _) => whole,
            (Some(divider), SceneSide::Pinned) => whole.with_max_x(whole.right().min(divider)),
            (Some(divider), SceneSide::Current) => whole.with_min_x(whole.left().max(divider)),
        }
    }

    /// The place of the line between two sides that are compared.
    pub(in crate::app::ui) fn divider(&self, context: &egui::Context) -> Option<f32> {
        let (_, layout) = self.compared.drawn()?;
        let share = layout.divider()? as f32 / self.scene.picture.width.max(1) as f32;
        let whole = self.whole(context);
        Some(whole.left() + share * whole.width())
    }

    /// The boxes of the hole: one in each picture that shows it whole.
    pub(in crate::app::ui) fn holes(&self, context: &egui::Context, hole: &SeenHole) -> Vec<Rect> {
        let sides = if self.has_two_pictures() {
            &[SceneSide::Current, SceneSide::Pinned][..]
        } else {
            &[SceneSide::Current]
        };
        let box_in = |side: &SceneSide| {
            let (scene, placement) = (self.scene_of(*side)?, self.placement_of(*side, context)?);
            let middle = placement.of_looking(hole.direction)?;
            let radius = placement.radius(hole.radius, scene);
            Some(Rect::from_center_size(middle, Vec2::splat(2.0 * radius)))
        };
        sides.iter().filter_map(box_in).collect()
    }

    /// The scene below the mouse and the pixel of its picture, from the picture's upper left corner.
    /// `None` outside the picture.
    pub(in crate::app::ui) fn pixel_of_mouse(&self) -> Option<(SceneSide, DVec2)> {
        self.pixel_at(self.window.cursor_position()?)
    }

    /// The scene at a place of the window, in Bevy's logical pixels, and the pixel of its picture.
    /// `None` outside the picture.
    pub(in crate::app::ui) fn pixel_at(
        &self,
        place: bevy::math::Vec2,
    ) -> Option<(SceneSide, DVec2)> {
        let place = place * self.window.scale_factor();
        let shown = self.letterbox();
        let [place, extent] = [place - shown.offset, shown.extent].map(|v| v.as_dvec2());
        let inside = place.cmpge(DVec2::ZERO).all() && place.cmplt(extent).all();
        // Multiplied first, so that where both have the same pixels no rounding leads to a neighbour.
        // Rays go through the middle of pixels.
        let pixel = (place * self.scene.picture.size().as_dvec2() / extent).floor() + 0.5;
        let layout = self.compared.drawn().map(|(_, layout)| layout);
        let divider = layout.and_then(ComparisonLayout::divider).unwrap_or(0);
        let found = if pixel.x < f64::from(divider) {
            (SceneSide::Pinned, pixel)
        } else {
            let first = f64::from(self.compared.first_column());
            (SceneSide::Current, pixel - DVec2::new(first, 0.0))
        };
        inside.then_some(found)
    }

    /// Where the picture lies in the window, in its own pixels.
    fn letterbox(&self) -> Letterbox {
        let size = self.window.physical_size();
        self.area.letterbox(&self.scene.picture, size)
    }
}
