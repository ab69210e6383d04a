//! A disk that moves: its clock runs, pauses and goes on.

use crate::changed;
use crate::desktop::Desktop;
use crate::rest::assert_few_frames;

/// Share of the picture that a moving disk changes at least within some seconds.
const MOVED: f64 = 2e-3;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_disk_moves_until_slash_pauses_it_and_goes_on_after_slash() {
    let desktop = Desktop::open(&[
        "--preset",
        "3",
        "--set",
        "disk.structure=turbulent",
        "--set",
        "disk.rate=10",
    ]);
    // A disk that moves is drawn, and never at rest.
    desktop.wait_for("first picture", |state| {
        state.progress == "Done" || state.progress.starts_with("Averaging")
    });
    let before = desktop.shot();
    desktop.until("the clock runs", |shot| changed(shot, &before) > MOVED);

    desktop.press("slash");
    let paused = desktop.settled("slash pauses the clock", |_| true);
    desktop.later(20);
    assert_eq!(changed(&paused, &desktop.shot()), 0.0, "the disk moves on");
    assert_few_frames(&desktop, "the clock paused");

    desktop.press("slash");
    desktop.until("slash goes on", |shot| changed(shot, &paused) > MOVED);
}
