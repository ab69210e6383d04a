//! What the window says: every key's message, and how well it can be read.

use crate::desktop::Desktop;
use crate::program;
use crate::shot::Shot;
use crate::x_keys::x_keys;
use bevy::diagnostic::FrameCount;
use bevy::prelude::*;
use bevy_egui::{EguiFullOutput, EguiPostUpdateSet, egui};
use lightfall::app::{Action, CONTROLS, Control, control_named, edited, statement};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Scene, presets};
use lightfall_render::CurrentScene;
use std::collections::BTreeSet;
use std::ops::Range;
use std::time::Duration;

/// Between two texts in a line that the watched program writes.
const BETWEEN: char = '\u{1f}';
/// Frames after a key within which its message is shown.
const PROMPT: u32 = 2;
/// Frames before a key whose texts are no news.
const BEFORE: usize = 3;

/// The last key, and the frame in which it came.
#[derive(Resource, Default)]
struct Key(Option<(KeyCode, u32)>);

/// Texts of the last frames, the latest last.
#[derive(Resource, Default)]
struct Recent(Vec<BTreeSet<String>>);

fn notice_key(keys: Res<ButtonInput<KeyCode>>, frame: Res<FrameCount>, mut key: ResMut<Key>) {
    // A modifier may come in the same frame as its key.
    let modifier = |code: &&KeyCode| {
        matches!(
            code,
            KeyCode::AltLeft | KeyCode::ControlLeft | KeyCode::ShiftLeft
        )
    };
    let pressed = || keys.get_just_pressed();
    if let Some(code) = pressed().find(|code| !modifier(code)).or(pressed().next()) {
        key.0 = Some((*code, frame.0));
    }
}

/// Writes the texts that are shown in the frames after a key, which of them are new, and with keypad 0
/// where each text is.
fn report_texts(
    outputs: Query<&EguiFullOutput>,
    keys: Res<ButtonInput<KeyCode>>,
    frame: Res<FrameCount>,
    mut key: ResMut<Key>,
    mut recent: ResMut<Recent>,
) {
    let mut shown = Vec::new();
    for output in outputs.iter().filter_map(|output| output.0.as_ref()) {
        for clipped in &output.shapes {
            collect(&clipped.shape, &mut shown);
        }
    }
    let texts: BTreeSet<String> = shown.iter().map(|(text, ..)| text.clone()).collect();
    if keys.just_pressed(KeyCode::Numpad0) {
        // What fades away may be gone before a screenshot is taken.
        for (text, place, _) in shown.iter().filter(|(_, _, opacity)| *opacity == 1.0) {
            let [x0, y0, x1, y1] = [place.min.x, place.min.y, place.max.x, place.max.y];
            eprintln!("place{BETWEEN}{x0}{BETWEEN}{y0}{BETWEEN}{x1}{BETWEEN}{y1}{BETWEEN}{text}");
        }
        eprintln!("places end");
    }
    if let Some((code, pressed)) = key.0 {
        let later = frame.0 - pressed;
        let before = recent.0.len().saturating_sub(later as usize);
        let known: BTreeSet<&String> = recent.0[..before].iter().flatten().collect();
        for text in &texts {
            let kind = if known.contains(text) { "shown" } else { "new" };
            eprintln!("{kind}{BETWEEN}{text}");
        }
        if later == PROMPT {
            key.0 = None;
            eprintln!("after {code:?}");
        }
    }
    recent.0.push(texts);
    let spare = recent.0.len().saturating_sub(BEFORE + PROMPT as usize);
    recent.0.drain(..spare);
}

/// The texts of a shape that can be seen, each with its place in points and its opacity.
fn collect(shape: &egui::Shape, shown: &mut Vec<(String, egui::Rect, f32)>) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, shown)),
        egui::Shape::Text(text) if text.opacity_factor > 0.2 => {
            let offset = text.pos.to_vec2();
            let place = text.galley.mesh_bounds.translate(offset);
            let words = text.galley.text().replace('\n', " ");
            if !words.trim().is_empty() {
                shown.push((words, place, text.opacity_factor));
            }
        }
        _ => {}
    }
}

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

/// Keypad 1 shows a white picture.
fn show_white(keys: Res<ButtonInput<KeyCode>>, mut scene: ResMut<CurrentScene>) {
    if keys.just_pressed(KeyCode::Numpad1) {
        scene.0 = Drawable::new(white_scene()).unwrap();
    }
}

/// The program, which writes down what it shows. This is no test: the tests below start it as
/// another process.
#[test]
#[ignore = "started by the tests of messages"]
fn started_program_that_writes_down_its_texts() {
    let mut app = program();
    app.init_resource::<Key>()
        .init_resource::<Recent>()
        .add_systems(Update, (notice_key, show_white))
        .add_systems(
            PostUpdate,
            report_texts
                .after(EguiPostUpdateSet::EndPass)
                .before(EguiPostUpdateSet::ProcessOutput),
        );
    assert_eq!(app.run(), AppExit::Success);
}

fn open_watched(settings: &str) -> Desktop {
    let program = std::env::current_exe().unwrap();
    let only = [
        "--exact",
        "messages::started_program_that_writes_down_its_texts",
        "--ignored",
        "--test-threads=1",
        "--nocapture",
    ];
    let desktop = Desktop::open_program_with_settings(&program, settings, &only);
    desktop.first_picture();
    desktop
}

/// The texts that are shown within the frames after a key.
struct Answer {
    shown: BTreeSet<String>,
    /// Those that were not shown before.
    new: BTreeSet<String>,
}

/// Presses a control's key and reads the window's answer.
fn answer(desktop: &Desktop, control: &Control) -> Answer {
    let before = desktop.stderr().len();
    let key = &x_keys(control)[0];
    let held = matches!(control.action, Action::Hold(_));
    if held {
        desktop.xdotool(&["keydown", key]);
    } else {
        desktop.xdotool(&["key", "--delay", "80", key]);
    }
    // Every press is waited for, so that no frame is taken for an answer to a later key.
    let end = format!("after {:?}", control.keys[0]);
    desktop.wait(&format!("{}: frames after the key", control.id), || {
        desktop.stderr()[before..].contains(&end)
    });
    if held {
        desktop.xdotool(&["keyup", key]);
    }
    let stderr = desktop.stderr();
    let lines: Vec<&str> = stderr[before..].lines().collect();
    let end = lines.iter().position(|line| *line == end).unwrap_or(0);
    let begin = lines[..end]
        .iter()
        .rposition(|line| line.starts_with("after "));
    let texts = |kinds: &[&str]| {
        lines[begin.unwrap_or(0)..end]
            .iter()
            .filter_map(|line| line.split_once(BETWEEN))
            .filter(|(kind, _)| kinds.contains(kind))
            .map(|(_, text)| text.to_owned())
            .collect()
    };
    Answer {
        shown: texts(&["new", "shown"]),
        new: texts(&["new"]),
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn every_key_of_the_table_leads_to_its_message_within_two_frames() {
    let mut desktop = open_watched("");
    let scene = presets::find("2").unwrap().scene(&[]).unwrap();
    let back = control_named("preset.2").unwrap();
    let mut silent = Vec::new();
    // What leaves the program comes last.
    let quits = |control: &&Control| control.id.contains("quit");
    let (last, others): (Vec<&Control>, Vec<&Control>) = CONTROLS.iter().partition(quits);
    for control in others {
        let Answer { shown, new } = answer(&desktop, control);
        // A preset says its number, a switch its state. What a held key changes is read from the
        // read-outs, and commands say what they do in their own words.
        let says: Option<String> = match control.action {
            Action::Edit(_) => edited(control, &scene, &scene)
                .and_then(|after| statement(control, &after))
                .and_then(|words| Some(words.split_once(':')?.0.to_owned())),
            Action::Load(number) => Some(number.to_string()),
            _ => None,
        };
        let said = match &says {
            Some(words) => shown.iter().any(|text| text.starts_with(words.as_str())),
            None => !new.is_empty(),
        };
        println!("{}: {new:?}", control.id);
        if !said {
            silent.push(control.id);
        }
        // Back to the preset, with everything closed that was opened.
        if matches!(control.action, Action::Do(_)) {
            answer(&desktop, control);
        }
        answer(&desktop, back);
        assert!(desktop.running(), "{}: {}", control.id, desktop.stderr());
    }
    assert!(silent.is_empty(), "silent: {silent:?}");
    for control in last {
        desktop.xdotool(&["key", &x_keys(control)[0]]);
        desktop.wait(control.id, || !desktop.has_window());
    }
}

/// The texts that are shown two seconds after a control was used.
fn texts_after(desktop: &Desktop, id: &str) -> Vec<String> {
    answer(desktop, control_named(id).unwrap());
    std::thread::sleep(Duration::from_secs(2));
    places(desktop)
        .into_iter()
        .map(|place| place.text)
        .collect()
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_fall_ends_a_journey_and_a_journey_ends_a_fall() {
    let desktop = open_watched("");
    let says = |texts: &[String], words: &str| texts.iter().any(|text| text.contains(words));
    let journey = texts_after(&desktop, "journey.fly");
    assert!(says(&journey, "Journey, "), "{journey:?}");
    let fall = texts_after(&desktop, "motion.let_go");
    assert!(says(&fall, "falling freely"), "{fall:?}");
    assert!(!says(&fall, "Journey, "), "{fall:?}");
    assert!(!says(&fall, "by hand"), "{fall:?}");
    let journey = texts_after(&desktop, "journey.again");
    assert!(says(&journey, "Journey, "), "{journey:?}");
    assert!(!says(&journey, "falling freely"), "{journey:?}");
    assert!(!says(&journey, "by hand"), "{journey:?}");
}

/// The luminance of a colour (WCAG 2.2, relative luminance).
fn luminance(colour: [u8; 3]) -> f64 {
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
fn contrast(a: f64, b: f64) -> f64 {
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// A text with its pixels.
#[derive(PartialEq)]
struct Place {
    x: Range<usize>,
    y: Range<usize>,
    text: String,
}

/// The screen, and the texts that are there before and after it was looked at.
fn texts_on_screen(desktop: &Desktop) -> (Vec<Place>, Shot) {
    let mut before = places(desktop);
    // A frame is on the screen some time after its texts were reported.
    desktop.frames(2);
    let shot = desktop.shot();
    let after = places(desktop);
    before.retain(|place| after.contains(place));
    (before, shot)
}

/// Where the texts are, as the program reports them.
fn places(desktop: &Desktop) -> Vec<Place> {
    let before = desktop.stderr().len();
    desktop.press("KP_Insert");
    desktop.wait("places", || {
        desktop.stderr()[before..].contains("places end")
    });
    let stderr = desktop.stderr();
    let first = stderr[before..].split("places end").next().unwrap_or("");
    let places = first.lines().filter_map(|line| {
        let mut parts = line.split_once("place\u{1f}")?.1.split(BETWEEN);
        let mut number = || parts.next()?.parse::<f32>().ok();
        let [x0, y0, x1, y1] = [number()?, number()?, number()?, number()?];
        Some(Place {
            x: x0 as usize..x1.ceil() as usize,
            y: y0 as usize..y1.ceil() as usize,
            text: parts.next()?.to_owned(),
        })
    });
    places.collect()
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn texts_over_any_picture_have_a_contrast_of_at_least_four_and_a_half() {
    // A text that fades away is not meant to be read.
    let desktop = open_watched("reduced_motion = true\n");
    // The disks of presets 2 and 4 move, until slash pauses them.
    desktop.press("2");
    desktop.press("slash");
    // A picture, and what is pressed over it: for a title, a message and what is switched off; and
    // for a legend.
    for (key, over) in [
        ("2", ["2", "z"]),
        ("2", ["2", "b"]),
        ("4", ["4", "z"]),
        ("KP_End", ["v", "z"]),
    ] {
        desktop.press(key);
        desktop.settled(key, |_| true);
        over.iter().for_each(|key| desktop.press(key));
        desktop.frames(2);
        let (places, shot) = texts_on_screen(&desktop);
        let mut faint = Vec::new();
        for Place { x, y, text } in &places {
            let inside = |px: usize, py: usize| {
                // Smoothed letters reach one pixel beyond their outlines.
                places.iter().any(|Place { x, y, .. }| {
                    (x.start - 1..x.end + 1).contains(&px) && (y.start - 1..y.end + 1).contains(&py)
                })
            };
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
            println!("{key}: {worst:.1}:1 {text}");
            if worst < 4.5 {
                faint.push(format!("{worst:.1}:1 {text}"));
            }
        }
        assert!(places.len() > 8, "{} texts with {key}", places.len());
        assert!(faint.is_empty(), "{key}: {faint:?}");
        if key == "KP_End" {
            // Beyond the boxes the picture is white, so the test has tested what it should.
            let white = |px: usize, py: usize| luminance(shot.pixel(px, py)) > 0.85;
            assert!(
                white(4, 806) && white(1436, 806) && white(720, 600),
                "not white"
            );
        }
    }
}
