//! What the window says: what replaces what, and how well it can be read.

use crate::PLAIN;
use crate::desktop::Desktop;
use crate::shot::Shot;
use lightfall_core::scene::{Scene, presets};
use std::ops::Range;
use watched::{Order, Place, State, Text};

/// Stands for the key of [`white_scene`], which has none.
const WHITE: &str = "white";

/// A picture that is white where texts are: a glaring disk that fills the view.
fn white_scene() -> Scene {
    let mut scene = presets::find("above").unwrap().scene(&[]).unwrap();
    scene.camera.theta_deg = 20.0;
    scene.camera.r = 60.0;
    scene.disk.outer = 3000.0;
    scene.disk.brightness = 1000.0;
    scene.disk.temperature_k = 3e5;
    scene.picture.automatic_exposure = false;
    scene.picture.exposure_ev = 20.0;
    scene.picture.bloom = 0.0;
    scene.title = "A picture that is white".into();
    scene
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_fall_ends_a_journey_and_a_journey_ends_a_fall() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    let flies = |state: &State| state.mentions("Journey, ") && !state.mentions("falling freely");
    let falls = |state: &State| state.mentions("falling freely") && !state.mentions("Journey, ");
    desktop.press("j");
    desktop.wait_for("the journey", flies);
    desktop.press("f");
    let fall = desktop.wait_for("the fall", falls);
    assert!(!fall.mentions("by hand"), "{fall:?}");
    desktop.press("Return");
    let journey = desktop.wait_for("the journey again", flies);
    assert!(!journey.mentions("by hand"), "{journey:?}");
}

/// The luminance of a colour (WCAG 2.2, relative luminance).
pub fn luminance(colour: [u8; 3]) -> f64 {
    let [r, g, b] = colour.map(|channel| {
        let channel = f64::from(channel) / 255.0;
        if channel <= 0.04045 {
            channel / 12.92
        } else {
            ((channel + 0.055) / 1.055).powf(2.4)
        }
    });
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// The contrast of two luminances (WCAG 2.2, contrast ratio).
pub fn contrast(a: f64, b: f64) -> f64 {
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// The pixels of a text.
pub fn pixels(place: Place) -> [Range<usize>; 2] {
    [0, 1].map(|axis| place.min[axis] as usize..place.max[axis].ceil() as usize)
}

/// The screen, and the texts that are there before and after it was looked at. What fades away may
/// be gone before the screen shows it.
fn texts_on_screen(desktop: &Desktop) -> (Vec<Text>, Shot) {
    let mut before = desktop.state().texts;
    // A frame is on the screen some time after its texts were written down.
    desktop.later(3);
    let shot = desktop.shot();
    let after = desktop.later(1).texts;
    before.retain(|text| text.opacity == 1.0 && after.contains(text));
    (before, shot)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn texts_over_any_picture_have_a_contrast_of_at_least_four_and_a_half() {
    // A text that fades away is not meant to be read.
    let desktop = Desktop::open_with_settings("reduced_motion = true\n", &["--preset", PLAIN]);
    desktop.first_picture();
    // The disks of presets 2 and 4 move, until slash pauses them.
    desktop.press("2");
    desktop.press("slash");
    // A picture, and what is pressed over it: for a title, a message and what is switched off; and
    // for a legend.
    for (key, over) in [
        ("2", ["2", "z"]),
        ("2", ["2", "b"]),
        ("4", ["4", "z"]),
        (WHITE, ["v", "z"]),
    ] {
        if key == WHITE {
            desktop.order(&Order::Show(white_scene().to_preset()));
        } else {
            desktop.press(key);
        }
        desktop.settled(key, |_| true);
        for key in over {
            desktop.press(key);
        }
        let (texts, shot) = texts_on_screen(&desktop);
        let mut faint = Vec::new();
        for Text { words, place, .. } in &texts {
            let inside = |px: usize, py: usize| {
                // Smoothed letters reach one pixel beyond their outlines.
                texts.iter().any(|text| {
                    let [x, y] = pixels(text.place);
                    (x.start - 1..x.end + 1).contains(&px) && (y.start - 1..y.end + 1).contains(&py)
                })
            };
            let [x, y] = pixels(*place);
            let brightest = y
                .clone()
                .flat_map(|py| x.clone().map(move |px| (px, py)))
                .map(|(px, py)| luminance(shot.pixel(px, py)))
                .fold(0.0, f64::max);
            // The box around the letters, without other letters.
            let around = (y.start - 3..y.end + 3)
                .flat_map(|py| (x.start - 3..x.end + 3).map(move |px| (px, py)))
                .filter(|&(px, py)| !inside(px, py))
                .map(|(px, py)| luminance(shot.pixel(px, py)));
            let worst = around
                .map(|ground| contrast(brightest, ground))
                .fold(f64::INFINITY, f64::min);
            println!("{key}: {worst:.1}:1 {words}");
            if worst < 4.5 {
                faint.push(format!("{worst:.1}:1 {words}"));
            }
        }
        assert!(texts.len() > 8, "{} texts with {key}", texts.len());
        assert!(faint.is_empty(), "{key}: {faint:?}");
        if key == WHITE {
            // Beyond the boxes the picture is white, so the test has tested what it should.
            let white = |px: usize, py: usize| luminance(shot.pixel(px, py)) > 0.85;
            assert!(
                white(4, 806) && white(1436, 806) && white(720, 600),
                "not white"
            );
        }
    }
}
