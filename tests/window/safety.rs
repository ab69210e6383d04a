//! What a window may be put through.

use crate::changed;
use crate::desktop::Desktop;
use std::time::Duration;

#[test]
fn any_size_and_minimising_are_survived() {
    let Some(mut desktop) = Desktop::open(&["--preset", "2"]) else { return };
    let start = desktop.settled("first picture", |shot| shot.colours() > 50);
    desktop.press("p");
    desktop.press("i");
    for (width, height) in [(640, 360), (1, 1), (200, 860), (1490, 60), (1, 400), (1440, 810)] {
        desktop.resize(width, height);
        std::thread::sleep(Duration::from_millis(700));
        assert!(desktop.running(), "{width} x {height}: {}", desktop.said());
    }
    desktop.minimise(true);
    std::thread::sleep(Duration::from_secs(1));
    assert!(desktop.running(), "minimised: {}", desktop.said());
    desktop.minimise(false);
    desktop.press("p");
    desktop.press("i");
    desktop.settled("as before", |shot| changed(shot, &start) == 0.0);
    assert!(!desktop.said().contains("ERROR"), "{}", desktop.said());
}

/// Keys that are pressed at random: every key of the table but the whole screen, and some that do nothing.
const KEYS: &[&str] = &[
    "w",
    "a",
    "s",
    "d",
    "space",
    "q",
    "e",
    "Tab",
    "Escape",
    "j",
    "Return",
    "f",
    "comma",
    "period",
    "1",
    "2",
    "3",
    "4",
    "5",
    "6",
    "7",
    "8",
    "9",
    "BackSpace",
    "F2",
    "u",
    "F3",
    "g",
    "F4",
    "t",
    "o",
    "l",
    "z",
    "x",
    "c",
    "F11",
    "b",
    "m",
    "n",
    "r",
    "F5",
    "F6",
    "F7",
    "F8",
    "F9",
    "v",
    "equal",
    "minus",
    "F1",
    "p",
    "i",
    "h",
    "y",
    "F10",
    "Home",
];

#[test]
fn five_hundred_random_keys_and_clicks_do_no_harm() {
    let Some(mut desktop) = Desktop::open(&["--preset", "2"]) else { return };
    desktop.settled("first picture", |shot| shot.colours() > 50);
    // Knuth's multiplier; the same sequence every time.
    let mut state = 20_260_101_u64;
    let mut random = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    let mut memory = Vec::new();
    for step in 0..500 {
        if random(4) == 0 {
            desktop.click(random(1440) as i32, random(810) as i32);
        } else {
            desktop.press(KEYS[random(KEYS.len() as u64) as usize]);
        }
        assert!(desktop.running(), "ended at step {step}: {}", desktop.said());
        if step % 100 == 99 {
            memory.push(desktop.memory());
        }
    }
    let said = desktop.said();
    assert!(!said.contains("ERROR") && !said.contains("panicked") && !said.contains("alidation"), "{said}");
    println!("memory: {memory:?}");
    // Pipelines of new variants are kept, so there is some growth; a texture lost with each change would be a hundred times
    // as much.
    assert!(memory[4] < memory[1] + 300_000_000, "{memory:?}");
}
