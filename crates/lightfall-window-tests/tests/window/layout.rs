//! Nothing over the picture covers anything else, nor the hole.

use crate::PLAIN;
use crate::desktop::Desktop;
use watched::{Order, Place, State};

/// Text sizes and windows: the smallest and the largest of both, and some between.
const CELLS: [(f32, [i32; 2]); 5] = [
    (1.0, [640, 360]),
    (2.5, [640, 360]),
    (1.5, [900, 500]),
    (2.5, [1440, 810]),
    (1.0, [1440, 810]),
];
/// What is opened, one after the other: the keys, and whether all of it is closed before.
const OPENED: [&[&str]; 5] = [&["z"], &["F10"], &["b"], &["0", "l"], &["p"]];
/// Frames after which everything is laid out for a new state.
const FRAMES: u32 = 6;

fn overlap(a: Place, b: Place) -> bool {
    (0..2).all(|axis| a.min[axis] < b.max[axis] && b.min[axis] < a.max[axis])
}

fn inside(inner: Place, outer: Place) -> bool {
    (0..2).all(|axis| {
        outer.min[axis] <= inner.min[axis] + 1.0 && inner.max[axis] <= outer.max[axis] + 1.0
    })
}

/// Panics where two boxes overlap, or where a text lies neither in a box nor beside `free`.
#[track_caller]
fn assert_laid_out(state: &State, scale: f32, free: [f32; 2], what: &str) {
    let boxes = &state.boxes;
    for (i, (name, place)) in boxes.iter().enumerate() {
        for (other, covered) in &boxes[..i] {
            assert!(
                !overlap(*place, *covered),
                "{what}: {name} {place:?} covers {other} {covered:?}"
            );
        }
    }
    assert!(
        boxes.iter().any(|(name, _)| name == "hole"),
        "{what}: no hole"
    );
    for text in &state.texts {
        let beside = text.place.max[0] <= free[0] || text.place.min[0] >= free[1];
        let boxed = boxes.iter().any(|(_, place)| inside(text.place, *place));
        assert!(
            beside || boxed,
            "{what}, {scale}: {text:?} lies in no box of {boxes:?}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn nothing_over_the_picture_covers_anything_else_at_any_size_of_texts_and_window() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    let check = |scale: f32, width: i32, open: &str| {
        let state = desktop.later(FRAMES);
        let width = width as f32 / scale;
        let panel = if open.contains('p') { 420.0 } else { 0.0 };
        let free = [0.0, width - panel];
        // A panel that leaves too little room lies over everything.
        if panel == 0.0 || free[1] >= 150.0 {
            assert_laid_out(&state, scale, free, &format!("{width} points, {open}"));
        }
        state
    };
    let mut most = 0;
    for (scale, [width, height]) in CELLS {
        desktop.resize(width, height);
        desktop.order(&Order::TextSize(scale));
        let mut open = String::new();
        check(scale, width, &open);
        for keys in OPENED {
            for key in keys {
                desktop.press(key);
                open += key;
            }
            most = most.max(check(scale, width, &open).boxes.len());
        }
        // Back to the plain scene.
        for key in ["p", "0", "l", "b", "F10", "z"] {
            desktop.press(key);
        }
    }
    // Hole, message, warning, labels of two sides, legend, read-outs, title, key and its labels.
    assert!(most >= 8, "at most {most} boxes");
}
