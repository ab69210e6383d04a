//! The adapter that the settings name is chosen in the panel, and locks nobody out.

use crate::desktop::Desktop;
use crate::{STATUS_BAR, WINDOW, place};
use lightfall::app::Settings;
use lightfall_core::gpu::{AdapterName, adapters};
use std::time::{Duration, Instant};

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
    let mut desktop = Desktop::open_with_settings(&settings(&gone), &["--preset", "2"]);
    let news = "The settings name A card that was taken out (vulkan), which was not found; the best adapter is used";
    // On a busy machine the toast may be gone before the picture comes to rest.
    desktop.until("first picture", |shot| shot.colours() > 50);
    let with_news = desktop.shot();
    assert!(desktop.stderr().contains(news), "{}", desktop.stderr());
    // The toast goes by itself, and with it a line of the status bar.
    desktop.settled("the toast goes", |shot| {
        shot.changed(&with_news, 0..WINDOW.0, WINDOW.1 - 2 * STATUS_BAR..WINDOW.1) > 0.001
    });
    // The choice is kept, because the card may come back. Until then it can be changed.
    assert_eq!(
        Settings::load(&desktop.settings()).0.adapter,
        Some(gone.clone())
    );
    desktop.press("p");
    desktop.settled("panel", |_| true);
    desktop.click(place::MACHINE_TAB);
    let first = adapters()[0].name.clone();
    let start = Instant::now();
    while Settings::load(&desktop.settings()).0.adapter != Some(first.clone()) {
        assert!(
            start.elapsed() < Duration::from_secs(30),
            "the choice is not kept"
        );
        // The list of adapters appears some moments after the page, and the settings are written a
        // second after the choice.
        desktop.click(place::FIRST_ADAPTER);
        std::thread::sleep(Duration::from_millis(1500));
    }
    assert!(desktop.running());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn an_adapter_that_works_is_used_and_one_that_did_not_is_given_up() {
    let name = adapters()[0].name.clone();
    let trial = |desktop: &Desktop| desktop.settings().with_file_name("adapter-on-trial");
    let desktop = Desktop::open_with_settings(&settings(&name), &["--preset", "2"]);
    desktop.settled("first picture", |shot| shot.colours() > 50);
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
    let prepared = [
        ("settings.toml", settings(&name)),
        ("adapter-on-trial", String::new()),
    ];
    let desktop = Desktop::open_prepared(&prepared, &["--preset", "2"]);
    desktop.settled("first picture", |shot| shot.colours() > 50);
    assert!(
        desktop
            .stderr()
            .contains("at its last start, so it uses the best adapter"),
        "{}",
        desktop.stderr()
    );
    assert!(!trial(&desktop).exists());
    let kept = Settings::load(&desktop.settings());
    assert_eq!((kept.0.adapter, kept.1), (None, None));
}
