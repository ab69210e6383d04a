//! The part of the window in which texts may lie over the picture.

use crate::app::state::overlays::Overlays;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use egui::{Color32, Painter, Rect};

/// Room between texts and the window's edges or the panels, in points.
pub(crate) const MARGIN: f32 = 12.0;
/// Colour of the box behind a text. It is blended in linear light, so that over pure white it has a
/// luminance of 0.06, on which the colours of texts have a contrast of more than 4.5:1 (WCAG 2.2, 1.4.3).
pub(crate) const BOX: Color32 = Color32::from_black_alpha(240);

/// What a system draws texts on.
#[derive(SystemParam)]
pub(crate) struct Screen<'w, 's> {
    contexts: EguiContexts<'w, 's>,
    overlays: Res<'w, Overlays>,
}

impl Screen<'_, '_> {
    /// egui's context, and the part of the window for texts. None while the photo mode hides them.
    pub(crate) fn room(&mut self) -> Option<(&egui::Context, Rect)> {
        let context = self.contexts.ctx_mut().ok()?;
        (!self.overlays.hidden).then(|| (&*context, free_room(context, &self.overlays)))
    }
}

/// The part of the window between the panels, less a margin.
pub(crate) fn free_room(context: &egui::Context, overlays: &Overlays) -> Rect {
    let mut room = context.content_rect().shrink(MARGIN);
    room.min.x += overlays.left_width();
    room.max.x -= overlays.right_width();
    room
}

/// A box around texts, with this much room inside its edges, in points.
pub(crate) fn text_box(inner_margin: f32, corner_radius: f32) -> egui::Frame {
    egui::Frame::new()
        .fill(BOX)
        .inner_margin(inner_margin)
        .corner_radius(corner_radius)
}

/// Draws over the picture within `bounds`. What it draws has an area of its own, which lies below
/// every box.
pub(crate) fn draw_below_boxes(
    context: &egui::Context,
    name: &'static str,
    bounds: Rect,
    draw: impl FnOnce(&Painter),
) {
    egui::Area::new(name.into())
        .fixed_pos(bounds.min)
        .constrain(false)
        .interactable(false)
        .fade_in(false)
        .order(egui::Order::Background)
        .show(context, |ui| draw(&ui.painter().with_clip_rect(bounds)));
}
