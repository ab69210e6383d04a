//! A window for visitors: what they press does no harm, and the start returns when they have left.

use crate::PLAIN;
use crate::desktop::{Desktop, PROGRAM, SMALL_SCREEN, start_server};
use crate::x_keys::x_keys;
use lightfall::app::CONTROLS;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use watched::{Order, State, Stroke};
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{ClientMessageEvent, ConnectionExt, EventMask};

/// Time of a frame, in seconds, in which keys are pressed, and in which somebody waits.
const STEP: f64 = 0.05;
const LONG_STEP: f64 = 0.5;
/// Frames after which what a visitor does has its effect.
const FRAMES: u32 = 4;
/// Seconds without a visitor, and frames of waiting that are fewer and more than that.
const IDLE: &str = "20";
const FEWER: u32 = 20;
/// What the watched program itself writes, and where drivers keep compiled shaders.
const NOT_ITS_OWN: [&str; 4] = ["state.json", "state.part", "stderr", ".cache"];

/// A journey that flies away from the hole for so many seconds.
fn journey(title: &str, seconds: u32) -> String {
    format!(
        "schema = 1\ntitle = \"{title}\"\nending = \"The end of {title}.\"\n\
         [[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = {seconds}\nr = 24\n"
    )
}

/// A window for visitors with two journeys, and the folder of their files.
fn open(idle: &str) -> (Desktop, tempfile::TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let files = [("alpha", 40), ("beta", 40)].map(|(title, seconds)| {
        let file = folder.path().join(format!("{title}.toml"));
        std::fs::write(&file, journey(title, seconds)).unwrap();
        file
    });
    let [alpha, beta] = files.each_ref().map(|file| file.to_str().unwrap());
    let desktop = Desktop::open_small(&["--kiosk", alpha, beta, "--idle", idle, "--preset", PLAIN]);
    let flies = |state: &State| state.journey.is_some_and(|time| time > 0.0);
    desktop.wait_for("the first journey", flies);
    (desktop, folder)
}

/// Every file below a folder but those of the test itself, with what is in it.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        if NOT_ITS_OWN.iter().any(|name| entry.file_name() == *name) {
            continue;
        }
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            found.insert(path.clone(), std::fs::read(path).unwrap());
        }
    }
    found
}

/// Asks the window to close, as a desktop does for Alt+F4.
fn ask_to_close(desktop: &Desktop) {
    let atom = |name: &str| {
        let asked = desktop.connection.intern_atom(false, name.as_bytes());
        asked.unwrap().reply().unwrap().atom
    };
    let [protocols, delete] = ["WM_PROTOCOLS", "WM_DELETE_WINDOW"].map(atom);
    let window: u32 = desktop.window.parse().unwrap();
    let event = ClientMessageEvent::new(32, window, protocols, [delete, 0, 0, 0, 0]);
    let sent = desktop
        .connection
        .send_event(false, window, EventMask::NO_EVENT, event);
    sent.unwrap();
    desktop.connection.flush().unwrap();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn no_key_of_a_visitor_writes_a_file_or_leaves_the_window() {
    let (mut desktop, _folder) = open("3600");
    let before = files(desktop.home.path());
    desktop.order(&Order::Step(STEP));
    assert!(desktop.state().full_screen);
    for control in CONTROLS {
        for key in x_keys(control) {
            println!("{}: {key}", control.id);
            let state = desktop.press(&key);
            let is_plain = state.full_screen && !state.menu && state.comparison.is_empty();
            assert!(is_plain, "{}: {key}: {state:#?}", control.id);
            let opened = [
                "Machine",
                "Physics: switch it off",
                "Ray inspector",
                "Resume",
            ];
            let opened = opened.into_iter().find(|words| state.shows(words));
            assert_eq!(opened, None, "{}: {key}", control.id);
            assert!(desktop.running(), "{}: {key}", control.id);
        }
    }
    // A mouse, a finger and a file.
    desktop.click_at([300, 200]);
    desktop.order(&Order::Touch(0, Stroke::Down, [300.0, 200.0]));
    desktop.later(FRAMES);
    desktop.order(&Order::Touch(0, Stroke::Up, [300.0, 200.0]));
    let state = desktop.later(FRAMES);
    for button in ["Menu", "Places", "Photo"] {
        let is_shown = state.texts.iter().any(|text| text.words == button);
        assert!(!is_shown, "{button}");
    }
    let name = state.scene["name"].clone();
    let preset = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../assets/presets/9-falling.toml"
    );
    desktop.order(&Order::Drop(preset.into()));
    assert_eq!(desktop.later(FRAMES).scene["name"], name);
    ask_to_close(&desktop);
    desktop.later(FRAMES);
    assert_eq!(files(desktop.home.path()), before);
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_journeys_follow_each_other_and_the_start_returns_when_a_visitor_has_left() {
    let (mut desktop, _folder) = open(IDLE);
    let start = desktop.state().scene["camera.fov_deg"].clone();
    desktop.order(&Order::Step(LONG_STEP));
    let begins = |title: &str| {
        desktop.wait_for(title, |state| {
            state.journey.is_some_and(|time| time < 5.0) && state.shows(title)
        })
    };
    // Nobody is there: the arrow is hidden, and one journey follows the other.
    desktop.wait_for("the card", |state| state.mentions("The end of alpha"));
    assert!(!desktop.state().shows_pointer);
    begins("beta");

    // A visitor flies and changes the view, and goes.
    desktop.hold("w");
    desktop.wait_for("flight by hand", |state| state.journey.is_none());
    desktop.let_go("w");
    desktop.hold("bracketright");
    desktop.wait_for("a wider view", |state| {
        state.scene["camera.fov_deg"] != start
    });
    desktop.let_go("bracketright");
    desktop.point(320, 240);
    desktop.wait_for("the arrow", |state| state.shows_pointer);
    desktop.press("l");
    desktop.wait_for("no lensing", |state| {
        state.scene["effects.lensing"] == false
    });
    let waits = desktop.later(FEWER);
    assert_eq!(waits.journey, None, "the visitor had no time");
    let again = begins("alpha");
    assert_eq!(again.scene["camera.fov_deg"], start);
    assert_eq!(again.scene["effects.lensing"], true);

    // A lost device is nothing for visitors.
    desktop.order(&Order::LoseDevice);
    desktop.wait("the loss", || desktop.stderr().contains("opening it again"));
    let later = desktop.later(FEWER);
    assert!(!later.mentions("device was lost"));

    // The keeper's keys end it, if they are held.
    for key in ["Control_L", "Shift_L", "q"] {
        desktop.hold(key);
    }
    let status = desktop.ended();
    let stderr = desktop.stderr();
    assert!(status.success(), "{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
}

#[test]
#[ignore = "needs a graphics adapter and Xvfb"]
fn a_monitor_that_does_not_exist_is_answered_by_the_list_of_those_that_do() {
    let (mut server, display) = start_server(SMALL_SCREEN);
    let home = tempfile::tempdir().unwrap();
    let output = Command::new(PROGRAM)
        .args(["--preset", PLAIN, "--monitor", "7"])
        .env("DISPLAY", display)
        .env("HOME", home.path())
        .env("XDG_CONFIG_HOME", home.path())
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .unwrap();
    server.kill().unwrap();
    server.wait().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    let sentence = "--monitor 7: there is no such monitor; counted from the left, there is 1: ";
    assert!(stderr.contains(sentence), "{stderr}");
    assert!(stderr.contains("800 x 600"), "{stderr}");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_window_opens_over_the_whole_screen_of_the_first_monitor() {
    let desktop = Desktop::open_small(&["--fullscreen", "--monitor", "1", "--preset", PLAIN]);
    desktop.first_picture();
    assert!(desktop.state().full_screen);
    desktop.press("alt+Return");
    desktop.wait_for("a window", |state| !state.full_screen);
    desktop.end_without_error();
}
