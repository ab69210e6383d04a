//! The help on F1, and the room that it takes.

use crate::desktop::Desktop;
use crate::{PLAIN, WINDOW};
use lightfall::app::{Bindings, Group, help_rows};
use watched::{Place, State};

/// The least room between the help's words and the window's edges, in points.
const EDGE: f32 = 8.0;

/// The place of a text that is shown once.
fn place(state: &State, words: &str) -> Option<Place> {
    let text = state.texts.iter().find(|text| text.words == words)?;
    Some(text.place)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_help_shows_every_key_without_scrolling_in_windows_of_two_sizes() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    let bindings = Bindings::default();
    let does: Vec<String> = Group::ALL
        .into_iter()
        .flat_map(|group| help_rows(&bindings, group))
        .map(|[_, does]| does)
        .collect();
    for size in [WINDOW, (1280, 720)] {
        desktop.resize(size.0 as i32, size.1 as i32);
        desktop.wait("the size", || desktop.size() == size);
        desktop.later(3);
        desktop.press("F1");
        let missing = |state: &State| does.iter().any(|does| place(state, does).is_none());
        desktop.wait_for("every row of the help", |state| !missing(state));
        let shown = desktop.later(3);
        for does in &does {
            let Place { min, max } = place(&shown, does).unwrap();
            let fits = min.iter().all(|side| *side >= EDGE)
                && max[0] <= size.0 as f32 - EDGE
                && max[1] <= size.1 as f32 - EDGE;
            assert!(fits, "{does} at {min:?} to {max:?} in {size:?}");
        }
        // Nothing is left to scroll to.
        let [x, y] = place(&shown, &does[0]).unwrap().centre();
        desktop.point(x as i32, y as i32);
        for button in ["5", "5", "7", "7"] {
            desktop.xdotool(&["click", button]);
        }
        let scrolled = desktop.later(20);
        for does in &does {
            assert_eq!(place(&scrolled, does), place(&shown, does), "{does} moved");
        }
        desktop.press("F1");
        desktop.wait_for("no help", missing);
    }
    desktop.end_without_error();
}
