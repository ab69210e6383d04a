//! Fingers on the window, without a touch screen.

use crate::PLAIN;
use crate::desktop::Desktop;
use crate::missions::first_mission;
use watched::{Order, ShipState, State, Stroke, Text};

/// Time of a frame, in seconds.
const STEP: f64 = 0.05;
/// Frames after which egui has seen a finger, and what it leads to is shown.
const FRAMES: u32 = 4;
/// Steps of a way.
const STEPS: usize = 10;
/// A place of the picture where nothing else is, in points.
const FREE: [f32; 2] = [300.0, 200.0];

impl Desktop {
    /// Puts fingers down, moves each along its way, and lifts them. Returns the state after that.
    #[track_caller]
    fn drag_fingers<const N: usize>(&self, ways: [impl Fn(f32) -> [f32; 2]; N]) -> State {
        for (id, way) in (0..).zip(&ways) {
            self.give(&Order::Touch(id, Stroke::Down, way(0.0)));
        }
        for step in 1..=STEPS {
            for (id, way) in (0..).zip(&ways) {
                let place = way(step as f32 / STEPS as f32);
                self.give(&Order::Touch(id, Stroke::Move, place));
            }
        }
        for (id, way) in (0..).zip(&ways) {
            self.order(&Order::Touch(id, Stroke::Up, way(1.0)));
        }
        self.later(FRAMES)
    }

    /// Taps with a finger, which egui sees before it is lifted.
    #[track_caller]
    fn tap(&self, place: [f32; 2]) -> State {
        self.order(&Order::Touch(0, Stroke::Down, place));
        self.later(FRAMES);
        self.order(&Order::Touch(0, Stroke::Up, place));
        self.later(FRAMES)
    }

    /// The state once the scene does not change any more.
    #[track_caller]
    fn still_scene(&self) -> State {
        loop {
            let [before, after] = [self.state(), self.later(FRAMES)];
            if before.scene == after.scene {
                return after;
            }
        }
    }

    /// Taps the picture, and then a button of the bar that opens.
    #[track_caller]
    fn use_bar(&self, button: &str) {
        self.tap(FREE);
        let state = self.wait_for(button, |state| state.place_of(button).is_some());
        self.later(FRAMES);
        self.tap(state.place_of(button).unwrap());
        // The menu and the read-outs have some of the buttons' words, too.
        let last = |text: &Text| ["Photo", "End photo mode"].contains(&text.words.as_str());
        self.wait_for("no bar", |state| !state.texts.iter().any(last));
    }
}

fn straight(from: [f32; 2], to: [f32; 2]) -> impl Fn(f32) -> [f32; 2] {
    move |share| [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
}

/// The ways of two fingers that end twice as far apart as they begin.
fn apart() -> [impl Fn(f32) -> [f32; 2]; 2] {
    [-50.0, 50.0].map(|from| straight([FREE[0] + from, FREE[1]], [FREE[0] + 2.0 * from, FREE[1]]))
}

fn change(field: &str, [before, after]: [&State; 2]) -> f64 {
    after.number(field) - before.number(field)
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_finger_looks_around_and_two_pinch_and_turn_the_picture() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    let start = desktop.order(&Order::Step(STEP));
    let [_, height] = [desktop.size().0, desktop.size().1].map(|side| side as f32);

    // The picture follows the finger to the right, so the camera turns left, by a quarter of the
    // field of view. The finger rests on its first tenth of the way, and on the fourth that follows.
    let quarter = straight(FREE, [FREE[0] + height / 4.0, FREE[1]]);
    let turned = desktop.drag_fingers([quarter]);
    let share = change("camera.yaw_deg", [&start, &turned]) / start.number("camera.fov_deg");
    assert!((-0.25..-0.15).contains(&share), "{share}");

    // Twice as far apart, less the rest: the field of view of half the pixels' angle.
    let zoomed = desktop.drag_fingers(apart());
    let tangent = |state: &State| (state.number("camera.fov_deg").to_radians() / 2.0).tan();
    let factor = tangent(&turned) / tangent(&zoomed);
    assert!((1.5..2.0).contains(&factor), "{factor}");
    let rolled = change("camera.roll_deg", [&turned, &zoomed]);
    assert!(rolled.abs() < 1e-9, "{rolled}");

    // A right angle clockwise rolls the camera the other way than its key for clockwise.
    let circle = [0.0, std::f32::consts::PI].map(|start: f32| {
        move |share: f32| {
            let (sine, cosine) = (start + share * std::f32::consts::FRAC_PI_2).sin_cos();
            [FREE[0] + 60.0 * cosine, FREE[1] + 60.0 * sine]
        }
    });
    let rolled = desktop.drag_fingers(circle);
    let by_fingers = change("camera.roll_deg", [&zoomed, &rolled]);
    assert!((70.0..90.0).contains(&by_fingers.abs()), "{by_fingers}");
    desktop.hold("e");
    desktop.later(FRAMES);
    desktop.let_go("e");
    let by_key = change("camera.roll_deg", [&rolled, &desktop.later(FRAMES)]);
    assert!(by_key * by_fingers < 0.0, "{by_key} and {by_fingers}");

    // Around the hole the fingers change the distance.
    desktop.press("k");
    let far = desktop.still_scene();
    let near = desktop.drag_fingers(apart());
    let ratio = far.number("camera.r") / near.number("camera.r");
    assert!((1.3..2.2).contains(&ratio), "{ratio}");
    assert_eq!(change("camera.fov_deg", [&far, &near]), 0.0);
    assert!(!near.shows("Places"), "a drag opened the bar");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_tap_opens_a_bar_that_goes_away_when_it_is_used_or_the_picture_is_tapped_again() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    let start = desktop.order(&Order::Step(STEP));
    assert!(!start.shows("Places"));

    desktop.tap(FREE);
    desktop.wait_for("the bar", |state| state.shows("Places"));
    desktop.tap(FREE);
    let closed = desktop.wait_for("no bar", |state| !state.shows("Places"));
    assert_eq!(closed.scene, start.scene);

    desktop.use_bar("Fall");
    desktop.wait_for("the fall", |state| state.falls);
    desktop.use_bar("Hold");
    desktop.wait_for("the end of the fall", |state| !state.falls);

    desktop.use_bar("Journey");
    desktop.wait_for("the journey", |state| state.journey.is_some());
    desktop.use_bar("Stop");
    desktop.wait_for("no journey", |state| state.journey.is_none());

    desktop.use_bar("Menu");
    let menu = desktop.wait_for("the menu", |state| state.menu && state.shows("Resume"));
    desktop.later(FRAMES);
    desktop.tap(menu.place_of("Resume").unwrap());
    desktop.wait_for("no menu", |state| !state.menu);

    // Nothing lies over the picture in the photo mode but the bar.
    desktop.use_bar("Photo");
    desktop.wait_for("only the picture", |state| !state.shows("azimuth"));
    desktop.use_bar("End photo mode");
    desktop.wait_for("the read-outs", |state| state.shows("azimuth"));
    desktop.end_without_error();
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_buttons_of_the_bar_fly_the_ship_and_the_bar_stays() {
    let desktop = Desktop::open_small(&["--preset", PLAIN]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    let wait_for = |what: &str, is_so: &dyn Fn(&ShipState) -> bool| {
        desktop.wait_for(what, |state| state.ship.as_ref().is_some_and(is_so))
    };
    desktop.use_bar("Ship");
    wait_for("the ship", &|ship| ship.acceleration == 0.0);
    desktop.tap(FREE);
    let bar = desktop.wait_for("the bar", |state| state.place_of("Push").is_some());
    let place_of = |button: &str| {
        let shown = desktop.state();
        shown
            .place_of(button)
            .unwrap_or_else(|| panic!("no {button}"))
    };

    // The engine pushes for as long as the finger is down.
    let push = bar.place_of("Push").unwrap();
    desktop.order(&Order::Touch(0, Stroke::Down, push));
    let pushed = wait_for("a push", &|ship| ship.acceleration > 0.0);
    desktop.order(&Order::Touch(0, Stroke::Up, push));
    wait_for("the end of the push", &|ship| ship.acceleration == 0.0);
    assert_eq!(
        pushed.ship.unwrap().heading,
        "",
        "the finger turned the nose"
    );

    for (button, is_so) in [
        (
            "Nose",
            (|ship| ship.heading == "Hole") as fn(&ShipState) -> bool,
        ),
        ("Orbit", |ship| ship.hold.starts_with("Orbit")),
        ("Still", |ship| ship.hold.starts_with("Hover")),
        ("Engine off", |ship| {
            ship.hold.is_empty() && ship.heading.is_empty()
        }),
        ("Slower", |ship| ship.pace == 0.5),
        ("Faster", |ship| ship.pace == 1.0),
    ] {
        desktop.tap(place_of(button));
        wait_for(button, &is_so);
        desktop.wait_for("the bar after it", |state| state.place_of("Push").is_some());
    }

    // A finger on the picture turns the nose, which costs nothing.
    let before = desktop.state();
    let turned = desktop.drag_fingers([straight(FREE, [FREE[0] + 100.0, FREE[1]])]);
    assert!(change("camera.yaw_deg", [&before, &turned]).abs() > 1.0);
    let used = |state: &State| state.ship.as_ref().unwrap().rapidity_used;
    assert_eq!(used(&turned), used(&before));

    desktop.tap(FREE);
    desktop.wait_for("no bar", |state| state.place_of("Push").is_none());
    desktop.use_bar("Menu");
    desktop.wait_for("the menu", |state| state.menu && state.shows("Resume"));
    desktop.end_without_error();
}

/// A full tank lasts thirty seconds at full thrust.
#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn an_empty_tank_is_said_by_a_thrust_key_and_by_the_bar_whose_button_goes_back() {
    let text = first_mission();
    let small = text.replacen("rapidity = 0.10,", "rapidity = 0.01,", 1);
    assert_ne!(small, text);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("small.toml");
    std::fs::write(&path, small).unwrap();
    let desktop = Desktop::open_small(&["--preset", path.to_str().unwrap()]);
    desktop.first_picture();
    desktop.order(&Order::Step(0.2));
    let used = |state: &State| state.ship.as_ref().map_or(0.0, |ship| ship.rapidity_used);
    // The key that closes the card pushes already.
    desktop.hold("w");
    desktop.wait_for("the empty tank", |state| used(state) == 0.01);
    desktop.let_go("w");
    desktop.later(FRAMES);
    desktop.press("w");
    desktop.wait_for("what the key says", |state| {
        state.mentions("nothing pushes the ship. You can turn")
    });
    let has = |state: &State, button: &str| state.texts.iter().any(|text| text.words == button);
    desktop.tap(FREE);
    let bar = desktop.wait_for("the bar", |state| {
        has(state, "The tank is empty") && has(state, "Back")
    });
    assert!(!has(&bar, "Push") && !has(&bar, "Orbit"));
    desktop.later(FRAMES);
    desktop.tap(desktop.state().place_of("Back").unwrap());
    desktop.wait_for("a full tank", |state| {
        used(state) == 0.0 && has(state, "Push")
    });
    desktop.end_without_error();
}
