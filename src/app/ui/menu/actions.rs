//! What the menu's entries are called, and what they do.

use crate::app::controls::control::{Action, AppCommand};
use crate::app::controls::table::control_named;
use crate::app::state::helm::CommandSender;
use crate::app::state::menu::{Menu, MenuEntry};
use crate::app::state::scene_editor::SceneEditor;
use bevy::ecs::system::SystemParam;
use bevy::prelude::*;
use lightfall_core::scene::presets::PRESETS;

/// The menu, and what its entries act on.
#[derive(SystemParam)]
pub(super) struct MenuActions<'w> {
    pub(super) menu: ResMut<'w, Menu>,
    editor: SceneEditor<'w>,
    commands: CommandSender<'w>,
}

/// An entry's name, and the control that does the same, whose key the entry shows. Empty for an
/// entry without a control.
pub(super) fn name_and_control(entry: MenuEntry) -> [String; 2] {
    let words = match entry {
        MenuEntry::Resume => ["Resume", "fly.escape"],
        MenuEntry::Places => ["Places", ""],
        MenuEntry::Journey => ["Guided journey", "journey.again"],
        MenuEntry::LetGo => ["Let go: fall or orbit", "motion.let_go"],
        MenuEntry::Help => ["Help: all keys", "window.help"],
        MenuEntry::Settings => ["Settings", ""],
        MenuEntry::PhotoMode => ["Photo mode", "window.hide"],
        MenuEntry::FullScreen => ["Full screen", "window.fullscreen"],
        MenuEntry::Quit => ["Quit", "window.quit"],
        MenuEntry::Back => ["Back", ""],
        MenuEntry::Place(place) => {
            let preset = &PRESETS[place];
            let title = preset.plain_scene().title.clone();
            return [title, format!("preset.{}", preset.number)];
        }
    };
    words.map(str::to_owned)
}

impl MenuActions<'_> {
    /// Does what an entry says.
    pub(super) fn choose(&mut self, entry: MenuEntry) {
        match entry {
            MenuEntry::Places => return self.menu.show_places(),
            MenuEntry::Back => return self.menu.go_back(),
            MenuEntry::Resume => {}
            MenuEntry::Place(place) => {
                let scene = PRESETS[place].plain_scene().clone();
                self.editor.load("", Ok(scene));
            }
            MenuEntry::Settings => {
                self.commands.send(AppCommand::Settings);
            }
            _ => {
                let [_, control] = name_and_control(entry);
                if let Some(Action::Do(command)) = control_named(&control).map(|it| it.action) {
                    self.commands.send(command);
                }
            }
        }
        self.menu.close();
    }
}
