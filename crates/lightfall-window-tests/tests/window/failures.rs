//! A window that opens in spite of what is missing.

use crate::PLAIN;
use crate::desktop::Desktop;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_wayland_server_that_does_not_answer_leaves_the_window_to_the_x_server() {
    let dead = [
        ("WAYLAND_DISPLAY", "wayland-none"),
        ("XDG_RUNTIME_DIR", "/nonexistent"),
    ];
    let mut desktop = Desktop::open_with_variables(&dead, &["--preset", PLAIN]);
    desktop.first_picture();
    assert!(desktop.running(), "{}", desktop.stderr());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_window_without_any_folder_to_write_to_opens_and_closes_as_ever() {
    // Everybody's folders are below this file, which is none.
    let file = "/proc/self/status";
    let variables = [
        ("HOME", file),
        ("XDG_CONFIG_HOME", file),
        ("XDG_DATA_HOME", file),
        ("XDG_PICTURES_DIR", file),
    ];
    let mut desktop = Desktop::open_with_variables(&variables, &["--preset", PLAIN]);
    desktop.first_picture();
    // The pixel look is a setting, which cannot be saved. A message in the window says so.
    desktop.press("F7");
    desktop.wait_for("the sentence", |state| {
        state.mentions("the settings cannot be")
    });
    desktop.press("F7");
    desktop.press_at_once("ctrl+q");
    let status = desktop.ended();
    let stderr = desktop.stderr();
    assert!(status.success(), "{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn settings_of_a_newer_version_survive_a_flight_that_changes_settings() {
    let text = "version = 999\nwarp_drive = true\n";
    let mut desktop = Desktop::open_with_settings(text, &["--preset", PLAIN]);
    desktop.first_picture();
    let said = desktop.stderr();
    assert!(
        said.contains("settings.toml: version = 999 is that of a newer Lightfall"),
        "{said}"
    );
    // The pixel look is a setting, which is saved when the window closes.
    desktop.press("F7");
    desktop.press_at_once("ctrl+q");
    let status = desktop.ended();
    assert!(status.success(), "{}", desktop.stderr());
    assert_eq!(std::fs::read_to_string(desktop.settings()).unwrap(), text);
    let folder = desktop.settings().parent().unwrap().to_owned();
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 1);
}
