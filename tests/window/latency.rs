//! How many frames the picture takes to follow a key.

use crate::desktop::Desktop;
use crate::{STATUS_BAR, TITLE, WINDOW, program};
use bevy::diagnostic::FrameCount;
use bevy::prelude::*;
use bevy::render::view::window::screenshot::{Screenshot, ScreenshotCaptured};

/// What the window showed before.
#[derive(Resource, Default)]
struct Before(Option<Vec<u8>>);

/// The frame in which the key came.
#[derive(Resource, Default)]
struct Pressed(u32);

/// Keypad 7 keeps the window's picture; from the key for more light on, each frame is held against it.
fn watch(
    mut commands: Commands,
    keys: Res<ButtonInput<KeyCode>>,
    frame: Res<FrameCount>,
    before: Res<Before>,
    mut pressed: ResMut<Pressed>,
) {
    if keys.just_pressed(KeyCode::Numpad7) {
        commands.spawn(Screenshot::primary_window()).observe(
            |shot: On<ScreenshotCaptured>, mut before: ResMut<Before>| {
                before.0.clone_from(&shot.image.data);
                eprintln!("kept");
            },
        );
    }
    if keys.just_pressed(KeyCode::Equal) {
        pressed.0 = frame.0;
    }
    let later = frame.0 - pressed.0;
    if pressed.0 > 0 && later < 4 && before.0.is_some() {
        commands.spawn(Screenshot::primary_window()).observe(
            move |shot: On<ScreenshotCaptured>, before: Res<Before>| {
                let same = picture(shot.image.data.as_deref()) == picture(before.0.as_deref());
                eprintln!(
                    "frame {later}: {}",
                    if same { "as before" } else { "changed" }
                );
            },
        );
    }
}

/// The middle rows of the window, without the title at the top and the text at the bottom.
fn picture(window: Option<&[u8]>) -> Option<&[u8]> {
    let row = |bytes: &[u8]| bytes.len() / WINDOW.1;
    window.map(|bytes| &bytes[row(bytes) * TITLE..row(bytes) * (WINDOW.1 - 2 * STATUS_BAR)])
}

/// The program with [`watch`]. This is no test: the test below starts it as another process.
#[test]
#[ignore = "started by the test of latency"]
fn started_program_that_watches_its_frames() {
    let mut app = program();
    app.init_resource::<Before>()
        .init_resource::<Pressed>()
        .add_systems(Update, watch);
    assert_eq!(app.run(), AppExit::Success);
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_picture_follows_a_key_in_the_same_frame_or_the_next() {
    let program = std::env::current_exe().unwrap();
    let only = [
        "--exact",
        "latency::started_program_that_watches_its_frames",
        "--ignored",
        "--test-threads=1",
        "--nocapture",
    ];
    let desktop = Desktop::open_program(&program, &only);
    desktop.first_picture();
    desktop.press("KP_Home");
    let before = desktop.settled("kept", |_| desktop.stderr().contains("kept"));
    desktop.press("equal");
    desktop.settled("more light", |shot| {
        *shot != before && desktop.stderr().contains("frame 3")
    });
    let stderr = desktop.stderr();
    println!("{stderr}");
    // The screen shows a frame while the program works on the next one: in frame 0 or 1 is on the
    // screen within two frames.
    let first = (0..4).find(|frame| stderr.contains(&format!("frame {frame}: changed")));
    assert!(
        first.is_some_and(|frame| frame <= 1),
        "the key was first seen in frame {first:?} after it: {stderr}"
    );
}
