//! When the ship's pilot hears something. No test opens an audio device.

use crate::PLAIN;
use crate::desktop::{Desktop, SMALL_SCREEN, Setup};

/// A small window with this volume among its settings.
fn open(volume: f64) -> Desktop {
    let setup = Setup {
        screen: SMALL_SCREEN,
        files: &[("settings.toml", format!("volume = {volume:?}\n"))],
        ..Setup::default()
    };
    let desktop = Desktop::open_with(&setup, &["--preset", PLAIN]);
    desktop.first_picture();
    desktop
}

#[test]
#[ignore = "needs a display"]
fn sound_is_heard_at_the_ships_controls_while_its_time_passes() {
    let desktop = open(0.25);
    assert_eq!(desktop.state().volume, 0.0, "the camera has no sound");
    desktop.press("shift+f");
    desktop.wait_for("sound aboard", |state| state.volume == 0.25);
    desktop.press("slash");
    desktop.wait_for("silence while paused", |state| state.volume == 0.0);
    desktop.press("slash");
    desktop.wait_for("sound again", |state| state.volume == 0.25);
    desktop.press("Escape");
    desktop.wait_for("silence in the menu", |state| {
        state.menu && state.volume == 0.0
    });
    desktop.press("Escape");
    desktop.wait_for("sound after the menu", |state| state.volume == 0.25);
    desktop.press("shift+f");
    desktop.wait_for("silence ashore", |state| {
        state.ship.is_none() && state.volume == 0.0
    });
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a display"]
fn volume_zero_is_silence_aboard_too() {
    let desktop = open(0.0);
    desktop.press("shift+f");
    desktop.wait_for("a ship that has flown", |state| {
        state.ship.as_ref().is_some_and(|ship| ship.own_time > 0.0)
    });
    assert_eq!(desktop.state().volume, 0.0);
    desktop.end_without_error();
}
