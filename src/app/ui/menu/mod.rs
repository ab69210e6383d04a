//! The menu in the middle of the window. Esc or a gamepad's button opens it; mouse, keyboard and
//! gamepad use it.

mod drawing;
mod escape;
mod navigation;

use crate::app::controls::control::AppCommand;
use crate::app::state::menu::{Menu, MenuEntry};
use crate::app::state::scene_editor::SceneEditor;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use lightfall_core::scene::presets::PRESETS;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        // The press of Esc that opens the menu must not close it in the same frame.
        (navigation::navigate, escape::apply_escape)
            .chain()
            .before(super::dock::apply_overlay_commands)
            .before(crate::app::motion::pilot::grab_mouse),
    )
    .add_systems(EguiPrimaryContextPass, drawing::show_menu);
}

/// The menu, and what its entries act on.
#[derive(SystemParam)]
struct MenuActions<'w> {
    menu: ResMut<'w, Menu>,
    editor: SceneEditor<'w>,
    commands: MessageWriter<'w, AppCommand>,
}

impl MenuActions<'_> {
    /// Does what an entry says.
    fn choose(&mut self, entry: MenuEntry) {
        let command = match entry {
            MenuEntry::Places => {
                self.menu.show_places();
                return;
            }
            MenuEntry::Back => {
                self.menu.go_back();
                return;
            }
            MenuEntry::Place(place) => {
                if let Some(preset) = PRESETS.get(place) {
                    self.editor.load("", Ok(preset.plain_scene().clone()));
                }
                None
            }
            MenuEntry::Resume => None,
            MenuEntry::Help => Some(AppCommand::Help),
            MenuEntry::Settings => Some(AppCommand::Settings),
            MenuEntry::PhotoMode => Some(AppCommand::Hide),
            MenuEntry::FullScreen => Some(AppCommand::Fullscreen),
            MenuEntry::Quit => Some(AppCommand::Quit),
        };
        self.menu.close();
        if let Some(command) = command {
            self.commands.write(command);
        }
    }
}
