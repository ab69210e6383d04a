//! Two settings side by side in the window.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{PLAIN, WINDOW};

/// The rows in which the picture is compared: below the labels and above the lines of text.
const ROWS: std::ops::Range<usize> = 150..600;
/// Columns beside the divider that its line and its handle cover.
const DIVIDER: usize = 24;

fn left(a: &Shot, b: &Shot, divider: usize) -> f64 {
    a.changed(b, 0..divider - DIVIDER, ROWS)
}

fn right(a: &Shot, b: &Shot, divider: usize) -> f64 {
    a.changed(b, divider + DIVIDER..WINDOW.0, ROWS)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_divider_separates_the_pinned_settings_from_the_changed_ones_and_can_be_dragged() {
    // Bloom would carry light over the divider.
    let desktop = Desktop::open(&["--preset", PLAIN, "--set", "picture.bloom=0"]);
    let bent = desktop.first_picture();
    desktop.press("l");
    let straight = desktop.settled("L", |shot| shot.changed(&bent, 0..WINDOW.0, ROWS) > 0.1);
    desktop.press("l");
    desktop.settled("L again", |shot| {
        shot.changed(&bent, 0..WINDOW.0, ROWS) == 0.0
    });

    let middle = WINDOW.0 / 2;
    desktop.press("0");
    let line = |shot: &Shot, x: usize| {
        ROWS.filter(|y| shot.pixel(x, *y).iter().all(|channel| *channel > 200))
            .count()
    };
    desktop.settled("0", |shot| {
        line(shot, middle) > ROWS.len() - 10
            && left(shot, &bent, middle) == 0.0
            && right(shot, &bent, middle) == 0.0
    });
    desktop.press("l");
    desktop.settled("L, on the right", |shot| {
        left(shot, &bent, middle) == 0.0 && right(shot, &straight, middle) == 0.0
    });

    // Anywhere along the line the mouse takes hold of it.
    let moved = 480;
    desktop.point(middle as i32, 650);
    desktop.later(4);
    desktop.xdotool(&["mousedown", "1"]);
    desktop.later(4);
    for x in [700, 600, moved as i32] {
        desktop.point(x, 500);
        desktop.later(4);
    }
    desktop.xdotool(&["mouseup", "1"]);
    desktop.settled("the dragged divider", |shot| {
        line(shot, moved) > ROWS.len() - 10
            && left(shot, &bent, moved) == 0.0
            && right(shot, &straight, moved) == 0.0
    });

    desktop.chord("shift", "0");
    let difference = desktop.settled("Shift and 0", |shot| line(shot, moved) < 300);
    // Black but for the words where the two agree, and bright where they do not.
    let lit = |shot: &Shot| shot.rows(ROWS).colours();
    assert!(lit(&difference) > 50, "the difference is empty");
    desktop.press("0");
    desktop.settled("0, side by side again", |shot| {
        left(shot, &bent, middle) == 0.0 && right(shot, &straight, middle) == 0.0
    });
    // Two whole pictures: on each side, the hole is at the middle.
    desktop.press("0");
    desktop.settled("0, two whole pictures", |shot| {
        line(shot, middle) > ROWS.len() - 10
            && left(shot, &bent, middle) > 0.1
            && right(shot, &straight, middle) > 0.1
    });
    desktop.press("l");
    desktop.settled("L, the same picture twice", |shot| {
        let columns = DIVIDER..middle - DIVIDER;
        ROWS.flat_map(|y| columns.clone().map(move |x| (x, y)))
            .all(|(x, y)| shot.pixel(x, y) == shot.pixel(middle + x, y))
    });
    desktop.press("l");
    desktop.press("0");
    desktop.settled("0, the end", |shot| {
        shot.changed(&straight, 0..WINDOW.0, ROWS) == 0.0
    });
}
