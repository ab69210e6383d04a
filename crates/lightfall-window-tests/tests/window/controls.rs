//! The controls in the window: keys, overlays, screenshots.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::x_keys::x_keys;
use crate::{PLAIN, STATUS_BAR, TITLE, WINDOW, changed, unfold_texts};
use lightfall::app::control_named;
use lightfall_core::scene::load;
use lightfall_platform::storage::embedded_preset;

/// Width of the panel on the right, with some room.
const PANEL: usize = 420;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_switch_changes_the_picture_and_pressed_again_restores_it() {
    // The probe is in view and the observer moves, so that each of them shows.
    let scene = ["--preset", "probe", "--set", "observer.velocity=0,0.1,0.3"];
    let desktop = Desktop::open_small(&scene);
    let start = desktop.first_picture();
    // Some of them: keys.rs presses all keys and reads the scene, and the tests of pictures hold the
    // passes to every change of it.
    for id in ["scene.probe", "light.doppler", "picture.bloom"] {
        // As X names it.
        let key = x_keys(control_named(id).unwrap()).remove(0);
        desktop.press(&key);
        desktop.settled(id, |shot| changed(shot, &start) > 1e-4);
        desktop.press(&key);
        desktop.settled(&format!("{id} again"), |shot| changed(shot, &start) == 0.0);
    }
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn overlays_open_and_close_and_text_fields_keep_the_keyboard() {
    let mut desktop = Desktop::open(&["--preset", PLAIN]);
    let start = desktop.first_picture();
    let right = |a: &Shot, b: &Shot| a.changed(b, WINDOW.0 - PANEL..WINDOW.0, 0..WINDOW.1);
    let left = |a: &Shot, b: &Shot| a.changed(b, 0..WINDOW.0 - PANEL, TITLE..WINDOW.1 - STATUS_BAR);
    desktop.press("p");
    desktop.settled("panel", |shot| right(shot, &start) > 0.5);
    // Into the field `name`: g, F2 and p would change the sky, the disk and the panel.
    unfold_texts(&desktop);
    let panel = desktop.settled("the texts", |_| true);
    // The picture has moved into what the panel leaves free.
    assert!(left(&panel, &start) > 0.1, "the hole stays where it was");
    desktop.click_field("Name");
    let focused = desktop.settled("the field has the keyboard", |shot| *shot != panel);
    desktop.type_text("gp");
    desktop.press("F2");
    let typed = desktop.settled("typed", |shot| right(shot, &focused) > 0.0);
    assert_eq!(
        left(&typed, &panel),
        0.0,
        "a key acted although a text field had the keyboard"
    );
    // A click outside the field gives the keyboard back to the picture.
    desktop.click("Name");
    desktop.press("F2");
    desktop.settled("F2", |shot| left(shot, &panel) > 0.1);
    desktop.press("F2");
    desktop.press("h");
    let bare = desktop.settled("hidden", |shot| right(shot, &panel) > 0.5);
    assert_eq!(left(&bare, &start), 0.0, "the picture fills the window");
    desktop.press("h");
    desktop.settled("shown again", |shot| right(shot, &start) > 0.5);
    desktop.press("p");
    desktop.settled("no panel", |shot| changed(shot, &start) == 0.0);
    assert!(desktop.running());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn guides_are_drawn_where_the_shadow_ends_and_vanish_with_their_key() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    let start = desktop.first_picture();
    // Pixels in the yellow of the shadow's edge, right of the middle of the picture.
    let edge = |shot: &Shot| {
        let columns = WINDOW.0 / 2..WINDOW.0 * 3 / 5;
        let yellow = |x: &usize| {
            let [r, g, b] = shot.pixel(*x, WINDOW.1 / 2);
            r > 220 && (170..240).contains(&g) && b < 150
        };
        columns.filter(yellow).collect::<Vec<_>>()
    };
    assert!(edge(&start).is_empty());
    desktop.press("F10");
    let guides = desktop.settled("guides", |shot| edge(shot).len() > 1);
    // Synge's angle on a picture 50 degrees high, from 20 r_s: sin a = 0.1266.
    let half = WINDOW.1 as f64 / 2.0;
    let radius = 0.1266_f64.asin().tan() / 25_f64.to_radians().tan() * half;
    let wanted = WINDOW.0 as f64 / 2.0 + radius;
    let found = edge(&guides);
    assert!(
        found.iter().any(|x| (*x as f64 - wanted).abs() < 2.0),
        "{found:?} without {wanted}"
    );
    desktop.press("F10");
    desktop.settled("no guides", |shot| changed(shot, &start) == 0.0);
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn screenshots_of_picture_and_window_are_new_files_that_replace_no_others() {
    let desktop = Desktop::open(&["--preset", PLAIN]);
    let start = desktop.first_picture();
    let pictures = desktop.home.path().join("Pictures");
    let saved = |number: usize| {
        let file = pictures.join(format!("lightfall-edge-on-{number:04}.png"));
        desktop.wait("the screenshot", || image::open(&file).is_ok());
        desktop.settled("the path is shown", |shot| *shot != start);
        let preset = embedded_preset(&std::fs::read(&file).unwrap()).unwrap();
        let scene = load("the picture", &preset, &[]).unwrap();
        assert_eq!(scene.name, "edge-on");
        (image::open(&file).unwrap().to_rgb8(), scene)
    };
    // Pixels in the middle, which only the picture has, and the bar of the HUD in a corner.
    let shows_the_picture = |saved: &image::RgbImage| {
        assert_eq!((saved.width() as usize, saved.height() as usize), WINDOW);
        for (x, y) in [(700, 300), (300, 430), (1000, 100)] {
            assert_eq!(
                saved.get_pixel(x, y).0,
                start.pixel(x as usize, y as usize),
                "pixel {x}, {y}"
            );
        }
    };
    let corner = |saved: &image::RgbImage| {
        let bar = WINDOW.1 as u32 - 60..WINDOW.1 as u32 - 10;
        let pixels = bar.flat_map(|y| (10..200).map(move |x| (x, y)));
        pixels
            .map(|(x, y)| saved.get_pixel(x, y).0)
            .collect::<Vec<_>>()
    };
    // Where messages are: above the read-outs, which begin at 751.
    let messages = |saved: &image::RgbImage| {
        let pixels = (640..748).flat_map(|y| (560..880).map(move |x| (x, y)));
        pixels
            .map(|(x, y)| saved.get_pixel(x, y).0)
            .collect::<Vec<_>>()
    };
    let mut bare = Vec::new();
    // The panel, which is open for the second one, does not change the picture.
    for number in 1..=2 {
        desktop.press("F12");
        let (picture, scene) = saved(number);
        shows_the_picture(&picture);
        assert_eq!(scene.picture.size().to_array(), [1440, 810]);
        bare.push((corner(&picture), messages(&picture)));
        desktop.press("p");
    }
    assert!(bare[0] == bare[1], "the HUD is in the picture");
    // The panel's key has led to a message.
    desktop.chord("shift", "F12");
    let (window, _) = saved(3);
    shows_the_picture(&window);
    assert!(corner(&window) != bare[0].0, "the HUD is not in the window");
    // Letters are bright. A tone of the picture, which the pixel look dithers, may differ by a few steps.
    let message = messages(&window)
        .iter()
        .zip(&bare[0].1)
        .any(|(shown, plain)| (0..3).any(|channel| shown[channel].abs_diff(plain[channel]) > 100));
    assert!(!message, "a message is in the window");
    assert_eq!(std::fs::read_dir(&pictures).unwrap().count(), 3);
}
