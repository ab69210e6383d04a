//! Whether the keyboard belongs to the user interface.

use crate::app::state::menu::Menu;
use crate::app::state::overlays::PANEL;
use crate::app::state::rebinding::Rebinding;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Whether a text field or the menu has the keyboard, or a control waits for its new key.
#[derive(Resource, Default)]
pub(crate) struct Typing(pub(crate) bool);

/// Whether the mouse is over the panel at the right. A click that misses a number field leaves the
/// number to the keyboard, so that the keys of numbers do nothing there.
#[derive(Resource, Default)]
pub(crate) struct MouseOverPanel(bool);

impl MouseOverPanel {
    /// Whether a key is kept from its control.
    pub(crate) fn keeps(&self, key: KeyCode) -> bool {
        self.0 && types_numbers(key)
    }
}

/// Whether a key belongs to typing a number.
fn types_numbers(key: KeyCode) -> bool {
    use KeyCode::{
        Comma, Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
        Enter, Minus, NumpadEnter, NumpadSubtract, Period,
    };
    matches!(
        key,
        Digit0
            | Digit1
            | Digit2
            | Digit3
            | Digit4
            | Digit5
            | Digit6
            | Digit7
            | Digit8
            | Digit9
            | Enter
            | NumpadEnter
            | Minus
            | NumpadSubtract
            | Period
            | Comma
    )
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Typing>()
        .init_resource::<MouseOverPanel>()
        .add_systems(EguiPrimaryContextPass, detect_typing);
}

/// Only text fields keep the keyboard. Any other part of the panel that egui gives the focus to
/// loses it again, so that flying goes on.
fn detect_typing(
    mut contexts: EguiContexts,
    mut typing: ResMut<Typing>,
    mut over_panel: ResMut<MouseOverPanel>,
    rebinding: Res<Rebinding>,
    menu: Res<Menu>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let mouse = context.input(|input| input.pointer.hover_pos());
    let layer = mouse.and_then(|mouse| context.layer_id_at(mouse));
    over_panel.0 = layer.is_some_and(|layer| layer.id == egui::Id::new(PANEL));
    let in_text = context.text_edit_focused();
    typing.0 = in_text || rebinding.0.is_some() || menu.is_open();
    if !in_text && let Some(focused) = context.memory(|memory| memory.focused()) {
        context.memory_mut(|memory| memory.surrender_focus(focused));
    }
    Ok(())
}
