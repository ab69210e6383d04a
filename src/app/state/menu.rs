//! The menu in the middle of the window: whether it is open, and which entry is chosen.

use super::helm::Helm;
use super::overlays::Overlays;
use bevy::prelude::*;
use lightfall_core::scene::presets::PRESETS;

/// One line of the menu.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum MenuEntry {
    Resume,
    Places,
    Missions,
    Lessons,
    Journey,
    /// Take the controls of the ship, or leave them.
    Ship,
    LetGo,
    Help,
    /// Open the panel on its page of settings.
    Settings,
    PhotoMode,
    FullScreen,
    Quit,
    /// Go to the built-in preset at this place in the list.
    Place(usize),
    /// Begin the mission at this place in the list.
    Mission(usize),
    /// Fly the lesson at this place in the list.
    Lesson(usize),
    /// Add what is shown as the next stop of the lesson under construction.
    AddStop,
    SaveLesson,
    NewLesson,
    /// Leave the list.
    Back,
}

/// The entries of the first list.
const MAIN: [MenuEntry; 12] = [
    MenuEntry::Resume,
    MenuEntry::Places,
    MenuEntry::Missions,
    MenuEntry::Lessons,
    MenuEntry::Journey,
    MenuEntry::Ship,
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
    list: MenuList,
    selected: usize,
}

/// Which entries the menu shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MenuList {
    /// The first one.
    #[default]
    Main,
    /// The built-in presets.
    Places,
    /// So many missions.
    Missions(usize),
    /// So many lessons, and what makes one.
    Lessons(usize),
}

impl Menu {
    /// Whether the menu is open.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// The list that is shown.
    #[must_use]
    pub fn list(&self) -> MenuList {
        self.list
    }

    /// The entries that are shown.
    #[must_use]
    pub fn entries(&self) -> Vec<MenuEntry> {
        let with_back = |entries: Vec<MenuEntry>| [entries, vec![MenuEntry::Back]].concat();
        match self.list {
            MenuList::Main => MAIN.to_vec(),
            MenuList::Places => with_back((0..PRESETS.len()).map(MenuEntry::Place).collect()),
            MenuList::Missions(count) => with_back((0..count).map(MenuEntry::Mission).collect()),
            MenuList::Lessons(count) => {
                let making = [
                    MenuEntry::AddStop,
                    MenuEntry::SaveLesson,
                    MenuEntry::NewLesson,
                ];
                with_back((0..count).map(MenuEntry::Lesson).chain(making).collect())
            }
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

    /// Leaves a list for the first one, or closes the menu.
    pub fn go_back(&mut self) {
        let entry = match self.list {
            MenuList::Main => return self.close(),
            MenuList::Places => MenuEntry::Places,
            MenuList::Missions(_) => MenuEntry::Missions,
            MenuList::Lessons(_) => MenuEntry::Lessons,
        };
        self.open();
        self.select(entry);
    }

    /// Shows the list of places.
    pub fn show_places(&mut self) {
        (self.list, self.selected) = (MenuList::Places, 0);
    }

    /// Shows the list of so many missions.
    pub fn show_missions(&mut self, count: usize) {
        (self.list, self.selected) = (MenuList::Missions(count), 0);
    }

    /// Shows the list of so many lessons.
    pub fn show_lessons(&mut self, count: usize) {
        (self.list, self.selected) = (MenuList::Lessons(count), 0);
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

/// While the menu is open, the clocks of falls and journeys stand still, and a ship's while its pilot reads
/// the help or the settings, too.
fn stop_clocks(
    menu: Res<Menu>,
    (helm, overlays): (Res<Helm>, Res<Overlays>),
    mut time: ResMut<Time<Virtual>>,
) {
    let stand = menu.is_open() || helm.has_ship() && overlays.pause_flights();
    if stand != time.is_paused() {
        if stand {
            time.pause();
        } else {
            time.unpause();
        }
    }
}
