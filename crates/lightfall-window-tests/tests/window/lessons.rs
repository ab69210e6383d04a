//! Lessons: played by keys to their end, left, and made in the window.

use crate::PLAIN;
use crate::desktop::{Desktop, Setup};
use lightfall_core::scene::Value;
use lightfall_core::scene::journey::{SideBySide, load};
use std::path::PathBuf;
use watched::{Order, State};

/// Time of a frame, in seconds.
const STEP: f64 = 0.05;
/// Frames in which a journey would go on.
const WHILE: u32 = 30;

fn has_box(state: &State, name: &str) -> bool {
    state.boxes.iter().any(|(other, _)| other == name)
}

/// Waits for the card of a stop, e.g. `2 of 7`.
#[track_caller]
fn wait_for_stop(desktop: &Desktop, which: &str) -> State {
    desktop.wait_for(which, |state| {
        has_box(state, "stop") && state.mentions(&format!("· {which}"))
    })
}

fn is_on(state: &State, key: &str) -> bool {
    state.scene[key] == true
}

/// Begins the lesson at this place in the list.
fn begin_from_menu(desktop: &Desktop, place: usize) {
    desktop.press("Escape");
    desktop.wait_for("the menu", |state| state.menu && state.shows("Lessons"));
    for key in ["Down", "Down", "Down", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("the list", |state| {
        state.menu && state.shows("What is the shadow?") && state.shows("Save my lesson")
    });
    for _ in 0..place {
        desktop.press("Down");
    }
    desktop.press("Return");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_lesson_is_played_by_keys_to_its_end_and_what_it_has_switched_is_put_back() {
    let mut desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    begin_from_menu(&desktop, 1);
    let first = wait_for_stop(&desktop, "1 of 7");
    assert_eq!(first.scene["name"], "above");
    assert_eq!(first.scene["disk.structure"], "none");
    // The journey waits, however long it takes.
    let later = desktop.later(WHILE);
    assert_eq!((first.journey, later.journey), (Some(0.0), Some(0.0)));
    // Space goes on, and does not fly.
    desktop.press("space");
    let second = wait_for_stop(&desktop, "2 of 7");
    assert!(second.journey == Some(1.0) && (second.number("camera.theta_deg") - 80.0).abs() < 1e-9);
    desktop.wait_for("the ray of the stop", |state| {
        state.shows("Ray inspector") && state.mentions("g 1.302")
    });
    // So does the key of a presenter's remote.
    desktop.press("Next");
    wait_for_stop(&desktop, "3 of 7");
    desktop.wait_for("its ray", |state| state.mentions("g 0.5745"));
    desktop.press("Next");
    wait_for_stop(&desktop, "4 of 7");
    let compared = desktop.wait_for("two pictures", |state| state.comparison == "two pictures");
    assert!(!is_on(&compared, "effects.beaming") && !compared.shows("Ray inspector"));
    // Back, as it was there.
    desktop.press("Prior");
    wait_for_stop(&desktop, "3 of 7");
    let back = desktop.wait_for("one picture", |state| state.comparison.is_empty());
    assert!(is_on(&back, "effects.beaming") && back.shows("Ray inspector"));
    for which in ["4 of 7", "5 of 7", "6 of 7"] {
        desktop.press("Next");
        wait_for_stop(&desktop, which);
    }
    assert_eq!(desktop.state().scene["view"], "redshift");
    // On the way, the key shows the next stop at once.
    desktop.press("Next");
    desktop.press("Next");
    let last = wait_for_stop(&desktop, "7 of 7");
    assert_eq!(last.scene["view"], "colour");
    // A number needs no click on its field: its digits load no presets.
    for key in ["8", "8", "8", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("a hint", |state| {
        state.mentions("It is not 888. Put r = 6 into the formula.")
    });
    // The field is empty again, and Enter alone is no answer. Each digit comes behind the one before it,
    // however slowly they are typed.
    desktop.press("Return");
    for key in ["0", "period", "8", "8", "9"] {
        desktop.press(key);
        desktop.later(3);
    }
    desktop.press("Return");
    desktop.wait_for("the right answer", |state| {
        state.mentions("Right: it is 0.8885")
    });
    // After the right answer Enter goes on, and does not begin the lesson again.
    desktop.press("Return");
    let end = desktop.wait_for("the end card", |state| has_box(state, "end card"));
    assert!(end.journey.is_none() && !has_box(&end, "stop"));
    assert!(
        end.mentions("0 of 2 questions right at once, 1 after more tries, 1 not solved.")
            && end.mentions("Next lesson: Falling in, and the two clocks")
    );
    let results = desktop.settings().with_file_name("lesson-results.csv");
    let rows = std::fs::read_to_string(results).unwrap();
    // Behind the tries come the time, which differs, and the pupil, whom nobody has named.
    let starts = [
        "lesson,question,answer,is_right,tries,time,pupil",
        "Why is one side brighter?,2,888,false,1,20",
        "Why is one side brighter?,2,0.889,true,2,20",
    ];
    assert_eq!(rows.lines().count(), starts.len(), "{rows}");
    for (row, start) in rows.lines().zip(starts) {
        assert!(row.starts_with(start), "{row}");
    }
    assert!(rows.ends_with("Z,\n"), "{rows}");
    // The last picture stays until the card is closed.
    assert_eq!(end.scene["disk.structure"], "none");
    desktop.press("Escape");
    desktop.wait_for("the preset's own fields", |state| {
        state.scene["disk.structure"] == "turbulent" && state.scene["sky.mode"] == "stars"
    });
    desktop.press("BackSpace");
    desktop.wait_for("the first scene", |state| state.scene["name"] == "edge-on");
    assert!(
        desktop.running() && !desktop.stderr().contains("ERROR"),
        "{}",
        desktop.stderr()
    );
}

/// A lesson with this title, which has one stop.
fn short_lesson(title: &str) -> String {
    format!(
        "schema = 1\ntitle = \"{title}\"\n[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 1\nr = 18\n\
         [[stop]]\nat = 0\ncaption = \"Look.\"\n"
    )
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_card_at_the_end_of_a_lesson_begins_the_next_one_by_its_key_and_by_a_click() {
    let files = [
        ("lessons/a.toml", short_lesson("Alpha")),
        ("lessons/b.toml", short_lesson("Beta")),
        ("lessons/c.toml", short_lesson("Gamma")),
    ];
    let setup = Setup {
        files: &files,
        ..Setup::default()
    };
    let desktop = Desktop::open_with(&setup, &["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    desktop.press("Escape");
    desktop.wait_for("the menu", |state| state.menu && state.shows("Lessons"));
    for key in ["Down", "Down", "Down", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("the list", |state| state.menu && state.shows("Alpha"));
    desktop.click("Alpha");
    let to_end = |name: &str| {
        desktop.wait_for(name, |state| {
            has_box(state, "stop") && state.mentions(&format!("{name} · 1 of 1"))
        });
        desktop.press("Next");
        desktop.wait_for("the end card", |state| has_box(state, "end card"))
    };
    to_end("Alpha");
    desktop.wait_for("the next lesson", |state| {
        state.mentions("Next lesson: Beta")
    });
    desktop.press("j");
    to_end("Beta");
    desktop.click("Next lesson");
    to_end("Gamma");
    let last = desktop.wait_for("the words of the last card", |state| {
        state.shows("Fly it again")
    });
    assert!(!last.mentions("Next lesson"), "{:?}", last.texts);
    desktop.end_without_error();
}

/// A lesson that is flown in the scene that is shown.
const PLAIN_LESSON: &str = "schema = 1\ntitle = \"Plain\"\n[[keyframe]]\ntime = 0\nr = 20\n[[keyframe]]\ntime = 2\nr = 15\n\
    [[stop]]\nat = 0\ncaption = \"\"\"\nFirst line.\nSecond line.\"\"\"\neffects.doppler = false\nguides = true\n\
    [[stop]]\nat = 1\nview = \"classes\"\n";

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn at_a_stop_the_hands_have_the_camera_and_leaving_puts_back_what_stops_switched() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("plain-lesson.toml");
    std::fs::write(&file, PLAIN_LESSON).unwrap();
    let desktop = Desktop::open_small(&["--preset", PLAIN, "--journey", file.to_str().unwrap()]);
    desktop.order(&Order::Step(STEP));
    let first = wait_for_stop(&desktop, "1 of 2");
    assert!(first.shows("First line.") && !is_on(&first, "effects.doppler"));
    desktop.wait_for("the guides", |state| state.shows("edge of the shadow"));
    // Keys still switch, and the camera flies, while the lesson waits.
    desktop.press("x");
    desktop.wait_for("no beaming", |state| !is_on(state, "effects.beaming"));
    desktop.hold("w");
    desktop.wait_for("W", |state| state.number("camera.r") < 19.0);
    desktop.let_go("w");
    let flown = desktop.later(WHILE);
    assert!(has_box(&flown, "stop") && flown.journey == Some(0.0));
    // The lesson goes on from there, gently.
    desktop.press("space");
    let second = wait_for_stop(&desktop, "2 of 2");
    assert_eq!(second.scene["view"], "classes");
    assert!(!is_on(&second, "effects.doppler") && !is_on(&second, "effects.beaming"));
    // Leaving puts back what the stops have switched, and not what the hand has.
    desktop.press("j");
    let left = desktop.wait_for("J leaves", |state| {
        state.journey.is_none()
            && is_on(state, "effects.doppler")
            && state.scene["view"] == "colour"
    });
    assert!(!is_on(&left, "effects.beaming"));
    desktop.wait_for("no guides", |state| !state.shows("edge of the shadow"));
    // J goes on at the stop where it was left.
    desktop.press("j");
    let again = wait_for_stop(&desktop, "2 of 2");
    assert_eq!(again.scene["view"], "classes");
    // Another scene ends the lesson, and is as it is.
    desktop.press("4");
    let other = desktop.wait_for("preset 4", |state| {
        state.journey.is_none() && state.scene["name"] == "close"
    });
    assert!(is_on(&other, "effects.doppler") && !has_box(&other, "stop"));
    assert!(!desktop.stderr().contains("ERROR"), "{}", desktop.stderr());
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_lesson_made_by_keys_is_saved_and_plays_again() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    let file = |number: u32| -> PathBuf {
        let folder = desktop.settings().with_file_name("lessons");
        folder.join(format!("lesson-{number}.toml"))
    };
    desktop.press("ctrl+l");
    desktop.wait_for("nothing to save", |state| {
        state.shows("The lesson has no stop yet")
    });
    desktop.press("shift+l");
    let noted = desktop.wait_for("the first stop", |state| {
        state.shows("Stop 1 of your lesson")
    });
    assert!(noted.mentions(file(1).to_str().unwrap()) && !file(1).exists());
    for key in ["z", "0", "F10"] {
        desktop.press(key);
    }
    desktop.hold("w");
    desktop.wait_for("W", |state| state.number("camera.r") < 18.0);
    desktop.let_go("w");
    desktop.later(5);
    let second = desktop.press("shift+l");
    desktop.wait_for("the second stop", |state| {
        state.shows("Stop 2 of your lesson")
    });
    desktop.press("ctrl+l");
    desktop.wait_for("saved", |state| state.shows("Saved: "));
    let text = std::fs::read_to_string(file(1)).unwrap();
    let journey = load("lesson-1.toml", &text).unwrap();
    let [_, stop] = journey.stops.as_slice() else {
        panic!("{text}")
    };
    assert_eq!(stop.fields, [("effects.doppler", Value::Boolean(false))]);
    assert_eq!(
        (stop.guides, stop.side_by_side),
        (Some(true), Some(SideBySide::Divided))
    );

    // A file that was edited since is somebody's own: the lesson goes into another one.
    let edited = text.replacen("caption = \"\"", "caption = \"What do you see?\"", 1);
    std::fs::write(file(1), &edited).unwrap();
    desktop.press("shift+l");
    desktop.wait_for("the third stop", |state| {
        state.shows("Stop 3 of your lesson")
    });
    desktop.press("ctrl+l");
    desktop.wait_for("saved again", |state| state.mentions("lesson-2.toml"));
    assert_eq!(std::fs::read_to_string(file(1)).unwrap(), edited);
    assert_eq!(
        load("2", &std::fs::read_to_string(file(2)).unwrap())
            .unwrap()
            .stops
            .len(),
        3
    );

    // After the three built-in ones and a flight comes the lesson, with the caption that was written.
    desktop.press("4");
    desktop.wait_for("another scene", |state| state.scene["name"] == "close");
    begin_from_menu(&desktop, 4);
    let begun = wait_for_stop(&desktop, "1 of 2");
    assert!(begun.shows("What do you see?") && is_on(&begun, "effects.doppler"));
    desktop.press("space");
    let played = wait_for_stop(&desktop, "2 of 2");
    assert!(!is_on(&played, "effects.doppler") && played.comparison == "side by side");
    let places = [&played, &second].map(|state| state.number("camera.r"));
    assert!((places[0] - places[1]).abs() < 1e-6, "{places:?}");
    assert!(!desktop.stderr().contains("ERROR"), "{}", desktop.stderr());
}

/// A lesson's file opens as a mission's does.
#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_lesson_begins_from_the_command_lines_preset_and_from_a_dropped_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("plain-lesson.toml");
    std::fs::write(&file, PLAIN_LESSON).unwrap();
    let desktop = Desktop::open_small(&["--preset", file.to_str().unwrap()]);
    desktop.order(&Order::Step(STEP));
    let first = wait_for_stop(&desktop, "1 of 2");
    assert!(first.shows("First line.") && !is_on(&first, "effects.doppler"));
    desktop.press("j");
    desktop.wait_for("J leaves", |state| {
        state.journey.is_none() && is_on(state, "effects.doppler")
    });
    // An inspector from before the lesson does not cover it.
    desktop.press("i");
    desktop.wait_for("the inspector", |state| state.shows("Ray inspector"));
    desktop.order(&Order::Drop(file));
    let dropped = wait_for_stop(&desktop, "1 of 2");
    assert!(!is_on(&dropped, "effects.doppler"));
    desktop.wait_for("no inspector", |state| !state.shows("Ray inspector"));
    // Who leaves the lesson has it again.
    desktop.press("j");
    desktop.wait_for("the inspector again", |state| state.shows("Ray inspector"));
    assert!(!desktop.stderr().contains("ERROR"), "{}", desktop.stderr());
}
