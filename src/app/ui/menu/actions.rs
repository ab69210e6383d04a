//! What the menu's entries do.

use crate::app::controls::control::AppCommand;
use crate::app::state::menu::{Menu, MenuEntry};
use crate::app::state::scene_editor::SceneEditor;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use lightfall_core::scene::presets::PRESETS;
use std::borrow::Cow;

/// The menu, and what its entries act on.
#[derive(SystemParam)]
pub(super) struct MenuActions<'w> {
    pub(super) menu: ResMut<'w, Menu>,
    editor: SceneEditor<'w>,
    commands: MessageWriter<'w, AppCommand>,
}

/// The control whose key an entry shows; empty for an entry without a key.
pub(super) fn control_id(entry: MenuEntry) -> Cow<'static, str> {
    match entry {
        MenuEntry::Resume => "fly.escape".into(),
        MenuEntry::Journey => "journey.again".into(),
        MenuEntry::LetGo => "motion.let_go".into(),
        MenuEntry::Help => "window.help".into(),
        MenuEntry::PhotoMode => "window.hide".into(),
        MenuEntry::FullScreen => "window.fullscreen".into(),
        MenuEntry::Quit => "window.quit".into(),
        MenuEntry::Place(place) => format!("preset.{}", PRESETS[place].number).into(),
        MenuEntry::Places | MenuEntry::Settings | MenuEntry::Back => "".into(),
    }
}

impl MenuActions<'_> {
    /// Does what an entry says.
    pub(super) fn choose(&mut self, entry: MenuEntry) {
        let command = match entry {
            MenuEntry::Places => return self.menu.show_places(),
            MenuEntry::Back => return self.menu.go_back(),
            MenuEntry::Place(place) => {
                if let Some(preset) = PRESETS.get(place) {
                    self.editor.load("", Ok(preset.plain_scene().clone()));
                }
                None
            }
            MenuEntry::Resume => None,
            MenuEntry::Journey => Some(AppCommand::RestartJourney),
            MenuEntry::LetGo => Some(AppCommand::LetGo),
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
