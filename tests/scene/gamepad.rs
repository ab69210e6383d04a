//! What a gamepad's sticks and triggers are worth, and which controls its buttons have.

use bevy::prelude::{GamepadButton, Vec2};
use lightfall::app::{CONTROLS, PadBindings, Settings, Switch};
use lightfall::app::{control_named, deflection, squeeze};
use std::collections::BTreeMap;

#[test]
fn a_stick_keeps_its_direction_and_is_worth_nothing_in_the_middle_and_one_at_most() {
    // What worn sticks rest at, and what the dead middle is for.
    for at_rest in [Vec2::ZERO, Vec2::new(0.1, 0.1), Vec2::new(-0.149, 0.0)] {
        assert_eq!(deflection(at_rest).length(), 0.0, "{at_rest}");
    }
    for turn in 0..16 {
        let direction = Vec2::from_angle(turn as f32 * 0.4);
        let mut last = 0.0;
        for step in 16..=142 {
            let worth = deflection(direction * step as f32 * 0.01);
            assert!(
                worth.length() > last - 1e-12 && worth.length() <= 1.0 + 1e-12,
                "{direction} {step}"
            );
            // The direction of a pair of f32.
            assert!(
                (worth.normalize() - direction.as_dvec2()).length() < 1e-6,
                "{direction} {step}"
            );
            last = worth.length();
        }
        assert!((last - 1.0).abs() < 1e-12);
        // Finer than in proportion: half the way is worth less than a quarter.
        assert!(deflection(direction * 0.5).length() < 0.25);
    }
    assert_eq!(deflection(Vec2::new(f32::NAN, 1.0)).length(), 0.0);
}

#[test]
fn a_trigger_begins_at_nothing_and_ends_at_one() {
    assert_eq!(
        [0.0, 0.05, 1.0, f32::NAN].map(squeeze),
        [0.0, 0.0, 1.0, 0.0]
    );
    let steps: Vec<f64> = (7..=100).map(|step| squeeze(step as f32 * 0.01)).collect();
    assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{steps:?}");
}

#[test]
fn every_default_button_has_a_name_and_one_control_that_there_is() {
    let bindings = PadBindings::default();
    let bound: Vec<GamepadButton> = bindings
        .iter()
        .flat_map(|(_, buttons)| buttons.to_vec())
        .collect();
    for (i, button) in bound.iter().enumerate() {
        assert!(GamepadButton::name(*button).is_some(), "{button:?}");
        assert!(!bound[..i].contains(button), "{button:?} has two controls");
    }
    // What the four corners of the pad and both sides are for: speed, roll, presets, panel,
    // journey.
    for id in [
        "fly.faster",
        "fly.slower",
        "fly.roll_left",
        "preset.next",
        "window.panel",
        "journey.fly",
    ] {
        assert!(
            control_named(id).is_some() && !bindings.of(id).is_empty(),
            "{id}"
        );
    }
    let in_table = CONTROLS
        .iter()
        .map(|control| GamepadButton::defaults(control).len())
        .sum::<usize>();
    assert_eq!(
        (bound.len(), in_table),
        (16, 16),
        "a name in the table of buttons is of no control"
    );
}

#[test]
fn names_of_buttons_are_read_back_as_the_same_buttons() {
    for name in GamepadButton::names() {
        assert_eq!(
            GamepadButton::named(name).and_then(GamepadButton::name),
            Some(name)
        );
        assert_eq!(
            GamepadButton::named(&name.to_lowercase()).and_then(GamepadButton::name),
            Some(name)
        );
    }
    assert_eq!(GamepadButton::named("Space"), None);
}

#[test]
fn buttons_are_bound_anew_beside_the_keys() {
    let text = "[keys]\n\"window.help\" = [\"F10\"]\n[buttons]\n\"window.help\" = [\"Guide\", \"L3\"]\n\"picture.bypass\" = []";
    let settings = Settings::read(text).unwrap();
    let bindings = PadBindings::new(&settings.buttons).unwrap();
    assert_eq!(
        bindings.of("window.help"),
        [GamepadButton::Mode, GamepadButton::LeftThumb]
    );
    assert!(bindings.of("picture.bypass").is_empty());
    assert_eq!(bindings.settings(), settings.buttons);
    for (line, said) in [
        (
            "\"window.help\" = [\"F1\"]",
            "buttons: window.help is given the button \"F1\", which is none",
        ),
        (
            "\"window.help\" = [\"A\"]",
            "buttons: A is given to both journey.fly and window.help",
        ),
        (
            "\"window.halp\" = [\"A\"]",
            "buttons: there is no control window.halp",
        ),
    ] {
        let error = Settings::read(&format!("[buttons]\n{line}")).unwrap_err();
        assert!(error.contains(said), "{error}");
    }
}

#[test]
fn a_button_bound_by_hand_is_taken_from_whoever_had_it_even_where_the_key_needs_alt() {
    let mut bindings = PadBindings::default();
    bindings.bind("window.fullscreen", GamepadButton::South);
    assert_eq!(bindings.of("window.fullscreen"), [GamepadButton::South]);
    assert!(bindings.of("journey.fly").is_empty());
    assert_eq!(
        bindings.in_words(control_named("window.fullscreen").unwrap()),
        "A"
    );
    let kept: BTreeMap<_, _> = bindings.settings();
    assert_eq!(PadBindings::new(&kept).unwrap(), bindings);
}
