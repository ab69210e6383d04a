//! The ship and its first mission, flown in the window by keys and by a gamepad.

use crate::PLAIN;
use crate::desktop::{Desktop, Setup};
use watched::{Order, Pad, ShipState, State};

/// Time of a frame, in seconds.
const STEP: f64 = 0.1;

fn ship(state: &State) -> &ShipState {
    state.ship.as_ref().expect("someone flies the ship")
}

/// Waits until something is so of the ship.
#[track_caller]
fn wait_for(desktop: &Desktop, what: &str, is_so: impl Fn(&ShipState) -> bool) {
    desktop.wait_for(what, |state| state.ship.as_ref().is_some_and(&is_so));
}

fn has_card(state: &State) -> bool {
    state.boxes.iter().any(|(name, _)| name == "end card")
}

/// Opens the window, and begins the first mission of the list.
fn begin() -> Desktop {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    desktop.press("shift+j");
    desktop.wait_for("the list", |state| state.menu && state.shows("Two burns"));
    desktop.press("Return");
    let begun = desktop.wait_for("the mission with its card", |state| {
        !state.menu && state.ship.is_some() && has_card(state)
    });
    assert_eq!(ship(&begun).mission, ["two-burns", "UnderWay(0)"]);
    assert_eq!(ship(&begun).own_time, 0.0, "the clocks run behind the card");
    assert!((begun.number("camera.r") - 10.0).abs() < 1e-9);
    desktop
}

/// The burns of the first mission, by what begins and ends a push and by what makes time faster or
/// slower.
fn fly_two_burns(desktop: &Desktop, push: impl Fn(bool), change_pace: impl Fn(bool)) {
    push(true);
    wait_for(desktop, "the lowest point comes down", |ship| {
        ship.periapsis.is_some_and(|low| low < 6.05)
    });
    push(false);
    for _ in 0..3 {
        change_pace(true);
    }
    wait_for(desktop, "faster time", |ship| ship.pace == 8.0);
    wait_for(desktop, "the lowest point", |ship| ship.pace == 1.0);
    push(true);
    wait_for(desktop, "the highest point comes down", |ship| {
        ship.apoapsis.is_some_and(|high| high < 7.5)
    });
    // A busy machine lets go some frames late: slower time makes them short.
    push(false);
    for _ in 0..4 {
        change_pace(false);
    }
    wait_for(desktop, "slower time", |ship| ship.pace == 1.0 / 16.0);
    push(true);
    wait_for(desktop, "the highest point is low", |ship| {
        ship.apoapsis.is_some_and(|high| high < 6.1)
    });
    push(false);
    for _ in 0..4 {
        change_pace(true);
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_first_mission_is_flown_by_keys_to_its_goal_and_the_result_is_kept() {
    let desktop = begin();
    // The key that closes the card pushes already.
    let push = |on| {
        if on {
            desktop.hold("w");
        } else {
            desktop.let_go("w");
        }
    };
    fly_two_burns(&desktop, push, |faster| {
        desktop.press(if faster { "period" } else { "comma" });
    });
    let end = desktop.wait_for("success", |state| {
        state
            .ship
            .as_ref()
            .is_some_and(|ship| ship.mission[1] == "Success")
            && state.shows("Reached: Two burns")
    });
    assert!(ship(&end).rapidity_used < 0.06, "{:?}", end.ship);
    let results = desktop.settings().with_file_name("mission-results.csv");
    let rows = std::fs::read_to_string(results).unwrap();
    assert!(rows.contains("\ntwo-burns,reached,"), "{rows}");

    // The list says what was reached, and a mission begins again with a full tank.
    desktop.press("shift+j");
    desktop.wait_for("the list with the result", |state| {
        state.mentions("fuel used 5")
    });
    desktop.press("Escape");
    desktop.press("Escape");
    desktop.press("Return");
    wait_for(&desktop, "the start again", |ship| {
        ship.rapidity_used == 0.0 && ship.mission[1] == "UnderWay(0)"
    });
    // The key leaves the ship, and Backspace the mission.
    desktop.press("shift+f");
    desktop.wait_for("no ship", |state| state.ship.is_none());
    desktop.press("BackSpace");
    desktop.wait_for("the first scene", |state| state.number("camera.r") == 20.0);
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_mission_that_ends_in_the_hole_is_not_reached_and_says_a_hint() {
    let desktop = begin();
    desktop.hold("w");
    // Nothing but the hole ends such a burn.
    wait_for(&desktop, "the fall", |ship| ship.periapsis.is_none());
    desktop.let_go("w");
    for _ in 0..3 {
        desktop.press("period");
    }
    let end = desktop.wait_for("the end", has_card);
    assert_eq!(ship(&end).mission[1], "Ended(Limit(Inner))");
    assert!(end.shows("Not reached: Two burns") && end.mentions("Hint: "));
    let results = desktop.settings().with_file_name("mission-results.csv");
    let rows = std::fs::read_to_string(results).unwrap();
    assert!(rows.contains("\ntwo-burns,missed,0,1,"), "{rows}");
    // A key of the flight that is pressed as it ends leaves the card, and changes nothing.
    desktop.press("period");
    let after = desktop.later(3);
    assert!(has_card(&after) && ship(&after).pace == ship(&end).pace);
    // Back to the start, since no goal was reached.
    desktop.press("BackSpace");
    wait_for(&desktop, "the start", |ship| {
        ship.rapidity_used == 0.0 && ship.mission[1] == "UnderWay(0)"
    });
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_first_mission_is_flown_by_a_gamepad() {
    let desktop = begin();
    desktop.order(&Order::Connect(true));
    let push = |part, on| {
        desktop.order(&Order::Push(part, if on { 1.0 } else { 0.0 }));
    };
    let press = |part| {
        push(part, true);
        desktop.later(3);
        push(part, false);
        desktop.later(3);
    };
    // A closes the card, and holds the orbit; B ends the hold.
    press(Pad::South);
    wait_for(&desktop, "A holds the orbit", |ship| {
        ship.hold.starts_with("Orbit")
    });
    press(Pad::East);
    wait_for(&desktop, "B lets go", |ship| {
        ship.hold.is_empty() && ship.heading.is_empty()
    });
    press(Pad::North);
    wait_for(&desktop, "Y turns the nose", |ship| {
        ship.heading == "Retrograde"
    });
    // It follows what it has turned to.
    desktop.later(20);
    fly_two_burns(
        &desktop,
        |on| push(Pad::RightTrigger2, on),
        |faster| {
            press(if faster {
                Pad::DPadRight
            } else {
                Pad::DPadLeft
            });
        },
    );
    wait_for(&desktop, "success", |ship| ship.mission[1] == "Success");
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_ship_is_held_paused_and_turned_by_keys_and_mouse_and_its_frames_are_pictures_of_presets() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    desktop.press("shift+f");
    desktop.wait_for("the ship", |state| state.ship.is_some());
    // O holds still instead of choosing another observer.
    desktop.press("o");
    wait_for(&desktop, "O", |ship| ship.hold.starts_with("Hover"));
    desktop.later(20);
    let held = desktop.state();
    assert!((held.number("camera.r") - 20.0).abs() < 0.1);
    assert!(ship(&held).acceleration > 0.0);
    desktop.press("slash");
    let paused = desktop.later(3);
    desktop.press("Right");
    let turned = desktop.later(5);
    assert_eq!(ship(&paused).own_time, ship(&turned).own_time);
    assert!(turned.number("camera.yaw_deg") != paused.number("camera.yaw_deg"));
    desktop.press("slash");
    desktop.press("k");
    wait_for(&desktop, "K", |ship| ship.hold.starts_with("Orbit"));
    desktop.press("f");
    wait_for(&desktop, "F", |ship| {
        ship.hold.is_empty() && ship.acceleration == 0.0
    });
    assert_eq!(desktop.state().scene["observer.kind"], "rain");
    // The panel states the error of the flight by every measure.
    desktop.press("p");
    desktop.click("Read-outs");
    desktop.wait_for("the error of the flight", |state| {
        [
            "Stated error",
            "Balance of E",
            "Balance of L",
            "Balance of K'",
        ]
        .iter()
        .all(|row| state.shows(row))
    });
    desktop.press("p");
    // A preset leaves the ship.
    desktop.press("4");
    desktop.wait_for("preset 4", |state| {
        state.ship.is_none() && state.scene["name"] == "close"
    });
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_question_of_a_mission_is_answered_after_its_goals_and_the_answer_is_kept() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    desktop.press("shift+j");
    desktop.wait_for("the list", |state| {
        state.menu && state.shows("The gyroscope")
    });
    for key in ["Down", "Down", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("the mission with its card", |state| {
        state.ship.is_some() && has_card(state)
    });
    for _ in 0..5 {
        desktop.press("period");
    }
    let has_question = |state: &State| state.boxes.iter().any(|(name, _)| name == "question");
    desktop.wait_for("the question", has_question);
    for key in ["8", "0", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("a wrong answer and the hint", |state| {
        state.mentions("It is not 80. Compare the star")
    });
    // The field is empty again, and has the keyboard still.
    for key in ["7", "5", "period", "4", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("the right answer", |state| {
        state.shows("Right: it is 75.4 degrees")
    });
    let results = desktop.settings().with_file_name("mission-results.csv");
    let rows = std::fs::read_to_string(results).unwrap();
    let last = rows.lines().last().unwrap();
    assert!(
        rows.lines().count() == 2
            && last.starts_with("gyroscope,reached,3,")
            && last.contains(",75.4,true,20"),
        "{rows}"
    );
    desktop.click("Close");
    desktop.wait_for("the card with the answer", |state| {
        !has_question(state) && state.shows("Reached: The gyroscope")
    });
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_mission_closes_the_inspector_the_comparison_and_the_photo_mode() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.press("i");
    desktop.press("0");
    desktop.wait_for("the inspector and two sides", |state| {
        state.shows("Ray inspector") && state.comparison == "side by side"
    });
    let begin = || {
        desktop.press("shift+j");
        desktop.wait_for("the list", |state| state.menu && state.shows("Two burns"));
        desktop.press("Return");
        desktop.wait_for("the mission with its card", |state| {
            !state.menu && state.ship.is_some() && has_card(state)
        })
    };
    let begun = begin();
    assert!(!begun.shows("Ray inspector") && begun.comparison.is_empty());
    // Its card would not be seen in the photo mode, and the ship would wait.
    desktop.press("h");
    desktop.wait_for("the photo mode", |state| !has_card(state));
    begin();
    desktop.press("w");
    wait_for(&desktop, "the ship's time", |ship| ship.own_time > 0.0);
    // What was closed stays closed.
    desktop.press("shift+f");
    let left = desktop.wait_for("no ship", |state| state.ship.is_none());
    assert!(!left.shows("Ray inspector") && left.comparison.is_empty());
    desktop.end_without_error();
}

/// The text of the first mission.
pub(crate) fn first_mission() -> String {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../assets/missions/two-burns.toml"
    );
    std::fs::read_to_string(file).unwrap()
}

/// The first mission with another name and title.
fn own_mission(name: &str, title: &str) -> String {
    let changed = first_mission()
        .replacen("name = \"two-burns\"", &format!("name = {name:?}"), 1)
        .replacen("title = \"Two burns\"", &format!("title = {title:?}"), 1);
    assert!(changed.contains(name) && changed.contains(title));
    changed
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn own_missions_begin_from_the_command_line_the_list_and_a_dropped_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let given = path("given.toml");
    std::fs::write(&given, own_mission("given", "From the command line")).unwrap();
    let setup = Setup {
        files: &[
            (
                "missions/listed.toml",
                own_mission("listed", "From the list"),
            ),
            ("missions/wrong.toml", "[[goal]]\n".into()),
        ],
        ..Setup::default()
    };
    let desktop = Desktop::open_with(&setup, &["--preset", given.to_str().unwrap()]);
    let begins = |name: &str, title: &str| {
        let begun = desktop.wait_for(title, |state| {
            has_card(state) && state.shows(title) && state.ship.is_some()
        });
        assert_eq!(ship(&begun).mission, [name, "UnderWay(0)"]);
        assert_eq!(ship(&begun).own_time, 0.0);
    };
    begins("given", "From the command line");
    // The frames before the first picture are too long for a key with Shift.
    desktop.first_picture();
    // The list names the wrong file, and offers the others.
    desktop.press("shift+j");
    desktop.wait_for("the list", |state| {
        state.menu && state.shows("From the list") && state.mentions("wrong.toml: line")
    });
    desktop.click("From the list");
    begins("listed", "From the list");

    let dropped = path("dropped.toml");
    std::fs::write(&dropped, own_mission("dropped", "Dropped")).unwrap();
    desktop.order(&Order::Drop(dropped.clone()));
    begins("dropped", "Dropped");
    // A wrong file says the sentence of `lightfall presets check`, and the mission goes on.
    let wrong = own_mission("dropped", "Dropped").replacen("brief = ", "brieff = ", 1);
    std::fs::write(&dropped, wrong).unwrap();
    desktop.order(&Order::Drop(dropped));
    desktop.wait_for("the fault", |state| {
        state.mentions("dropped.toml: line") && state.mentions("unknown field `brieff`")
    });
    assert_eq!(ship(&desktop.state()).mission[0], "dropped");
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_path_ahead_is_a_line_in_the_picture_until_the_controls_are_left() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    assert_eq!(desktop.state().path_points, 0);
    desktop.order(&Order::Step(STEP));
    desktop.press("shift+f");
    desktop.wait_for("the ship", |state| state.ship.is_some());
    // In an orbit the path leads around the hole, which is seen from prograde.
    desktop.press("k");
    desktop.press("y");
    desktop.press("y");
    let has_path = |state: &State| state.path_points > 10;
    desktop.wait_for("the path", has_path);
    // It stays while light goes straight, and during thrust.
    desktop.press("l");
    desktop.wait_for("no bending", |state| {
        state.scene["effects.lensing"] == false
    });
    desktop.wait_for("the straight path", has_path);
    desktop.press("l");
    desktop.hold("w");
    wait_for(&desktop, "thrust", |ship| ship.acceleration > 0.0);
    desktop.wait_for("the path of thrust", has_path);
    desktop.let_go("w");
    // The map's key hides the map, then the line, then shows both.
    desktop.press("shift+m");
    desktop.press("shift+m");
    desktop.wait_for("no path", |state| state.path_points == 0);
    desktop.press("shift+m");
    desktop.wait_for("the path again", has_path);
    desktop.press("h");
    desktop.wait_for("no path in the photo mode", |state| state.path_points == 0);
    desktop.press("h");
    desktop.wait_for("the path after it", has_path);
    desktop.press("shift+f");
    desktop.wait_for("no ship and no path", |state| {
        state.ship.is_none() && state.path_points == 0
    });
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_preset_key_leaves_a_mission_only_when_it_is_pressed_again() {
    let desktop = begin();
    desktop.press("4");
    desktop.wait_for("the question", |state| {
        state.mentions("4 leaves the mission: press 4 again")
    });
    assert_eq!(ship(&desktop.state()).mission[0], "two-burns");
    // Another preset's key is a first press again.
    desktop.press("5");
    let asked = desktop.wait_for("the other question", |state| {
        state.mentions("5 leaves the mission: press 5 again")
    });
    assert_eq!(ship(&asked).mission[0], "two-burns");
    desktop.press("5");
    desktop.wait_for("preset 5", |state| {
        state.ship.is_none() && state.scene["name"] == "einstein-ring"
    });
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn at_the_controls_the_keys_that_look_and_turn_say_what_they_do_and_the_help_lists_them() {
    let desktop = begin();
    // The help does not begin the mission.
    desktop.press("F1");
    desktop.wait_for("the help before the start", |state| {
        state.shows("At the ship's controls")
    });
    desktop.press("F1");
    let read = desktop.wait_for("the card again", has_card);
    assert_eq!(ship(&read).own_time, 0.0);
    desktop.press("t");
    desktop.wait_for("the look ahead", |state| {
        state.mentions("You look along the nose")
    });
    desktop.press("t");
    desktop.wait_for("the look at the hole", |state| {
        state.mentions("You look at the hole") && state.shows("nose")
    });
    desktop.press("shift+y");
    wait_for(&desktop, "the heading before", |ship| {
        ship.heading == "Prograde"
    });
    desktop.wait_for("the row of headings", |state| {
        state.mentions("hole · [prograde] · retrograde")
    });
    desktop.press("F1");
    desktop.wait_for("the ship's keys", |state| {
        state.shows("At the ship's controls") && state.shows("nose: next heading, back")
    });
    desktop.press("F1");
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_menu_takes_and_leaves_the_ship_and_says_what_missions_teach() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.press("Escape");
    desktop.wait_for("the menu", |state| {
        state.menu && state.shows("Fly the ship")
    });
    for key in ["Down", "Down", "Down", "Down", "Down", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("the ship", |state| !state.menu && state.ship.is_some());
    desktop.press("Escape");
    desktop.wait_for("the menu at the controls", |state| {
        state.shows("Leave the ship") && !state.shows("Fly the ship")
    });
    for key in ["Down", "Down", "Down", "Down", "Down", "Return"] {
        desktop.press(key);
    }
    desktop.wait_for("no ship", |state| !state.menu && state.ship.is_none());
    // The list of missions says what the chosen one teaches, and which lamps are lit: none yet.
    desktop.press("shift+j");
    desktop.wait_for("what the first one teaches", |state| {
        state.mentions("A ship that brakes comes down.") && state.mentions("○○○")
    });
    desktop.press("Down");
    desktop.wait_for("what the second one teaches", |state| {
        state.mentions("Free fall has no weight.")
    });
    desktop.end_without_error();
}
