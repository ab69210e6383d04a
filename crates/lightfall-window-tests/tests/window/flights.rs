//! The camera flies by itself: the journey, and free motion.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{PLAIN, changed};

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

/// Whether a caption is on the screen: light letters on a dark box above the toast.
fn has_caption(shot: &Shot) -> bool {
    let pixels = (655..688).flat_map(|y| (560..880).map(move |x| (x, y)));
    let (mut letters, mut dark, mut all) = (0, 0, 0);
    for (x, y) in pixels {
        let channels = shot.pixel(x, y);
        letters += usize::from(channels.iter().all(|channel| *channel > 225));
        dark += usize::from(channels.iter().all(|channel| *channel < 45));
        all += 1;
    }
    // Letters of this size cover from 5 to 30 % of their lines.
    letters * 50 > all && dark * 2 > all
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_journey_shows_its_captions_and_slash_stops_the_camera_until_it_is_pressed_again() {
    let mut desktop = Desktop::open(&["--preset", "2"]);
    let start = desktop.first_picture();
    assert!(!has_caption(&start), "a caption without a journey");
    desktop.press("Return");
    moves(&desktop, "Enter starts no journey");
    // Past the title, to the first caption.
    desktop.press("shift+Right");
    desktop.until("the first caption", has_caption);
    desktop.press("slash");
    let paused = desktop.settled("slash pauses", has_caption);
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
    let mut desktop = Desktop::open_small(&["--preset", "9", "--spin", "0.9", "--set", disk]);
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
    let end = desktop.settled("the end of the fall", |shot| changed(shot, &held) > 0.01);
    // The next key closes the end card, which covers the middle. Esc does nothing else here.
    desktop.press("Escape");
    // The picture behind the card is black, as the card is: only its text changes.
    desktop.settled("the card goes", |shot| {
        shot.changed(&end, 156..596, 156..266) > 0.02
    });
    desktop.press("BackSpace");
    desktop.settled("back where it was let go", |shot| {
        changed(shot, &held) == 0.0
    });
    assert!(
        desktop.running() && !desktop.stderr().contains("ERROR"),
        "{}",
        desktop.stderr()
    );
}
