//! Whether the keyboard belongs to the user interface.

use crate::app::state::menu::Menu;
use crate::app::state::rebinding::Rebinding;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass};

/// Whether a text field or the menu has the keyboard, or a control waits for its new key.
#[derive(Resource, Default)]
pub(crate) struct Typing(pub(crate) bool);

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Typing>()
        .add_systems(EguiPrimaryContextPass, detect_typing);
}

/// Only text fields keep the keyboard. Any other part of the panel that egui gives the focus to
/// loses it again, so that flying goes on.
fn detect_typing(
    mut contexts: EguiContexts,
    mut typing: ResMut<Typing>,
    rebinding: Res<Rebinding>,
    menu: Res<Menu>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let in_text = context.text_edit_focused();
    typing.0 = in_text || rebinding.is_waiting() || menu.is_open();
    if !in_text && let Some(focused) = context.memory(|memory| memory.focused()) {
        context.memory_mut(|memory| memory.surrender_focus(focused));
    }
    Ok(())
}
