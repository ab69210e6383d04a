//! The adapter that the settings name is chosen in the panel, and locks nobody out.

use crate::PLAIN;
use crate::desktop::{Desktop, SMALL_SCREEN, Setup};
use lightfall::app::Settings;
use lightfall_core::gpu::{AdapterName, adapters};

/// Opens a small window with these files beside the settings.
fn open(files: &[(&str, String)]) -> Desktop {
    let setup = Setup {
        screen: SMALL_SCREEN,
        files,
        ..Setup::default()
    };
    Desktop::open_with(&setup, &["--preset", PLAIN])
}

fn settings(adapter: &AdapterName) -> String {
    format!(
        "[adapter]\nname = {:?}\nbackend = {:?}\n",
        adapter.name, adapter.backend
    )
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn an_adapter_that_is_gone_is_reported_and_another_one_is_chosen_in_the_panel() {
    let gone = AdapterName {
        name: "A card that was taken out".into(),
        backend: "vulkan".into(),
    };
    let mut desktop = open(&[("settings.toml", settings(&gone))]);
    let news = "The settings name A card that was taken out (vulkan), which was not found; the best adapter is used";
    // The message in the window goes by itself.
    desktop.wait_for("the news", |state| state.shows(news));
    assert!(desktop.stderr().contains(news), "{}", desktop.stderr());
    desktop.wait_for("the news goes", |state| !state.shows(news));
    // The choice is kept, because the card may come back. Until then it can be changed.
    assert_eq!(
        Settings::load(&desktop.settings()).0.adapter,
        Some(gone.clone())
    );
    desktop.press("p");
    desktop.click("Machine");
    let first = adapters()[0].name.clone();
    // The list of adapters appears some moments after the page.
    desktop.click(&first.to_string());
    desktop.wait("the choice is kept", || {
        Settings::load(&desktop.settings()).0.adapter == Some(first.clone())
    });
    assert!(desktop.running());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn an_adapter_that_works_is_used_and_one_that_did_not_is_given_up() {
    let name = adapters()[0].name.clone();
    let trial = |desktop: &Desktop| desktop.settings().with_file_name("adapter-on-trial");
    let desktop = open(&[("settings.toml", settings(&name))]);
    desktop.first_picture();
    assert!(
        !desktop.stderr().contains("The settings name"),
        "{}",
        desktop.stderr()
    );
    assert!(!trial(&desktop).exists(), "it still counts as untried");
    assert_eq!(
        Settings::load(&desktop.settings()).0.adapter,
        Some(name.clone())
    );
    drop(desktop);

    // As a driver leaves it that takes the program down with it.
    let desktop = open(&[
        ("settings.toml", settings(&name)),
        ("adapter-on-trial", String::new()),
    ]);
    desktop.first_picture();
    assert!(
        desktop
            .stderr()
            .contains("at its last start, so it uses the best adapter"),
        "{}",
        desktop.stderr()
    );
    assert!(!trial(&desktop).exists());
    // Settings are written some moments after they change.
    desktop.wait("the settings name none", || {
        let kept = Settings::load(&desktop.settings());
        (kept.0.adapter, kept.1) == (None, None)
    });
}
