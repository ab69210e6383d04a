//! Whether the mouse is over the picture or over the user interface.

use crate::app::state::overlays::Overlays;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, egui};

/// Whether the mouse is over the picture, and not over the user interface.
#[derive(Resource, Default)]
pub(crate) struct PointerOverPicture(pub(crate) bool);

/// A run condition: the mouse is over the picture. Systems that use it run after
/// [`locate_pointer`].
pub(crate) fn pointer_over_picture(over: Res<PointerOverPicture>) -> bool {
    over.0
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<PointerOverPicture>()
        .add_systems(Update, locate_pointer);
}

/// Finds where the mouse is in this frame. egui itself knows only where it was when the last frame
/// was drawn, and does not know a panel that has just been opened.
pub(crate) fn locate_pointer(
    mut contexts: EguiContexts,
    overlays: Res<Overlays>,
    window: Single<&Window, With<PrimaryWindow>>,
    mut over: ResMut<PointerOverPicture>,
) {
    let (Some(mouse), Ok(context)) = (window.cursor_position(), contexts.ctx_mut()) else {
        over.0 = true;
        return;
    };
    over.0 = is_on_picture(context, &overlays, mouse) && !context.egui_is_using_pointer();
}

/// Whether a place of the window, in Bevy's logical pixels, shows the picture and no user interface.
pub(super) fn is_on_picture(context: &egui::Context, overlays: &Overlays, place: Vec2) -> bool {
    let [x, y] = (place / context.zoom_factor()).to_array();
    let on_panel =
        x < overlays.left_width() || context.content_rect().right() - x < overlays.right_width();
    let on_area = context
        .layer_id_at(egui::pos2(x, y))
        .is_some_and(|layer| layer.order != egui::Order::Background);
    !(on_panel || on_area)
}
