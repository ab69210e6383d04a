//! A disk that moves: its clock runs, pauses and goes on.

use crate::desktop::Desktop;
use crate::{STATUS_BAR, TITLE, WINDOW, changed};
use std::time::{Duration, Instant};

/// Share of the picture that a moving disk changes at least within some seconds.
const MOVED: f64 = 2e-3;
/// Maximum number of frames a second at rest, as in rest.rs.
const MAX_AT_REST: usize = 12;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_disk_moves_until_slash_pauses_it_and_goes_on_after_slash() {
    let mut desktop = Desktop::open(&[
        "--preset",
        "3",
        "--set",
        "disk.structure=turbulent",
        "--set",
        "disk.rate=10",
    ]);
    desktop.until("first picture", |shot| {
        shot.rows(TITLE..WINDOW.1 - STATUS_BAR).colours() > 2
    });
    let before = desktop.shot();
    desktop.until("the clock runs", |shot| changed(shot, &before) > MOVED);

    desktop.press("slash");
    let paused = desktop.settled("slash pauses the clock", |_| true);
    std::thread::sleep(Duration::from_secs(2));
    assert_eq!(changed(&paused, &desktop.shot()), 0.0, "the disk moves on");
    // Three seconds after the last input the window may rest; a busy machine is given longer.
    let (began, mut rates) = (Instant::now(), Vec::new());
    while began.elapsed() < Duration::from_secs(20) {
        rates.push(desktop.shown_within(Duration::from_secs(2)) / 2);
        if rates.last().is_some_and(|&rate| rate <= MAX_AT_REST) {
            break;
        }
    }
    assert!(
        rates.last().is_some_and(|&rate| rate <= MAX_AT_REST),
        "{rates:?} frames a second while the clock is paused"
    );

    desktop.press("slash");
    desktop.until("slash goes on", |shot| changed(shot, &paused) > MOVED);
    assert!(desktop.running());
}
