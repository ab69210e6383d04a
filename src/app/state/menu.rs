//! The menu in the middle of the window: whether it is open, and which entry is chosen.

use bevy::prelude::*;
use lightfall_core::scene::presets::PRESETS;

/// One line of the menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum MenuEntry {
    Resume,
    Places,
    Journey,
    LetGo,
    Help,
    /// Open the panel on its page of settings.
    Settings,
    PhotoMode,
    FullScreen,
    Quit,
    /// Go to the built-in preset at this place in the list.
    Place(usize),
    /// Leave the list of places.
    Back,
}

/// The entries of the first list.
const MAIN: [MenuEntry; 9] = [
    MenuEntry::Resume,
    MenuEntry::Places,
    MenuEntry::Journey,
    MenuEntry::LetGo,
    MenuEntry::Help,
    MenuEntry::Settings,
    MenuEntry::PhotoMode,
    MenuEntry::FullScreen,
    MenuEntry::Quit,
];

/// The menu. While it is open, it has the keyboard and the gamepad, and time stands still.
#[derive(Resource, Clone, Debug, Default)]
pub struct Menu {
    open: bool,
    places: bool,
    selected: usize,
}

impl Menu {
    /// Whether the menu is open.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// Whether the list of places is shown.
    #[must_use]
    pub fn shows_places(&self) -> bool {
        self.places
    }

    /// The entries that are shown.
    #[must_use]
    pub fn entries(&self) -> Vec<MenuEntry> {
        if self.places {
            (0..PRESETS.len())
                .map(MenuEntry::Place)
                .chain([MenuEntry::Back])
                .collect()
        } else {
            MAIN.to_vec()
        }
    }

    /// The entry that Enter uses.
    #[must_use]
    pub fn selected(&self) -> MenuEntry {
        let entries = self.entries();
        entries[self.selected.min(entries.len() - 1)]
    }

    /// Opens the menu with its first entry selected.
    pub fn open(&mut self) {
        *self = Self {
            open: true,
            ..Self::default()
        };
    }

    /// Closes the menu.
    pub fn close(&mut self) {
        *self = Self::default();
    }

    /// Leaves the list of places, or closes the menu.
    pub fn go_back(&mut self) {
        if self.places {
            self.open();
            self.select(MenuEntry::Places);
        } else {
            self.close();
        }
    }

    /// Shows the list of places.
    pub fn show_places(&mut self) {
        (self.places, self.selected) = (true, 0);
    }

    /// Selects an entry, if it is shown.
    pub fn select(&mut self, entry: MenuEntry) {
        if let Some(place) = self.entries().iter().position(|other| *other == entry) {
            self.selected = place;
        }
    }

    /// Selects the entry some places further down. The first follows the last.
    pub fn step(&mut self, places: i32) {
        let count = self.entries().len() as i32;
        self.selected = (self.selected as i32 + places).rem_euclid(count) as usize;
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Menu>()
        .add_systems(PreUpdate, stop_clocks);
}

/// While the menu is open, the clocks of falls and journeys stand still.
fn stop_clocks(menu: Res<Menu>, mut time: ResMut<Time<Virtual>>) {
    if menu.is_open() != time.is_paused() {
        if menu.is_open() {
            time.pause();
        } else {
            time.unpause();
        }
    }
}
