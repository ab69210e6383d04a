//! What lies over the picture, and the boxes that texts lie in.

use crate::app::state::menu::Menu;
use crate::app::state::overlays::Overlays;
use crate::app::ui::layout::{Layout, Wish};
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use egui::emath::TSTransform;
use egui::{Color32, Id, LayerId, Order, Painter, Rect, UiBuilder};

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
    menu: Res<'w, Menu>,
    layout: ResMut<'w, Layout>,
}

impl Screen<'_, '_> {
    /// egui's context and the layout, for texts that the photo mode, the help and the menu hide.
    pub(crate) fn texts(&mut self) -> Option<(&egui::Context, &mut Layout)> {
        let hidden = self.overlays.hidden || self.overlays.help || self.menu.is_open();
        self.messages().filter(|_| !hidden)
    }

    /// egui's context and the layout, for texts that nothing hides.
    pub(crate) fn messages(&mut self) -> Option<(&egui::Context, &mut Layout)> {
        let context = self.contexts.ctx_mut().ok()?;
        Some((&*context, &mut *self.layout))
    }
}

/// A box around texts, with this much room inside its edges, in points.
pub(crate) fn text_box(inner_margin: f32, corner_radius: f32) -> egui::Frame {
    egui::Frame::new()
        .fill(BOX)
        .inner_margin(inner_margin)
        .corner_radius(corner_radius)
}

/// Shows contents that scroll where they are higher than `most` points. Returns their height on the screen.
pub(crate) fn show_scrolled(
    ui: &mut egui::Ui,
    most: f32,
    contents: impl FnOnce(&mut egui::Ui),
) -> f32 {
    let most = most.max(0.0);
    // Its bar is always seen, so that nobody misses what is below.
    ui.spacing_mut().scroll = egui::style::ScrollStyle::solid();
    let shown = egui::ScrollArea::vertical()
        .max_height(most)
        // An area takes its size of the last frame for all the room that there is.
        .min_scrolled_height(most)
        .show(ui, contents);
    shown.inner_rect.height()
}

/// Shows contents where the layout has room for them, as near as possible to their wish. Contents larger
/// than the layout's bounds are drawn smaller, and so are those that may cover the hole and still find no
/// place for their size. Returns their box, or `None` where there is no room, and then shows nothing.
pub(crate) fn show_placed(
    context: &egui::Context,
    layout: &mut Layout,
    name: &'static str,
    wish: Wish,
    contents: impl FnOnce(&mut egui::Ui),
) -> Option<Rect> {
    if !layout.bounds().is_positive() {
        return None;
    }
    let layer = LayerId::new(Order::Background, Id::new(name));
    let builder = UiBuilder::new().layer_id(layer).max_rect(layout.bounds());
    let mut ui = egui::Ui::new(context.clone(), Id::new(name), builder);
    ui.set_clip_rect(Rect::EVERYTHING);
    contents(&mut ui);
    // Their size is known only now, so that what is drawn moves to its place.
    let drawn = ui.min_rect();
    let room = layout.bounds().size() / drawn.size();
    let mut scale = room.min_elem().min(1.0);
    let mut place = layout.place(name, scale * drawn.size(), wish);
    if place.is_none() && wish.covers_hole {
        let room = layout.room_for(scale * drawn.width());
        scale = (room.size() / drawn.size()).min_elem().min(scale);
        place = layout.place(name, scale * drawn.size(), wish);
    }
    match place {
        Some(place) => {
            let moved = TSTransform::new(place.min - scale * drawn.min, scale);
            context.transform_layer_shapes(layer, moved);
        }
        None => context.graphics_mut(|graphics| *graphics.entry(layer) = Default::default()),
    }
    place
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
        .order(Order::Background)
        .show(context, |ui| draw(&ui.painter().with_clip_rect(bounds)));
}
