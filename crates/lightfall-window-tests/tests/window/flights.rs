//! The camera flies by itself: the journey, and free motion.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{PLAIN, changed};
use watched::{Place, State};

/// Waits until the picture moves.
fn moves(desktop: &Desktop, why: &str) {
    let before = desktop.shot();
    desktop.until(why, |shot| changed(shot, &before) > 0.02);
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_journey_starts_stops_and_ends_when_the_user_flies() {
    let mut desktop = Desktop::open(&["--preset", PLAIN]);
    let start = desktop.first_picture();
    desktop.press("j");
    moves(&desktop, "J starts no journey");
    desktop.press("j");
    // The journey's disk moves, and its clock goes on.
    desktop.press("slash");
    let stopped = desktop.settled("J again", |shot| changed(shot, &start) > 1e-3);
    desktop.press("j");
    moves(&desktop, "J does not go on");
    desktop.press("s");
    desktop.wait_for("S takes over", |state| state.journey.is_none());
    desktop.press("slash");
    desktop.settled("flying backward takes over", |shot| {
        changed(shot, &stopped) > 0.01
    });
    desktop.press("Return");
    moves(&desktop, "Enter starts no journey");
    desktop.press("j");
    desktop.press("slash");
    let far = desktop.settled("near the journey's start", |shot| {
        changed(shot, &start) > 0.01
    });
    // From 60 r_s the whole of it is small: the lower part of the picture is sky, with no more than
    // a few stars.
    let light = |x: usize, y: usize| far.pixel(x, y).iter().any(|&channel| channel >= 200);
    let edge = |y: usize| (0..1440).filter(|&x| light(x, y)).count() < 30;
    assert!(edge(650) && edge(600), "no view from afar");
    assert!(desktop.running());
}

/// Whether the words of a journey are shown in the lower half of the window, as captions are.
fn has_caption(desktop: &Desktop, state: &State) -> bool {
    let middle = desktop.size().1 as f32 / 2.0;
    let is_caption = |(name, place): &(String, Place)| name == "journey" && place.min[1] > middle;
    state.boxes.iter().any(is_caption)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_journey_shows_its_captions_and_slash_stops_the_camera_until_it_is_pressed_again() {
    let mut desktop = Desktop::open(&["--preset", "2"]);
    desktop.first_picture();
    desktop.press("Return");
    moves(&desktop, "Enter starts no journey");
    // Past the title, to the first caption.
    desktop.press("shift+Right");
    desktop.wait_for("the first caption", |state| has_caption(&desktop, state));
    desktop.press("slash");
    let paused = desktop.settled("slash pauses", |_| has_caption(&desktop, &desktop.state()));
    desktop.later(20);
    // Above the words, which may go.
    let picture = |shot: &Shot| shot.changed(&paused, 0..1440, 80..600);
    assert_eq!(picture(&desktop.shot()), 0.0, "the camera moves on");
    desktop.press("slash");
    desktop.until("slash goes on", |shot| picture(shot) > 0.01);
    assert!(desktop.running());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn an_observer_let_go_falls_through_the_horizon_to_the_end_card_and_backspace_leads_back() {
    // A disk that moves would never rest.
    let disk = "disk.structure=none";
    let desktop = Desktop::open_small(&["--preset", "9", "--spin", "0.9", "--set", disk]);
    let start = desktop.first_picture();
    desktop.press("f");
    moves(&desktop, "F lets nothing go");
    desktop.press("f");
    let held = desktop.settled("F again", |shot| changed(shot, &start) > 1e-3);
    desktop.press("f");
    // Eight times as fast.
    for _ in 0..3 {
        desktop.press("period");
    }
    let has_card = |state: &State| state.boxes.iter().any(|(name, _)| name == "end card");
    desktop.wait_for("the end of the fall", has_card);
    // The next key closes the end card. Esc does nothing else here.
    desktop.press("Escape");
    desktop.wait_for("the card goes", |state| !has_card(state));
    desktop.press("BackSpace");
    desktop.settled("back where it was let go", |shot| {
        changed(shot, &held) == 0.0
    });
    desktop.end_without_error();
}

/// A spinning hole carries the camera around, which turns it on the axes of each new place. Neither the
/// key that faces the hole nor the rule that keeps its edge in view may take this for the hand.
#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_camera_that_falls_around_a_spinning_hole_turns_by_key_and_keeps_the_edge_in_view() {
    // The disk does not move.
    let fields = "camera.r=3 camera.theta_deg=60 disk.structure=none";
    let fields = fields.split(' ').flat_map(|field| ["--set", field]);
    let scene: Vec<_> = ["--preset", "2", "--spin", "0.9"]
        .into_iter()
        .chain(fields)
        .collect();
    let mut desktop = Desktop::open_small(&scene);
    let start = desktop.first_picture();
    desktop.press("y");
    desktop.settled("Y faces the hole", |shot| changed(shot, &start) > 1e-3);
    desktop.press("f");
    // The shadow grows, and only the rule turns the camera to its edge.
    desktop.wait_for("the camera turns to the edge", |state| {
        state.number("camera.pitch_deg") > 15.0
    });
    desktop.press("y");
    desktop.wait_for("the camera faces the hole", |state| {
        state.number("camera.pitch_deg") < 8.0
    });
    let has_card = |state: &State| state.boxes.iter().any(|(name, _)| name == "end card");
    desktop.press("period");
    desktop.wait_for("the end of the fall", has_card);
    // Inside, the key leads to the light first.
    desktop.press("y");
    desktop.wait_for("the camera faces the edge", |state| {
        state.number("camera.pitch_deg") > 50.0
    });
    // The fall is over: F lets nobody go again, and one Backspace leads back.
    desktop.press("f");
    desktop.press("BackSpace");
    desktop.wait_for("back where it was let go", |state| {
        state.number("camera.r") == 3.0
    });
    assert!(desktop.running());
}
