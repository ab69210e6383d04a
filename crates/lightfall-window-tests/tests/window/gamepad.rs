//! A gamepad in the window, without hardware.

use crate::PLAIN;
use crate::desktop::Desktop;
use watched::{Order, Pad, State};

/// Time of a frame, in seconds.
const STEP: f64 = 0.05;
/// Frames for which a part of the pad is pushed: a second.
const PUSHED: u32 = 20;

/// The states before and after a part of the pad was pushed for a second.
fn used(desktop: &Desktop, part: Pad) -> [State; 2] {
    let before = desktop.state();
    let first = desktop.order(&Order::Push(part, 1.0)).frame;
    desktop.wait_for("a second", |state| state.frame >= first + PUSHED);
    desktop.order(&Order::Push(part, 0.0));
    [before, desktop.later(3)]
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_gamepad_wakes_the_window_flies_looks_around_and_presses_controls() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    desktop.order(&Order::Connect(true));
    desktop.wait_for("the toast about the gamepad", |state| {
        state.mentions("Pad of the test")
    });

    // Nothing but the pad tells the resting window to wake. Frames go on until the stick is let go:
    // a busy machine has drawn some more by then.
    let about = |factor: f64| (0.9..1.6).contains(&factor);
    desktop.wait_for("the window rests", |state| state.resting);
    let [before, after] = used(&desktop, Pad::LeftStickY);
    assert!(before.resting && !after.resting);
    // Nearer by the same share as with a key: 0.4 of the distance to the horizon a second.
    let [far, near] = [&before, &after].map(|state| state.number("camera.r") - 1.0);
    let nearer = (far / near).ln() / 0.4;
    assert!(about(nearer), "{nearer}: {far} and {near}");

    // A field of view a second, to the right.
    let [before, after] = used(&desktop, Pad::RightStickX);
    let change = |field: &str| after.number(field) - before.number(field);
    let turned = change("camera.yaw_deg") / before.number("camera.fov_deg");
    assert!(about(turned), "{turned}");
    // The place is made of the pose again, and rounded.
    assert!(change("camera.r").abs() < 1e-9, "{}", change("camera.r"));
    let [before, after] = used(&desktop, Pad::RightTrigger);
    assert!(after.number("camera.roll_deg") != before.number("camera.roll_deg"));

    // The journey by a button; the stick takes over.
    let [before, after] = used(&desktop, Pad::South);
    assert!(before.journey.is_none() && after.journey.is_some());
    let [before, after] = used(&desktop, Pad::RightStickX);
    assert!(before.journey.is_some() && after.journey.is_none());
    let [before, after] = used(&desktop, Pad::DPadRight);
    assert_eq!(
        [&before.scene["name"], &after.scene["name"]],
        ["above", "close"]
    );

    // Its disk moves.
    desktop.press("slash");
    // One button opens the menu. There the button of the journey chooses the first entry, which
    // closes the menu, and starts no journey.
    let [before, after] = used(&desktop, Pad::Start);
    assert!(!before.menu && after.menu);
    let [_, after] = used(&desktop, Pad::South);
    assert!(!after.menu && after.journey.is_none());

    desktop.order(&Order::Connect(false));
    desktop.later(3);
    let [before, after] = used(&desktop, Pad::RightStickX);
    assert_eq!(
        before.scene, after.scene,
        "a pad that is gone still turns the camera"
    );
    desktop.end_without_error();
}
