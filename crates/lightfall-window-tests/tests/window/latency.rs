//! How many frames the picture takes to follow a key.

use crate::PLAIN;
use crate::desktop::Desktop;
use watched::Order;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_picture_follows_a_key_in_the_same_frame_or_the_next() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::KeepPicture);
    desktop.wait_for("the picture is kept", |state| state.kept.is_some());
    desktop.press("equal");
    let compared = |kept: &Option<Vec<bool>>| kept.as_ref().is_some_and(|kept| kept.len() == 4);
    let state = desktop.wait_for("four frames", |state| compared(&state.kept));
    // The screen shows a frame while the program works on the next one: in frame 0 or 1 is on the
    // screen within two frames.
    let differs = state.kept.unwrap();
    let first = differs.iter().position(|differs| *differs);
    assert!(
        first.is_some_and(|frame| frame <= 1),
        "the frames that differ: {differs:?}"
    );
}
