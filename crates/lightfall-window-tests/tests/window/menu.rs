//! The menu on Esc, and the ways to quit.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{PLAIN, WINDOW, changed};

/// Share of the middle of the window that differs between two shots.
fn middle(a: &Shot, b: &Shot) -> f64 {
    a.changed(b, WINDOW.0 / 3..2 * WINDOW.0 / 3, 200..WINDOW.1 - 200)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn esc_closes_what_is_open_and_then_opens_a_menu_that_the_keyboard_uses() {
    let mut desktop = Desktop::open(&["--preset", PLAIN]);
    let start = desktop.first_picture();
    // The help first; then nothing is open, and the menu comes.
    desktop.press("F1");
    desktop.settled("help", |shot| changed(shot, &start) > 0.1);
    desktop.press("Escape");
    desktop.settled("no help", |shot| changed(shot, &start) == 0.0);
    desktop.press("Escape");
    let menu = desktop.settled("menu", |shot| middle(shot, &start) > 0.3);
    // The keys of the picture do nothing behind it.
    desktop.press("F2");
    desktop.press("d");
    let still = desktop.settled("menu still", |_| true);
    assert_eq!(middle(&still, &menu), 0.0, "a key acted behind the menu");
    desktop.press("Escape");
    desktop.settled("as before the menu", |shot| changed(shot, &start) == 0.0);

    // The key that an entry shows works behind the menu, too.
    desktop.press("Escape");
    desktop.settled("menu for its keys", |shot| middle(shot, &start) > 0.3);
    desktop.press("F1");
    desktop.wait_for("the help in place of the menu", |state| !state.menu);
    desktop.settled("help by its key", |shot| changed(shot, &start) > 0.1);
    desktop.press("Escape");
    desktop.settled("as before the help", |shot| changed(shot, &start) == 0.0);

    // Down to the places, and there to the fifth: preset 5.
    desktop.press("Escape");
    desktop.settled("menu again", |shot| middle(shot, &start) > 0.3);
    for key in ["Down", "Return", "Down", "Down", "Down", "Down", "Return"] {
        desktop.press(key);
    }
    let title = "An Einstein ring";
    desktop.wait("preset 5", || desktop.title().contains(title));
    let ring = desktop.settled("preset 5", |shot| changed(shot, &start) > 0.1);
    // Up from the first entry to the last one.
    desktop.press("Escape");
    desktop.settled("menu at preset 5", |shot| middle(shot, &ring) > 0.3);
    for key in ["Up", "Return"] {
        desktop.press_at_once(key);
    }
    assert!(desktop.ended().success());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn ctrl_q_quits_and_writes_the_settings() {
    let mut desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    // F7 changes a setting, which would be written a second later.
    desktop.press("F7");
    desktop.press_at_once("ctrl+q");
    desktop.ended();
    let settings = std::fs::read_to_string(desktop.settings()).unwrap();
    assert!(settings.contains("pixel_look = false"), "{settings}");
    assert!(!desktop.stderr().contains("ERROR"), "{}", desktop.stderr());
}
