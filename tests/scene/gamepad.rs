//! The response to a gamepad's sticks and triggers, and the controls that its buttons are bound to.

use bevy::prelude::{GamepadButton, Vec2};
use lightfall::app::{Bindable, KeyLabels, PadBindings, Settings};
use lightfall::app::{control_named, deflection, squeeze};
use std::collections::BTreeMap;

#[test]
fn a_stick_keeps_its_direction_with_no_response_in_the_dead_zone_and_at_most_one_beyond() {
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
fn the_response_of_a_trigger_goes_from_zero_to_one() {
    assert_eq!(
        [0.0, 0.05, 1.0, f32::NAN].map(squeeze),
        [0.0, 0.0, 1.0, 0.0]
    );
    let steps: Vec<f64> = (7..=100).map(|step| squeeze(step as f32 * 0.01)).collect();
    assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{steps:?}");
}

#[test]
fn every_default_button_has_a_name_and_belongs_to_one_existing_control() {
    let bindings = PadBindings::default();
    let bound: Vec<GamepadButton> = bindings
        .iter()
        .flat_map(|(_, buttons)| buttons.to_vec())
        .collect();
    for (i, button) in bound.iter().enumerate() {
        assert!(GamepadButton::name(*button).is_some(), "{button:?}");
        assert!(!bound[..i].contains(button), "{button:?} has two controls");
    }
    // What the four corners of the pad and both sides are for: speed, roll, presets, menu,
    // journey.
    for id in [
        "fly.faster",
        "fly.slower",
        "fly.roll_left",
        "preset.next",
        "fly.escape",
        "journey.fly",
    ] {
        assert!(
            control_named(id).is_some() && !bindings.of(id).is_empty(),
            "{id}"
        );
    }
    let defaults = GamepadButton::defaults(&KeyLabels::default());
    let in_table = defaults.iter().map(Vec::len).sum::<usize>();
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
            GamepadButton::from_name(name).and_then(GamepadButton::name),
            Some(name)
        );
        assert_eq!(
            GamepadButton::from_name(&name.to_lowercase()).and_then(GamepadButton::name),
            Some(name)
        );
    }
    assert_eq!(GamepadButton::from_name("Space"), None);
}

#[test]
fn settings_bind_buttons_separately_from_keys() {
    let text = "[keys]\n\"window.help\" = [\"Home\"]\n[buttons]\n\"window.help\" = [\"Guide\", \"L3\"]\n\"fly.orbit\" = []";
    let settings = Settings::read(text).unwrap();
    let bindings = PadBindings::new(&settings.buttons, &KeyLabels::default()).unwrap();
    assert_eq!(
        bindings.of("window.help"),
        [GamepadButton::Mode, GamepadButton::LeftThumb]
    );
    assert!(bindings.of("fly.orbit").is_empty());
    assert_eq!(bindings.settings(), settings.buttons);
    for (line, expected) in [
        (
            "\"window.help\" = [\"F1\"]",
            "buttons: window.help: unknown button \"F1\"",
        ),
        (
            "\"window.help\" = [\"A\"]\n\"window.panel\" = [\"A\"]",
            "buttons: A is given to both window.help and window.panel",
        ),
        (
            "\"window.halp\" = [\"A\"]",
            "buttons: there is no control window.halp",
        ),
    ] {
        let error = Settings::read(&format!("[buttons]\n{line}"))
            .unwrap_err()
            .to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn binding_a_button_takes_it_from_its_former_control_even_where_the_key_needs_alt() {
    let mut bindings = PadBindings::default();
    bindings.bind("window.fullscreen", GamepadButton::South);
    assert_eq!(bindings.of("window.fullscreen"), [GamepadButton::South]);
    assert!(bindings.of("journey.fly").is_empty());
    assert_eq!(
        bindings.label_of(control_named("window.fullscreen").unwrap()),
        "A"
    );
    let kept: BTreeMap<_, _> = bindings.settings();
    assert_eq!(
        PadBindings::new(&kept, &KeyLabels::default()).unwrap(),
        bindings
    );
}
