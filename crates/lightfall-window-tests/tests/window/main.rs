//! The real window on its own display, used as a user would.
#![cfg(target_os = "linux")]
#![allow(
    clippy::print_stderr,
    reason = "what a test says is read beside its result"
)]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod adapter;
mod bare_server;
mod clipboard;
mod comparison;
mod controls;
mod desktop;
mod device_loss;
mod disk_clock;
mod failures;
mod flights;
mod font_folder;
mod gamepad;
mod glyphs;
mod hands;
mod help;
mod inspector;
mod keys;
mod kiosk;
mod latency;
mod layout;
mod layouts;
mod lessons;
mod lost;
mod manager;
mod menu;
mod messages;
mod missions;
mod pasting;
mod pixel_look;
#[path = "../../../lightfall-core/tests/physics/random.rs"]
mod random;
mod rest;
mod safety;
mod session;
mod shot;
#[cfg(feature = "sound")]
mod sound;
mod touch;
mod typing;
mod x_keys;

use desktop::{Desktop, PROGRAM};
use lightfall_core::scene::presets;
use shot::Shot;
use std::process::Command;
use std::time::Duration;

/// A scene that a window draws fast and that comes to rest, for tests about something else than the
/// scene: preset 2's view of a smooth disk without spin.
const PLAIN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/window/plain.toml");

/// Size of the default window, in pixels.
const WINDOW: (usize, usize) = (1440, 810);
/// Height at the bottom in which the read-outs, the keys and the toast are shown, in pixels.
const STATUS_BAR: usize = 150;
/// Height at the top in which a scene's title is shown, in pixels.
const TITLE: usize = 84;

/// Unfolds the section with the scene's texts on the panel's first page. The section of the disk is
/// folded first, because the texts are below it and below the window.
fn unfold_texts(desktop: &Desktop) {
    desktop.click("Disk");
    desktop.click("Name and title");
    desktop.wait_for("the texts", |state| state.field_of("Title").is_some());
}

/// Share of the picture, without the rows of title, read-outs and toast, that differs between two
/// shots.
fn changed(a: &Shot, b: &Shot) -> f64 {
    a.changed(b, 0..a.width, TITLE..a.height - STATUS_BAR)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn keys_do_what_the_help_says_and_never_close_the_window() {
    let mut desktop = Desktop::open(&["--preset", PLAIN]);
    let start = desktop.first_picture();
    let far_left = |shot: &Shot| start.changed(shot, 0..240, TITLE..TITLE + 90);
    let middle = |shot: &Shot| start.changed(shot, 480..960, 270..540);
    // Pixels of the letters at the bottom, which are light grey.
    let letters = |shot: &Shot| {
        let pixels = (WINDOW.1 - 60..WINDOW.1).flat_map(|y| (0..WINDOW.0).map(move |x| (x, y)));
        pixels
            .filter(|&(x, y)| {
                shot.pixel(x, y)
                    .iter()
                    .all(|channel| (190..=245).contains(channel))
            })
            .count()
    };
    assert!(
        letters(&start) > 500,
        "no read-outs: {} pixels of letters",
        letters(&start)
    );

    // The dither pattern stands still: settled() has just seen two equal pictures. Now the keys, each
    // pressed twice (or, for G, four times), which leads back.
    desktop.press("F2");
    let no_disk = desktop.settled("F2", |shot| middle(shot) > 0.2);
    assert!(
        middle(&no_disk) > 4.0 * far_left(&no_disk),
        "F2 changed the sky as much as the disk"
    );
    desktop.press("F2");
    desktop.settled("F2 again", |shot| changed(shot, &start) == 0.0);

    desktop.press("F7");
    let bypassed = desktop.settled("F7", |shot| changed(shot, &start) > 0.1);
    assert!(
        bypassed.colours() > 2 * start.colours(),
        "F7 left the colours quantized"
    );
    desktop.press("F7");
    desktop.settled("F7 again", |shot| changed(shot, &start) == 0.0);

    desktop.press("g");
    let procedural = desktop.settled("G, the article's stars", |shot| {
        changed(shot, &start) > 0.005
    });
    desktop.press("g");
    let grid = desktop.settled("G, grid", |shot| changed(shot, &procedural) > 0.02);
    assert!(far_left(&grid) > 0.02, "G did not change the sky");
    assert!(letters(&grid) > 500, "G removed the read-outs");
    desktop.press("g");
    let dark = desktop.settled("G, off", |shot| changed(shot, &grid) > 0.02);
    assert!(
        (TITLE..TITLE + 80)
            .all(|y| (0..120).all(|x| dark.pixel(x, y).iter().all(|&channel| channel < 32)))
    );
    desktop.press("g");
    desktop.settled("G, stars", |shot| changed(shot, &start) == 0.0);

    // Flying forward makes things larger; looking around moves them; neither key closes the window.
    let radius = desktop.state().number("camera.r");
    desktop.hold("w");
    desktop.wait_for("W", |state| state.number("camera.r") < 0.7 * radius);
    desktop.let_go("w");
    let nearer = desktop.settled("W", |shot| changed(shot, &start) > 0.1);
    desktop.press("Tab");
    desktop.look(90, 0);
    let turned = desktop.settled("Tab and mouse", |shot| changed(shot, &nearer) > 0.05);
    desktop.press("Escape");
    desktop.look(90, 0);
    desktop.settled("Esc frees the mouse", |shot| changed(shot, &turned) < 1e-3);
    assert!(desktop.running(), "Esc closed the program");

    // A preset around a spinning hole. keys.rs loads all of them, and lost.rs looks at others.
    desktop.press("8");
    let preset = presets::find("8").unwrap();
    let scene = preset.scene(&[]).unwrap();
    if scene.disk_moves() {
        desktop.press("slash");
    }
    desktop.wait_for("the preset", |state| state.scene["name"] == preset.name);
    desktop.settled("preset 8", |shot| changed(shot, &turned) > 0.02);
    assert_eq!(desktop.title(), format!("Lightfall: {}", scene.title));
    assert!(desktop.running());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_window_answers_input_while_a_shader_compiles() {
    let desktop = Desktop::open(&["--preset", "2"]);
    let window = desktop.started.elapsed();
    let lit = |shot: &Shot| {
        let pixels =
            (TITLE..WINDOW.1 - STATUS_BAR).flat_map(|y| (0..WINDOW.0).map(move |x| (x, y)));
        pixels
            .filter(|&(x, y)| shot.pixel(x, y).iter().any(|&channel| channel > 100))
            .count()
    };
    desktop.until("first picture", |shot| lit(shot) > 10_000);
    println!(
        "window after {window:.2?}, first picture after {:.2?}",
        desktop.started.elapsed()
    );
    let plain = desktop.settled("rest", |shot| shot.colours() > 50);
    let status_bar =
        |a: &Shot, b: &Shot| a.changed(b, 0..WINDOW.0, WINDOW.1 - STATUS_BAR..WINDOW.1) > 0.0;
    // The wheel changes the speed that the read-outs show. T asks for a method that has not been
    // compiled yet.
    desktop.wheel();
    let usual = desktop.until("the wheel", |shot| status_bar(shot, &plain));
    let before = desktop.settled("rest", |shot| status_bar(shot, &plain));
    desktop.press("t");
    desktop.wheel();
    let busy = desktop.until("the wheel while a shader is made", |shot| {
        status_bar(shot, &before)
    });
    let spinning = desktop.until("the new picture", |shot| changed(shot, &before) > 0.02);
    println!(
        "the wheel is felt after {usual:.2?}, after T {busy:.2?}; the new picture {spinning:.2?} later"
    );
    // Two of the software renderer's slowest frames; a frozen window would wait for the compiler,
    // too.
    assert!(
        busy < Duration::from_secs(5),
        "the window was frozen for {busy:.2?}"
    );
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_window_at_rest_answers_at_once_however_slow_its_scene_is() {
    // The slowest method: some hundred milliseconds a frame on a software renderer, and a window
    // shows a frame two later.
    let slow = [
        "--preset",
        "2",
        "--method",
        "kerr-schild",
        "--spin",
        "0.9",
        "--set",
        "quality.step_scale=0.45",
    ];
    let desktop = Desktop::open(&slow);
    let status_bar =
        |a: &Shot, b: &Shot| a.changed(b, 0..WINDOW.0, WINDOW.1 - STATUS_BAR..WINDOW.1) > 0.0;
    desktop.first_picture();
    let answer = || {
        let before = desktop.settled("rest", |_| true);
        desktop.wheel();
        desktop.until("the wheel", |shot| status_bar(shot, &before))
    };
    // A machine that is busy with other things may still be drawing: it rests once it answers fast.
    let quick = Duration::from_millis(300);
    let rests = (0..10).any(|_| answer() < quick);
    assert!(
        rests,
        "the wheel never takes effect within {quick:?}: the scene camera does not rest"
    );
    let before = desktop.shot();
    let answers: Vec<Duration> = (0..5).map(|_| answer()).collect();
    println!("the wheel is felt after {answers:.2?}");
    assert!(
        answers.iter().any(|&after| after < quick),
        "the wheel is felt after {answers:.2?}"
    );
    assert!(
        changed(&before, &desktop.shot()) == 0.0,
        "the picture changed while nothing did"
    );
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn f11_shows_unfinished_rays_in_magenta() {
    // Twenty steps are too few for most rays.
    let few_steps = [
        "--preset",
        PLAIN,
        "--method",
        "verlet",
        "--set",
        "quality.max_steps=20",
    ];
    let desktop = Desktop::open(&few_steps);
    let magenta = |shot: &Shot| {
        let pixels =
            (TITLE..WINDOW.1 - STATUS_BAR).flat_map(|y| (0..WINDOW.0).map(move |x| (x, y)));
        pixels
            .filter(|&(x, y)| matches!(shot.pixel(x, y), [200..=255, 0..=90, 200..=255]))
            .count()
    };
    let plain = desktop.first_picture();
    assert_eq!(magenta(&plain), 0);
    desktop.press("F11");
    desktop.settled("F11", |shot| magenta(shot) > 10_000);
    desktop.press("F11");
    desktop.settled("F11 again", |shot| changed(shot, &plain) == 0.0);
}

#[test]
#[ignore = "needs a graphics adapter"]
fn without_a_display_the_program_says_so_and_writes_a_picture() {
    for display in [None, Some(":4095")] {
        let folder = tempfile::tempdir().unwrap();
        let mut command = Command::new(PROGRAM);
        command
            .args(["--preset", "3"])
            .current_dir(&folder)
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY");
        if let Some(display) = display {
            command.env("DISPLAY", display);
        }
        let output = command.output().unwrap();
        let (stdout, stderr) = (
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr),
        );
        assert!(output.status.success(), "{stderr}");
        assert!(stderr.contains("no display"), "{stderr}");
        let file = folder.path().join(stdout.trim());
        assert!(file.is_file(), "{stdout:?} does not name a file; {stderr}");
        let picture = image::open(file).unwrap().to_rgb8();
        assert!(
            picture
                .pixels()
                .any(|pixel| pixel.0.iter().all(|&channel| channel > 100)),
            "the picture is dark"
        );
    }
}
