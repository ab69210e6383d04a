//! A window in which nothing happens draws few frames.

use crate::desktop::Desktop;
use std::time::Duration;

/// Maximum number of frames a second at rest: frames are a fifth of a second apart, and each may be
/// followed by one more. A window that does not rest shows more frames than this on any machine
/// that reaches the required ten frames a second with the panel open.
const MAX_AT_REST: u32 = 12;
/// The time in which frames are counted.
const COUNTED: Duration = Duration::from_secs(2);

/// How often frames are counted until they are few: a message that fades meanwhile is drawn, but it
/// fades once.
const COUNTS: usize = 3;

/// Waits until the program rests, and counts its frames a second.
#[track_caller]
pub fn assert_few_frames(desktop: &Desktop, what: &str) {
    let count = || {
        let before = desktop.wait_for("the program rests", |state| state.resting);
        std::thread::sleep(COUNTED);
        (desktop.state().frame - before.frame) / COUNTED.as_secs() as u32
    };
    let mut rate = count();
    for _ in 1..COUNTS {
        if rate > MAX_AT_REST {
            rate = count();
        }
    }
    println!("{what}: {rate} frames a second");
    // Not frozen either.
    assert!(
        (1..=MAX_AT_REST).contains(&rate),
        "{what}: {rate} frames a second"
    );
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn few_frames_are_shown_while_nothing_happens() {
    let desktop = Desktop::open(&["--preset", "2"]);
    desktop.first_picture();
    assert_few_frames(&desktop, "the picture alone");
    desktop.press("p");
    assert_few_frames(&desktop, "with the panel");
}
