//! Keyboards of other layouts, set by the X server while the program runs and before it starts.

use crate::PLAIN;
use crate::desktop::Desktop;
use std::process::Command;
use watched::State;

/// The X server's number of a key is its scan code and 8.
const W: &str = "25";
const L: &str = "46";
const Z: &str = "52";

fn set_layout(desktop: &Desktop, layout: &str) {
    let set = Command::new("setxkbmap")
        .args(["-display", desktop.display(), "-layout", layout])
        .status()
        .unwrap();
    assert!(set.success(), "{layout}");
}

/// Whether a switch of the scene differs after a key was pressed. The second press brings it back.
#[track_caller]
fn switches(desktop: &Desktop, key: &str, field: &str) {
    let value = |state: &State| state.scene[field].clone();
    let before = value(&desktop.state());
    desktop.press(key);
    desktop.wait_for(&format!("{key} switches {field}"), |state| {
        value(state) != before
    });
    desktop.press(key);
    desktop.wait_for(&format!("{key} again"), |state| value(state) == before);
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb, xdotool and setxkbmap"]
fn letters_follow_the_layout_and_flight_keeps_its_place() {
    let mut desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    // A key, by the letter that it prints or by its number; what it switches; and what the help says.
    let lensing = "effects.lensing";
    let doppler = "effects.doppler";
    for (layout, key, field, flight) in [
        ("fr", "l", lensing, "Z Q S D"),
        // Z flies, and the key that prints W is left over for its control.
        ("fr", Z, doppler, "Z Q S D"),
        ("de", "z", doppler, "W A S D"),
        ("us(dvorak)", "l", lensing, ", A O E"),
        // Its letters are not Latin, and so each control keeps its place.
        ("ru", L, lensing, "Ц Ф Ы В"),
        // Two layouts between which the user switches: shortcuts stay with the Latin letters.
        ("ru,us", "l", lensing, "W A S D"),
        ("us", "z", doppler, "W A S D"),
    ] {
        set_layout(&desktop, layout);
        switches(&desktop, key, field);
        let r = desktop.state().number("camera.r");
        desktop.hold(W);
        desktop.wait_for("the flight inward", |state| state.number("camera.r") < r);
        desktop.let_go(W);
        desktop.press("F1");
        desktop.wait_for(&format!("{layout}: the help with {flight}"), |state| {
            state.shows(flight)
        });
        desktop.press("F1");
        desktop.wait_for("the help's end", |state| !state.shows(flight));
    }
    set_layout(&desktop, "fr");
    // Ctrl with the printed A, where a US board has Q, does nothing.
    desktop.xdotool(&["key", "ctrl+a"]);
    desktop.later(5);
    desktop.xdotool(&["key", "ctrl+q"]);
    assert!(desktop.ended().success(), "{}", desktop.stderr());
}
