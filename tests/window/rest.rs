//! A window in which nothing happens draws few frames.

use crate::desktop::Desktop;
use std::time::{Duration, Instant};

/// Maximum number of frames a second at rest: frames are a fifth of a second apart, and each may be
/// followed by one more. A window that does not rest shows more frames than this on any machine
/// that reaches the required ten frames a second with the panel open.
const MAX: usize = 12;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn few_frames_are_shown_while_nothing_happens() {
    let desktop = Desktop::open(&["--preset", "2"]);
    desktop.first_picture();
    let rests = |what: &str| {
        let began = Instant::now();
        let mut rates = Vec::new();
        // Three seconds after the last input it may rest; a busy machine is given longer.
        while began.elapsed() < Duration::from_secs(20) {
            rates.push(desktop.shown_within(Duration::from_secs(2)) / 2);
            if rates.last().is_some_and(|&rate| rate <= MAX) {
                break;
            }
        }
        println!("{what}: {rates:?} frames a second");
        assert!(
            rates.last().is_some_and(|&rate| rate <= MAX),
            "{what}: {rates:?} frames a second, and never fewer"
        );
        // Not frozen either.
        assert!(rates.last() > Some(&0), "{what}: no frame at all");
    };
    rests("the picture alone");
    desktop.press("p");
    rests("with the panel");
}
