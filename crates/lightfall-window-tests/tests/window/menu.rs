//! The menu on Esc, and the ways to quit.

use crate::PLAIN;
use crate::desktop::Desktop;
use watched::State;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn esc_closes_what_is_open_and_then_opens_a_menu_that_the_keyboard_uses() {
    let mut desktop = Desktop::open_small(&["--preset", PLAIN]);
    let start = desktop.state().scene;
    let shows_help = |state: &State| !state.menu && state.shows("Physics: switch it off and on");
    let shows_menu = |state: &State| state.menu && state.shows("Guided journey");
    let shows_neither =
        |state: &State| !state.menu && !shows_help(state) && !state.shows("Guided journey");
    // The help first; then nothing is open, and the menu comes.
    desktop.press("F1");
    desktop.wait_for("help", shows_help);
    desktop.press("Escape");
    desktop.wait_for("no help", shows_neither);
    desktop.press("Escape");
    desktop.wait_for("menu", shows_menu);
    // The keys of the picture do nothing behind it.
    desktop.press("F2");
    let still = desktop.press("d");
    assert_eq!(still.scene, start, "a key acted behind the menu");
    desktop.press("Escape");
    desktop.wait_for("as before the menu", shows_neither);

    // The key that an entry shows works behind the menu, too.
    desktop.press("Escape");
    desktop.wait_for("menu for its keys", shows_menu);
    desktop.press("F1");
    desktop.wait_for("the help in place of the menu", shows_help);
    desktop.press("Escape");
    desktop.wait_for("as before the help", shows_neither);

    // Down to the places, and there to the fifth: preset 5.
    desktop.press("Escape");
    desktop.wait_for("menu again", shows_menu);
    for key in ["Down", "Return", "Down", "Down", "Down", "Down", "Return"] {
        desktop.press(key);
    }
    let title = "An Einstein ring";
    desktop.wait("preset 5", || desktop.title().contains(title));
    // Up from the first entry to the last one.
    desktop.press("Escape");
    desktop.wait_for("menu at preset 5", shows_menu);
    for key in ["Up", "Return"] {
        desktop.press_at_once(key);
    }
    assert!(desktop.ended().success());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn ctrl_q_quits_and_writes_the_settings() {
    let mut desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    // F7 changes a setting, which would be written a second later.
    desktop.press("F7");
    desktop.press_at_once("ctrl+q");
    desktop.ended();
    let settings = std::fs::read_to_string(desktop.settings()).unwrap();
    assert!(settings.contains("pixel_look = false"), "{settings}");
    assert!(!desktop.stderr().contains("ERROR"), "{}", desktop.stderr());
}
