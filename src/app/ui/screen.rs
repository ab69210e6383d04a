//! The part of the window in which texts may lie over the picture.

use crate::app::state::overlays::Overlays;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};

/// Room between texts and the window's edges or the panels, in points.
pub(crate) const MARGIN: f32 = 12.0;

/// What a system draws texts on.
#[derive(SystemParam)]
pub(crate) struct Screen<'w, 's> {
    contexts: EguiContexts<'w, 's>,
    overlays: Res<'w, Overlays>,
}

impl Screen<'_, '_> {
    /// egui's context, and the part of the window for texts. None while the photo mode hides them.
    pub(crate) fn room(&mut self) -> Option<(&egui::Context, egui::Rect)> {
        let context = self.contexts.ctx_mut().ok()?;
        (!self.overlays.hidden).then(|| (&*context, free_room(context, &self.overlays)))
    }
}

/// The part of the window between the panels, less a margin.
pub(crate) fn free_room(context: &egui::Context, overlays: &Overlays) -> egui::Rect {
    let mut room = context.content_rect().shrink(MARGIN);
    room.min.x += overlays.left_width();
    room.max.x -= overlays.right_width();
    room
}
