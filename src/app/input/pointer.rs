//! Whether the mouse is over the picture or over the user interface.

use crate::app::state::overlays::Overlays;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, egui};

/// Whether the mouse is over the picture, and not over the user interface.
#[derive(Resource, Default)]
pub(crate) struct PointerOverPicture(bool);

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
    let [x, y] = (mouse / context.zoom_factor()).to_array();
    let on_panel =
        x < overlays.left_width() || context.content_rect().right() - x < overlays.right_width();
    let on_area = context
        .layer_id_at(egui::pos2(x, y))
        .is_some_and(|layer| layer.order != egui::Order::Background);
    over.0 = !(on_panel || on_area || context.egui_is_using_pointer());
}
