//! The pixel look in the window: its cells fill windows of every shape, and it is a preference that
//! presets keep.

use crate::desktop::Desktop;
use crate::shot::Shot;
use bevy::math::UVec2;
use lightfall_core::scene::Picture;
use lightfall_core::scene::fit;
use lightfall_render::letterbox;

/// The part of the window that nothing is written on.
fn picture(shot: &Shot) -> Shot {
    shot.rows(120..520)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_picture_fills_windows_of_every_shape_with_even_cells() {
    let desktop = Desktop::open(&["--preset", "2", "--set", "sky.mode=grid"]);
    desktop.first_picture();
    // Everything but the picture is hidden.
    desktop.press("h");
    for (width, height) in [
        (1366, 768),
        (700, 450),
        (1001, 601),
        (450, 800),
        (1490, 420),
    ] {
        desktop.resize(width as i32, height as i32);
        desktop.wait("the new size", || desktop.size() == (width, height));
        let lit = |shot: &Shot, x: std::ops::Range<usize>, y: std::ops::Range<usize>| {
            x.clone()
                .any(|x| y.clone().any(|y| shot.pixel(x, y) != [0, 0, 0]))
        };
        // With a frame these strips would be black from end to end.
        let shot = desktop.settled("a picture that fills the window", |shot| {
            lit(shot, 0..width, 0..20)
                && lit(shot, 0..width, height - 20..height)
                && lit(shot, 0..20, 0..height)
                && lit(shot, width - 20..width, 0..height)
        });
        let window = UVec2::new(width as u32, height as u32);
        let drawn = fit(&Picture::default(), window, u64::MAX);
        let shown = letterbox(&drawn, window);
        let scale = (shown.extent.x as usize) / drawn.grid_width as usize;
        let corner = |at: usize, offset: f32| {
            let beyond = (-offset) as usize;
            ((at + beyond) / scale * scale).saturating_sub(beyond)
        };
        // A message may still lie over the lowest rows.
        for y in 0..2 * height / 3 {
            for x in 0..width {
                let first = shot.pixel(corner(x, shown.offset.x), corner(y, shown.offset.y));
                assert_eq!(
                    shot.pixel(x, y),
                    first,
                    "{width}x{height}: the cell at {x}, {y} is not even"
                );
            }
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn presets_keep_the_pixel_look_and_undo_takes_it_back() {
    let desktop = Desktop::open(&["--preset", "2"]);
    let start = desktop.first_picture();
    let cells = picture(&start).colours();
    // Few tones lie in cells, and many without them.
    let smooth = |shot: &Shot| picture(shot).colours() > 2 * cells;
    desktop.press("F7");
    let two = desktop.settled("F7", smooth);
    desktop.wait("the setting", || says(&desktop, "pixel_look = false"));
    // Nothing moves there.
    desktop.press("5");
    desktop.settled("preset 5 without cells", |shot| {
        smooth(shot) && picture(shot) != picture(&two)
    });
    desktop.press("BackSpace");
    desktop.settled("preset 2 without cells", |shot| {
        picture(shot) == picture(&two)
    });
    desktop.press("BackSpace");
    desktop.settled("the start", |shot| picture(shot) == picture(&start));
    desktop.wait("the setting", || says(&desktop, "pixel_look = true"));
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_command_line_chooses_the_look_for_one_run() {
    let desktop = Desktop::open_with_settings("pixel_look = true\n", &["--cells", "off"]);
    let many = |shot: &Shot| picture(shot).colours() > 5000;
    desktop.first_picture();
    desktop.settled("no cells", many);
    desktop.press("6");
    // The disk moves.
    desktop.press("slash");
    desktop.settled("no cells in another preset", many);
    // The settings are written when the window closes, at the latest.
    let mut desktop = desktop;
    desktop.press_at_once("ctrl+q");
    assert!(desktop.ended().success());
    assert!(says(&desktop, "pixel_look = true"));
}

/// Whether the settings file contains this line.
fn says(desktop: &Desktop, line: &str) -> bool {
    std::fs::read_to_string(desktop.settings()).is_ok_and(|text| text.contains(line))
}
