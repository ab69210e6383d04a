//! What is looked at where one press of a key is not enough to see its effect.

use crate::session::Session;
use std::path::PathBuf;
use watched::State;

/// The share by which the radius grows in a frame while these keys and the one for flying backward
/// are held: outward flight is the same from the hole's neighbourhood to far away.
fn speed(session: &Session, held: &[&str]) -> f64 {
    const FRAMES: u32 = 10;
    let start = session.show_first_scene();
    for key in held {
        session.hold(key);
    }
    session.hold("s");
    let moves = |state: &State| state.number("camera.r") > start.number("camera.r");
    let first = session.wait_for("the flight", moves);
    let last = session.wait_for("some frames of it", |state| {
        state.frame >= first.frame + FRAMES
    });
    session.let_go("s");
    for key in held {
        session.let_go(key);
    }
    let growth = (last.number("camera.r") / first.number("camera.r")).ln();
    growth / f64::from(last.frame - first.frame)
}

/// How much faster the camera flies while a key is held, as the mean over frames that are not quite
/// alike.
fn gear(session: &Session, key: &str) -> f64 {
    speed(session, &[key]) / speed(session, &[])
}

pub fn faster(session: &mut Session, key: &str) {
    let gear = gear(session, key);
    assert!((3.0..5.0).contains(&gear), "{key}: {gear} times as fast");
}

pub fn slower(session: &mut Session, key: &str) {
    let gear = gear(session, key);
    assert!((0.2..0.33).contains(&gear), "{key}: {gear} times as fast");
}

pub fn undo(session: &mut Session, key: &str) {
    let before = session.show_first_scene();
    session.press("F2");
    session.wait_for("no disk", |state| state.scene["disk.enabled"] == false);
    session.press(key);
    session.wait_for(key, |state| state.scene == before.scene);
}

/// The camera faces the hole already, so the key turns it away, within some frames.
pub fn face(session: &mut Session, key: &str) {
    session.press(key);
    session.wait_for(key, |state| state.number("camera.yaw_deg").abs() > 179.0);
    session.press(key);
    session.wait_for(key, |state| state.number("camera.yaw_deg").abs() < 1.0);
}

/// Drags the picture to the right.
fn drag(session: &Session) {
    session.point(300, 200);
    session.later(3);
    session.xdotool(&["mousedown", "1"]);
    session.later(3);
    session.look(60, 0);
    session.later(3);
    session.xdotool(&["mouseup", "1"]);
    session.later(3);
}

/// With the orbit camera a drag moves the camera around the hole; without it, the camera turns.
pub fn orbit(session: &mut Session, key: &str) {
    let start = session.state();
    session.press(key);
    session.wait_for(key, |state| state.shows("Orbit camera ·"));
    // The camera turns to the hole first.
    session.later(20);
    drag(session);
    let around = session.state();
    let [r, phi] = ["camera.r", "camera.phi_deg"].map(|key| around.number(key) - start.number(key));
    assert!(
        r == 0.0 && phi.abs() > 10.0,
        "{key}: {r} r_s, {phi} degrees"
    );
    session.press(key);
    session.wait_for(key, |state| !state.shows("Orbit camera ·"));
    let free = session.show_first_scene();
    drag(session);
    let turned = session.state().changed_since(&free);
    assert!(
        turned.contains_key("camera.yaw_deg") && !turned.contains_key("camera.phi_deg"),
        "{key}: {turned:?}"
    );
}

pub fn mouse_look(session: &mut Session, key: &str) {
    let turns = |session: &Session| {
        let before = session.state();
        session.look(60, 0);
        let after = session.later(4);
        (after.number("camera.yaw_deg") - before.number("camera.yaw_deg")).abs() > 1.0
    };
    assert!(!turns(session));
    session.press(key);
    session.wait_for(key, |state| state.grabs_mouse);
    assert!(turns(session), "{key}: the mouse does not look around");
    session.press(key);
    session.wait_for(key, |state| !state.grabs_mouse);
    assert!(!turns(session), "{key}: the mouse still looks around");
}

/// Only the picture stays: the read-outs go, and come back.
pub fn photo_mode(session: &mut Session, key: &str) {
    let has_read_outs = |state: &State| state.texts.iter().any(|text| text.words.ends_with(" r_s"));
    session.wait_for("read-outs", has_read_outs);
    session.press(key);
    session.wait_for(key, |state| !has_read_outs(state));
    session.press(key);
    session.wait_for(key, has_read_outs);
}

/// The complete pictures in the folder for them.
fn pictures(session: &Session) -> Vec<PathBuf> {
    let folder = session.home.path().join("Pictures");
    let files = std::fs::read_dir(folder).unwrap();
    let files = files.map(|entry| entry.unwrap().path());
    files.filter(|file| image::open(file).is_ok()).collect()
}

pub fn screenshot(session: &mut Session, key: &str) {
    let before = pictures(session).len();
    session.press(key);
    session.wait(key, || pictures(session).len() == before + 1);
    session.wait_for("the path", |state| state.mentions(".png"));
    // Another message takes the place of this one.
    session.press("g");
}

pub fn compare(session: &mut Session, key: &str) {
    for shown in ["side by side", "two pictures", ""] {
        session.press(key);
        session.wait_for(key, |state| state.comparison == shown);
    }
}

pub fn difference(session: &mut Session, key: &str) {
    for gain in [16, 64] {
        session.press(key);
        let wanted = format!("difference times {gain}");
        session.wait_for(key, |state| state.comparison == wanted);
    }
    // Back to the two sides, to two pictures, and to one.
    for _ in 0..3 {
        session.press("0");
    }
    session.wait_for("one picture", |state| state.comparison.is_empty());
}

/// The factor by which a key changes the pace of a fall.
fn change_of_pace(session: &Session, key: &str) -> f64 {
    let before = session.press("f");
    assert!(before.falls);
    let after = session.press(key);
    session.press("f");
    session.wait_for("the end of the fall", |state| !state.falls);
    after.pace / before.pace
}

/// A view that the method in use, or a disk without thickness, leaves empty is refused with the reason.
pub fn empty_view(session: &mut Session, key: &str) {
    let before = session.state();
    session.press(key);
    let after = session.wait_for(key, |state| state.mentions("has nothing to show"));
    assert_eq!(after.scene, before.scene);
    // Another message takes the place of this one.
    session.press("F10");
    session.press("F10");
    session.wait_for("another message", |state| {
        !state.mentions("nothing to show")
    });
}

/// The map is there at the controls of the ship.
pub fn map(session: &mut Session, key: &str) {
    let has_map = |state: &State| state.boxes.iter().any(|(name, _)| name == "map");
    session.press("shift+f");
    session.wait_for("the map", has_map);
    session.press(key);
    session.wait_for(key, |state| {
        !has_map(state) && state.shows("Map: hidden; the path stays in the picture")
    });
    session.press(key);
    session.wait_for(key, |state| state.shows("Map and path: hidden"));
    session.press(key);
    session.wait_for(key, has_map);
    session.press("shift+f");
    session.wait_for("the end of the flight", |state| state.ship.is_none());
}

pub fn missions(session: &mut Session, key: &str) {
    session.press(key);
    session.wait_for(key, |state| state.menu && state.shows("Two burns"));
    session.press("Escape");
    session.press("Escape");
    session.wait_for("the menu's end", |state| !state.menu);
}

pub fn slower_time(session: &mut Session, key: &str) {
    assert_eq!(change_of_pace(session, key), 0.5, "{key}");
}

pub fn faster_time(session: &mut Session, key: &str) {
    assert_eq!(change_of_pace(session, key), 2.0, "{key}");
}

/// Seconds along the journey, which is flown.
fn time(state: &State) -> f64 {
    state.journey.unwrap()
}

/// Starts the journey, lets it stand still, and goes ahead in it by 15 seconds.
fn start_paused_journey(session: &Session) -> State {
    session.press("j");
    session.wait_for("the journey", |state| state.journey.is_some());
    session.press("slash");
    for _ in 0..3 {
        session.press("shift+Right");
    }
    session.wait_for("15 seconds more", |state| {
        state.journey.is_some_and(|time| time > 15.0)
    })
}

/// Ends the journey, and what is paused with it.
fn end_journey(session: &Session) {
    session.press("slash");
    session.press("j");
    session.wait_for("the journey's end", |state| state.journey.is_none());
}

pub fn journey_again(session: &mut Session, key: &str) {
    start_paused_journey(session);
    session.press(key);
    session.wait_for(key, |state| state.journey.is_some_and(|time| time < 5.0));
    end_journey(session);
}

/// The seconds by which a key moves a journey that stands still.
fn skip(session: &Session, key: &str) -> f64 {
    let before = start_paused_journey(session);
    let after = session.press(key);
    end_journey(session);
    time(&after) - time(&before)
}

pub fn journey_back(session: &mut Session, key: &str) {
    let skipped = skip(session, key);
    assert!((skipped + 5.0).abs() < 1e-9, "{key}: {skipped} seconds");
}

pub fn journey_ahead(session: &mut Session, key: &str) {
    let skipped = skip(session, key);
    assert!((skipped - 5.0).abs() < 1e-9, "{key}: {skipped} seconds");
}

pub fn pause(session: &mut Session, key: &str) {
    session.press("j");
    let start = session.wait_for("the journey", |state| state.journey.is_some());
    session.wait_for("its flight", |state| {
        state.journey.is_some_and(|now| now > time(&start))
    });
    let paused = time(&session.press(key));
    assert_eq!(time(&session.later(5)), paused, "{key}");
    session.press(key);
    session.wait_for(key, |state| state.journey.is_some_and(|now| now > paused));
    session.press("j");
    session.wait_for("the journey's end", |state| state.journey.is_none());
}

pub fn quit(session: &mut Session, key: &str) {
    session.press_at_once(key);
    let status = session.ended();
    assert!(status.success(), "{key}: {}", session.stderr());
}

pub fn add_stop(session: &mut Session, key: &str) {
    session.press(key);
    session.wait_for(key, |state| state.shows("Stop 1 of your lesson is noted"));
}

/// The control before has added a stop.
pub fn save_lesson(session: &mut Session, key: &str) {
    session.press(key);
    session.wait_for(key, |state| state.shows("Saved: "));
    let file = session.settings().with_file_name("lessons/lesson-1.toml");
    assert!(file.is_file(), "{key}: {} is not there", file.display());
}
