//! The graphics device is lost while the program runs.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{PLAIN, STATUS_BAR, TITLE};
use lightfall_core::gpu::driver_advice;
use watched::Order;

/// Has the device lost, as the first, second, ... loss.
fn lose(desktop: &Desktop, loss: usize) {
    desktop.order(&Order::LoseDevice);
    desktop.wait("the loss", || {
        desktop.stderr().matches("opening it again").count() == loss
    });
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_lost_device_is_replaced_and_the_scene_stays() {
    let mut desktop = Desktop::open_small(&["--preset", "6"]);
    // Without the lines at the bottom: the window says there what happened.
    let changed = |a: &Shot, b: &Shot| a.changed(b, 0..a.width, TITLE..a.height - STATUS_BAR);
    // A scene that is not the one it began with, meshes and lamps in it, and a panel over it. Each key
    // must show before the next one: while a shader compiles, the picture before it is at rest.
    let mut before = desktop.first_picture();
    for key in ["t", "p"] {
        desktop.press(key);
        before = desktop.settled(key, |shot| changed(shot, &before) > 0.01);
    }
    for loss in 1..=2 {
        lose(&desktop, loss);
        desktop.settled(&format!("loss {loss}"), |shot| {
            changed(shot, &before) == 0.0
        });
        assert!(desktop.running(), "{}", desktop.stderr());
    }
    // It still responds to keys.
    desktop.press("F2");
    desktop.settled("F2", |shot| changed(shot, &before) > 0.05);
    desktop.press("F2");
    desktop.settled("F2 again", |shot| changed(shot, &before) == 0.0);
    assert!(
        !desktop.stderr().contains("panicked"),
        "{}",
        desktop.stderr()
    );
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_device_that_is_lost_again_and_again_ends_the_program_with_what_to_do() {
    let mut desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    // Five losses within a minute are recovered from, the sixth is one too many.
    for loss in 1..=5 {
        lose(&desktop, loss);
        desktop.later(2);
        assert!(desktop.running(), "loss {loss}: {}", desktop.stderr());
    }
    desktop.give(&Order::LoseDevice);
    let status = desktop.ended();
    let stderr = desktop.stderr();
    let sentence = format!(
        "lightfall: the graphics device was lost more than 5 times within a minute: {}, or choose another adapter with \
         --gpu\n",
        driver_advice::with_old_driver("linux")
    );
    assert_eq!(status.code(), Some(1), "{stderr}");
    assert!(stderr.ends_with(&sentence), "{stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
}
