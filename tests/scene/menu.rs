//! The menu's entries and how the selection moves through them.

use lightfall::app::{Menu, MenuEntry, MenuList};
use lightfall_core::scene::presets::PRESETS;

#[test]
fn the_selection_goes_round_and_ends_at_quit() {
    let mut menu = Menu::default();
    assert!(!menu.is_open());
    menu.open();
    assert_eq!(menu.selected(), MenuEntry::Resume);
    menu.step(-1);
    assert_eq!(menu.selected(), MenuEntry::Quit);
    menu.step(1);
    assert_eq!(menu.selected(), MenuEntry::Resume);
    let count = menu.entries().len() as i32;
    menu.step(count + 1);
    assert_eq!(menu.selected(), MenuEntry::Places);
    // The ship is found without its key.
    menu.select(MenuEntry::Ship);
    assert_eq!(menu.selected(), MenuEntry::Ship);
}

#[test]
fn the_list_of_places_has_every_preset_and_leads_back_to_its_own_entry() {
    let mut menu = Menu::default();
    menu.open();
    menu.show_places();
    assert_eq!(menu.list(), MenuList::Places);
    assert_eq!(menu.entries().len(), PRESETS.len() + 1);
    assert_eq!(menu.selected(), MenuEntry::Place(0));
    menu.step(-1);
    assert_eq!(menu.selected(), MenuEntry::Back);
    menu.go_back();
    assert!(menu.is_open());
    assert_eq!(menu.list(), MenuList::Main);
    assert_eq!(menu.selected(), MenuEntry::Places);
    menu.go_back();
    assert!(!menu.is_open());
}

#[test]
fn the_list_of_missions_leads_back_to_its_own_entry() {
    let mut menu = Menu::default();
    menu.open();
    menu.show_missions(3);
    assert_eq!(menu.list(), MenuList::Missions(3));
    let missions = [0, 1, 2].map(MenuEntry::Mission);
    assert_eq!(menu.entries(), [&missions[..], &[MenuEntry::Back]].concat());
    assert_eq!(menu.selected(), MenuEntry::Mission(0));
    menu.go_back();
    assert_eq!(menu.selected(), MenuEntry::Missions);
}
