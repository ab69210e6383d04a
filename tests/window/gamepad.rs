//! A gamepad in the window. Its messages are Bevy's own, as the reader of the hardware writes them,
//! so that no hardware is needed.

use crate::desktop::Desktop;
use crate::shot::Shot;
use crate::{STATUS_BAR, WINDOW, program};
use bevy::input::gamepad::{GamepadConnection, GamepadConnectionEvent, RawGamepadEvent};
use bevy::input::gamepad::{
    GamepadInput, RawGamepadAxisChangedEvent, RawGamepadButtonChangedEvent,
};
use bevy::prelude::*;
use lightfall::app::{FramePacing, JourneyPlayer};
use lightfall_render::CurrentScene;
use std::time::{Duration, Instant};

/// What a key has the pad do: which part of it is pushed for a second, so long after the key.
const HANDS: [(KeyCode, GamepadInput, u64); 6] = [
    (
        KeyCode::Numpad0,
        GamepadInput::Axis(GamepadAxis::LeftStickY),
        6,
    ),
    (
        KeyCode::Numpad4,
        GamepadInput::Axis(GamepadAxis::RightStickX),
        0,
    ),
    (
        KeyCode::Numpad1,
        GamepadInput::Button(GamepadButton::South),
        0,
    ),
    (
        KeyCode::Numpad2,
        GamepadInput::Button(GamepadButton::DPadRight),
        0,
    ),
    (
        KeyCode::Numpad3,
        GamepadInput::Button(GamepadButton::Start),
        0,
    ),
    (
        KeyCode::Numpad5,
        GamepadInput::Button(GamepadButton::RightTrigger),
        0,
    ),
];
const PUSHED: Duration = Duration::from_secs(1);

/// The pad, and what is pushed on it: from when on, and whether it is by now.
#[derive(Resource, Default)]
struct Hand {
    pad: Option<Entity>,
    pushed: Option<(GamepadInput, Instant, bool)>,
}

fn hand(
    mut commands: Commands,
    keys: Res<ButtonInput<KeyCode>>,
    mut hand: ResMut<Hand>,
    mut connections: MessageWriter<GamepadConnectionEvent>,
    mut raw: MessageWriter<RawGamepadEvent>,
    (scene, player, pace): (Res<CurrentScene>, Res<JourneyPlayer>, Res<FramePacing>),
) {
    let pad = *hand.pad.get_or_insert_with(|| commands.spawn_empty().id());
    if keys.just_pressed(KeyCode::Numpad7) {
        let connection = GamepadConnection::Connected {
            name: "Pad of the test".into(),
            vendor_id: None,
            product_id: None,
        };
        connections.write(GamepadConnectionEvent::new(pad, connection));
    }
    if keys.just_pressed(KeyCode::Numpad9) {
        connections.write(GamepadConnectionEvent::new(
            pad,
            GamepadConnection::Disconnected,
        ));
    }
    for (key, input, after) in HANDS {
        if keys.just_pressed(key) {
            hand.pushed = Some((input, Instant::now() + Duration::from_secs(after), false));
        }
    }
    let Some((input, start, pushed)) = &mut hand.pushed else {
        return;
    };
    let push = |value: f32| match *input {
        GamepadInput::Axis(axis) => {
            RawGamepadEvent::Axis(RawGamepadAxisChangedEvent::new(pad, axis, value))
        }
        GamepadInput::Button(button) => {
            RawGamepadEvent::Button(RawGamepadButtonChangedEvent::new(pad, button, value))
        }
    };
    let camera = &scene.camera;
    let state = format!(
        "r {} yaw {} fov {} roll {} resting {} journey {} preset {}",
        camera.r,
        camera.yaw_deg,
        camera.fov_deg,
        camera.roll_deg,
        pace.resting,
        player.is_playing(),
        scene.name
    );
    if !*pushed && Instant::now() >= *start {
        eprintln!("before: {state}");
        raw.write(push(1.0));
        *pushed = true;
    } else if *pushed && start.elapsed() > PUSHED {
        eprintln!("after: {state}");
        raw.write(push(0.0));
        hand.pushed = None;
    }
}

/// The program with such a gamepad. This is no test: the test below starts it as another process.
#[test]
#[ignore = "started by the test of the gamepad"]
fn started_program_that_has_a_gamepad() {
    let mut app = program();
    app.init_resource::<Hand>().add_systems(First, hand);
    assert_eq!(app.run(), AppExit::Success);
}

/// How things were before and after the key's hand was on the pad.
fn used(desktop: &Desktop, key: &str) -> [Vec<String>; 2] {
    let count = |stderr: &str| stderr.matches("after: ").count();
    let before = count(&desktop.stderr());
    desktop.press(key);
    let start = Instant::now();
    while count(&desktop.stderr()) == before {
        assert!(
            start.elapsed() < Duration::from_secs(30),
            "{key}: {}",
            desktop.stderr()
        );
        std::thread::sleep(Duration::from_millis(100));
    }
    let stderr = desktop.stderr();
    ["before: ", "after: "].map(|what| {
        let line = stderr
            .lines()
            .filter_map(|line| line.strip_prefix(what))
            .next_back()
            .unwrap();
        line.split(' ').map(str::to_owned).collect()
    })
}

/// A value of such a state, by its name.
fn value<'a>(state: &'a [String], name: &str) -> &'a str {
    &state[1 + state.iter().position(|word| word == name).unwrap()]
}

fn number(state: &[String], name: &str) -> f64 {
    value(state, name).parse().unwrap()
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_gamepad_wakes_the_window_flies_looks_around_and_presses_controls() {
    let program = std::env::current_exe().unwrap();
    let only = [
        "--exact",
        "gamepad::started_program_that_has_a_gamepad",
        "--ignored",
        "--test-threads=1",
        "--nocapture",
    ];
    let desktop = Desktop::open_program(&program, &only);
    let start = desktop.settled("first picture", |shot| shot.colours() > 50);
    desktop.press("KP_Home");
    let status_bar =
        |shot: &Shot| start.changed(shot, 0..WINDOW.0, WINDOW.1 - 2 * STATUS_BAR..WINDOW.1) > 0.0;
    desktop.until("the toast about the gamepad", status_bar);

    // Nothing but the pad tells the resting window to wake. How much of the second counts is the
    // machine's: a frame that takes longer than a quarter of one moves no farther.
    let about = |factor: f64| (0.4..1.6).contains(&factor);
    let [before, after] = used(&desktop, "KP_Insert");
    assert_eq!(
        [value(&before, "resting"), value(&after, "resting")],
        ["true", "false"]
    );
    // Nearer by the same share as with a key: 0.4 of the distance to the horizon a second.
    let nearer = ((number(&before, "r") - 1.0) / (number(&after, "r") - 1.0)).ln() / 0.4;
    assert!(about(nearer), "{nearer}: {before:?} {after:?}");

    // A field of view a second, to the right.
    let [before, after] = used(&desktop, "KP_Left");
    let turned = (number(&after, "yaw") - number(&before, "yaw")) / number(&before, "fov");
    assert!(about(turned), "{turned}: {before:?} {after:?}");
    // The place is made of the pose again, and rounded.
    assert!(
        (number(&before, "r") - number(&after, "r")).abs() < 1e-9,
        "{before:?} {after:?}"
    );
    let [before, after] = used(&desktop, "KP_Begin");
    assert!(
        number(&after, "roll") != number(&before, "roll"),
        "{before:?} {after:?}"
    );

    // The journey by a button; the stick takes over.
    let [before, after] = used(&desktop, "KP_End");
    assert_eq!(
        [value(&before, "journey"), value(&after, "journey")],
        ["false", "true"]
    );
    let [before, after] = used(&desktop, "KP_Left");
    assert_eq!(
        [value(&before, "journey"), value(&after, "journey")],
        ["true", "false"]
    );
    let [before, after] = used(&desktop, "KP_Down");
    assert_eq!(
        [value(&before, "preset"), value(&after, "preset")],
        ["above", "close"]
    );

    // One button opens the menu. There the button of the journey chooses the first entry, which
    // closes the menu, and starts no journey.
    let middle =
        |a: &Shot, b: &Shot| a.changed(b, WINDOW.0 / 3..2 * WINDOW.0 / 3, 200..WINDOW.1 - 200);
    // Its disk moves.
    desktop.press("slash");
    let closed = desktop.settled("preset 4", |_| true);
    used(&desktop, "KP_Next");
    desktop.settled("menu", |shot| middle(shot, &closed) > 0.3);
    let [before, after] = used(&desktop, "KP_End");
    assert_eq!(
        [value(&before, "journey"), value(&after, "journey")],
        ["false", "false"]
    );
    desktop.settled("no menu", |shot| middle(shot, &closed) == 0.0);

    desktop.press("KP_Prior");
    std::thread::sleep(Duration::from_millis(500));
    let [before, after] = used(&desktop, "KP_Left");
    assert_eq!(
        value(&before, "yaw"),
        value(&after, "yaw"),
        "a pad that is gone still turns the camera"
    );
    assert!(
        !desktop.stderr().contains("ERROR") && !desktop.stderr().contains("panicked"),
        "{}",
        desktop.stderr()
    );
}
