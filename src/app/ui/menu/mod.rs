//! The menu in the middle of the window. Esc or a gamepad's button opens it. Mouse, keyboard and
//! gamepad operate it.

mod actions;
mod drawing;
mod escape;
mod navigation;

pub(crate) use drawing::menu_frame;

use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        // The press of Esc that opens the menu must not close it in the same frame.
        (
            navigation::navigate,
            escape::apply_escape,
            actions::open_missions,
        )
            .chain()
            .before(super::dock::apply_overlay_commands)
            .before(crate::app::motion::pilot::grab_mouse),
    )
    .add_systems(EguiPrimaryContextPass, drawing::show_menu);
}
