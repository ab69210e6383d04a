//! Whether the keyboard belongs to the user interface.

use super::clicks::hold_keys_after_click;
use crate::app::input::keyboard::apply_pressed_controls;
use crate::app::state::menu::Menu;
use crate::app::state::overlays::PANEL;
use crate::app::state::rebinding::Rebinding;
use bevy::prelude::*;
use bevy_egui::{EguiContext, PrimaryEguiContext, egui};

/// Whether a text field or the menu has the keyboard, or a control waits for its new key.
#[derive(Resource, Default)]
pub(crate) struct Typing {
    /// Whether the user interface has the keyboard as the frame begins.
    pub(super) has_keyboard: bool,
    /// The number of this frame's messages of keys that come before a click on the user interface.
    /// The later keys wait for the next frame. `None` without a click.
    pub(super) keys_before_click: Option<usize>,
}

impl Typing {
    /// Whether the keys of this frame belong to the user interface, or may do so after a click.
    pub(crate) fn is_on(&self) -> bool {
        self.has_keyboard || self.keys_before_click.is_some()
    }
}

/// Whether the mouse is over the panel at the right while its page has fields for numbers. A click that
/// misses such a field leaves the number to the keyboard, so that the keys of numbers do nothing there.
#[derive(Resource, Default)]
pub(crate) struct MouseOverPanel {
    is_over: bool,
    /// Whether the panel's page has many fields for numbers.
    pub(crate) page_has_numbers: bool,
}

impl MouseOverPanel {
    /// Whether a key is kept from its control.
    pub(crate) fn keeps(&self, key: KeyCode) -> bool {
        self.is_over && self.page_has_numbers && types_numbers(key)
    }
}

/// Whether a key belongs to typing a number.
pub(super) fn types_numbers(key: KeyCode) -> bool {
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
        .add_systems(
            PreUpdate,
            detect_typing
                .before(hold_keys_after_click)
                .before(apply_pressed_controls),
        );
}

/// Finds out whether a text field or the menu had the keyboard when the last frame was drawn. Only text fields keep it. Any other part
/// of the panel that egui gives the focus to loses it again, so that flying goes on.
fn detect_typing(
    mut contexts: Query<&mut EguiContext, With<PrimaryEguiContext>>,
    mut typing: ResMut<Typing>,
    mut over_panel: ResMut<MouseOverPanel>,
    rebinding: Res<Rebinding>,
    menu: Res<Menu>,
) {
    let Ok(mut context) = contexts.single_mut() else {
        return;
    };
    let context = context.get_mut();
    let mouse = context.input(|input| input.pointer.hover_pos());
    let layer = mouse.and_then(|mouse| context.layer_id_at(mouse));
    over_panel.is_over = layer.is_some_and(|layer| layer.id == egui::Id::new(PANEL));
    let in_text = context.text_edit_focused();
    typing.has_keyboard = in_text || rebinding.0.is_some() || menu.is_open();
    if !in_text && let Some(focused) = context.memory(|memory| memory.focused()) {
        context.memory_mut(|memory| memory.surrender_focus(focused));
    }
}
