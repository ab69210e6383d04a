//! Nothing over the picture covers anything else, nor the hole.

use crate::PLAIN;
use crate::desktop::Desktop;
use watched::{Order, Place, State};

/// Text sizes and windows: the smallest and the largest of both, and some between.
const CELLS: [(f32, [i32; 2]); 6] = [
    (1.0, [500, 300]),
    (1.0, [640, 360]),
    (2.5, [640, 360]),
    (1.5, [900, 500]),
    (2.5, [1440, 810]),
    (1.0, [1440, 810]),
];
/// What is opened, one after the other.
const OPENED: [&[&str]; 7] = [
    &["z"],
    &["F10"],
    &["shift+g"],
    &["b"],
    &["0", "l"],
    &["i"],
    &["p"],
];
/// The keys that close it; side by side is followed by two pictures.
const CLOSED: [&str; 9] = ["p", "i", "0", "0", "l", "b", "shift+g", "F10", "z"];
/// Widths of the inspector and of the panel, and the least width beside them, in points.
const INSPECTOR: f32 = 390.0;
const PANEL: f32 = 420.0;
const MIN_PICTURE: f32 = 150.0;
/// A journey with one caption and an ending.
const JOURNEY: &str = r#"
schema = 1
title = "Down"
ending = "Here the ring is thin."
keyframe = [{ time = 0, r = 20 }, { time = 30, r = 15 }]
[[caption]]
time = 4.6
seconds = 20
text = "The arch is the far side of the disk, and the thin ring is light that went around the hole."
"#;
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
            // These cover it where there is no room beside it.
            let always = [
                "notice",
                "end card",
                "toast",
                "journey",
                "caption",
                "mission",
                "instruments",
                "map",
            ]
            .contains(&&**name);
            assert!(
                (always && other == "hole") || !overlap(*place, *covered),
                "{what}: {name} {place:?} covers {other} {covered:?}"
            );
        }
    }
    for text in &state.texts {
        let beside = text.place.max[0] <= free[0] || text.place.min[0] >= free[1];
        let boxed = boxes.iter().any(|(_, place)| inside(text.place, *place));
        assert!(
            beside || boxed,
            "{what}, {scale}: {text:?} lies in no box of {boxes:?}"
        );
    }
}

fn press_all(desktop: &Desktop, keys: &[&str]) {
    for key in keys {
        desktop.press(key);
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn nothing_over_the_picture_covers_anything_else_at_any_size_of_texts_and_window() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    let shows = |state: &State, name: &str| state.boxes.iter().any(|(shown, _)| shown == name);
    let check = |scale: f32, width: i32, open: &str| {
        let state = desktop.later(FRAMES);
        let width = width as f32 / scale;
        let free = match [open.contains('i'), open.contains('p')] {
            [false, false] => [0.0, width],
            [true, false] => [INSPECTOR, width],
            // In these windows the panel covers the inspector.
            [inspector, true] if !inspector || width < INSPECTOR + PANEL + MIN_PICTURE => {
                [0.0, width - PANEL]
            }
            _ => [INSPECTOR, width - PANEL],
        };
        // A panel that leaves too little room lies over everything.
        if free == [0.0, width] || free[1] - free[0] >= MIN_PICTURE {
            assert_laid_out(&state, scale, free, &format!("{width} points, {open}"));
        }
        state
    };
    let mut most = 0;
    for (scale, [width, height]) in CELLS {
        desktop.resize(width, height);
        desktop.order(&Order::TextSize(scale));
        let mut open = String::new();
        let plain = check(scale, width, &open);
        assert!(shows(&plain, "hole"), "{width}, {scale}: no hole");
        for keys in OPENED {
            for key in keys {
                desktop.press(key);
                open += key;
            }
            most = most.max(check(scale, width, &open).boxes.len());
        }
        press_all(&desktop, &CLOSED);
        // Without disk and sky nothing shines.
        press_all(&desktop, &["F2", "F3"]);
        assert!(shows(&check(scale, width, "notice"), "notice"));
        press_all(&desktop, &["F2", "F3"]);
    }
    // Hole, message, warning, labels of two sides, legend, read-outs, title, key and its labels.
    assert!(most >= 8, "at most {most} boxes");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn captions_the_end_card_and_the_whole_menu_have_room_in_small_windows() {
    let files = tempfile::tempdir().unwrap();
    let journey = files.path().join("down.toml");
    std::fs::write(&journey, JOURNEY).unwrap();
    let journey = journey.to_str().unwrap();
    let desktop = Desktop::open_small(&["--preset", PLAIN, "--journey", journey]);
    desktop.first_picture();
    let assert_shown = |name: &str| {
        for (scale, [width, height]) in &CELLS[..3] {
            desktop.resize(*width, *height);
            desktop.order(&Order::TextSize(*scale));
            let state = desktop.later(FRAMES);
            let what = format!("{width} x {height}, {scale}");
            assert_laid_out(&state, *scale, [0.0, *width as f32 / scale], &what);
            let shown = state.boxes.iter().any(|(shown, _)| shown == name);
            assert!(shown, "{what}: no {name} in {:?}", state.boxes);
            assert!(state.texts.iter().all(|text| !text.words.ends_with('…')));
        }
        desktop.order(&Order::TextSize(1.0));
    };
    // From its start, and past the title.
    desktop.press("Return");
    desktop.press("shift+Right");
    desktop.press("slash");
    desktop.wait_for("the caption", |state| state.mentions("thin ring"));
    assert_shown("journey");
    desktop.press("slash");
    press_all(&desktop, &["shift+Right"; 5]);
    desktop.wait_for("the end card", |state| {
        state.shows("Here the ring is thin.")
    });
    assert_shown("end card");
    desktop.press("Escape");

    let [width, height] = CELLS[0].1;
    desktop.resize(width, height);
    desktop.press("Escape");
    let menu = desktop.wait_for("the menu", |state| state.shows("Quit"));
    let last = menu.texts.iter().find(|text| text.words == "Quit").unwrap();
    assert!(last.place.max[1] < height as f32 - 10.0, "{last:?}");
}

/// Windows of players, and their text sizes.
const WINDOWS: [[i32; 2]; 3] = [[800, 600], [1024, 768], [1280, 720]];
const TEXTS: [f32; 4] = [1.0, 1.25, 1.5, 2.0];

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_message_moves_neither_the_instruments_nor_the_map_of_a_mission() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    press_all(&desktop, &["shift+j", "Return"]);
    desktop.wait_for("the card", |state| state.ship.is_some() && !state.menu);
    let place = |state: &State, wanted: &str| {
        let found = state.boxes.iter().find(|(name, _)| name == wanted);
        found.map(|(_, place)| *place)
    };
    let mut maps = 0;
    let mut looked = |with_card: bool| {
        for [width, height] in WINDOWS {
            desktop.resize(width, height);
            for scale in TEXTS {
                desktop.order(&Order::TextSize(scale));
                let before = desktop.later(FRAMES);
                // The map's key says something, and leaves the card open.
                press_all(&desktop, &["shift+m", "shift+m", "shift+m"]);
                let said = desktop.later(FRAMES);
                let what = format!("{width} x {height}, {scale}, card {with_card}");
                assert!(place(&said, "toast").is_some(), "{what}: {:?}", said.boxes);
                assert!(place(&said, "instruments").is_some(), "{what}");
                for name in ["instruments", "map"] {
                    assert_eq!(place(&before, name), place(&said, name), "{what}: {name}");
                }
                maps += u32::from(place(&said, "map").is_some());
                assert_laid_out(&said, scale, [0.0, width as f32 / scale], &what);
            }
        }
        desktop.order(&Order::TextSize(1.0));
    };
    looked(true);
    // The card gives way, and the clocks stand as they are.
    press_all(&desktop, &["Escape", "slash"]);
    desktop.wait_for("the caption", |state| {
        state.mentions("Your nose points backward")
    });
    looked(false);
    assert!(maps >= 8, "the map has a place in {maps} windows");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_instruments_the_map_and_the_captions_of_a_mission_cover_nothing() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    desktop.first_picture();
    let check = |open: &str, wanted: &[&str]| {
        for (scale, [width, height]) in CELLS {
            desktop.resize(width, height);
            desktop.order(&Order::TextSize(scale));
            let state = desktop.later(FRAMES);
            let what = format!("{width} x {height}, {scale}, {open}");
            assert_laid_out(&state, scale, [0.0, width as f32 / scale], &what);
            if [width, height] == [1440, 810] && scale == 1.0 {
                for name in wanted {
                    let shown = state.boxes.iter().any(|(shown, _)| shown == name);
                    assert!(shown, "{what}: no {name} in {:?}", state.boxes);
                }
            }
        }
        desktop.order(&Order::TextSize(1.0));
    };
    press_all(&desktop, &["shift+j", "Return"]);
    desktop.wait_for("the card", |state| state.ship.is_some() && !state.menu);
    // The card says what the goals say, and may have their place.
    check("card", &["end card", "instruments", "map"]);
    press_all(&desktop, &["Escape", "slash"]);
    desktop.wait_for("the caption", |state| {
        state.mentions("Your nose points backward")
    });
    check("caption", &["caption", "instruments", "map", "mission"]);
    // From retrograde to outward, to a star, to the gyroscopes, and to the hole.
    press_all(&desktop, &["y"; 4]);
    desktop.later(20);
    check(
        "hole",
        &["hole", "caption", "instruments", "map", "mission"],
    );
}
