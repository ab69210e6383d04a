//! Every key of the table of controls, pressed in the real window: what it changed in the scene or in
//! the program's state.

mod effects;
mod scripts;

use crate::session::Session;
use crate::x_keys::x_keys;
use effects::{EFFECTS, Effect};
use lightfall::app::{Action, CONTROLS, Control, control_named, edited, statement};
use lightfall_core::scene::presets;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use watched::{Answer, State, fields_of};

/// What the light meter sets, if it is on.
const METERED: &str = "picture.exposure_ev";

/// Presses a key and looks whether it does what it should.
fn check(session: &mut Session, key: &str, effect: &Effect) {
    let before = session.show_first_scene();
    match effect {
        Effect::Fields(expected) => {
            let expected: BTreeMap<String, Value> = expected
                .iter()
                .map(|(field, value)| ((*field).to_owned(), value.parse().unwrap()))
                .collect();
            session.press(key);
            session.wait_for(key, |state| {
                let mut changed = state.changed_since(&before);
                changed.retain(|field, _| field != METERED || expected.contains_key(METERED));
                changed == expected
            });
            session.press("BackSpace");
            session.wait_for("undone", |state| state.scene == before.scene);
        }
        Effect::Falls(field) => assert!(held(session, key, field, &before) < 0.0, "{key}"),
        Effect::Grows(field) => assert!(held(session, key, field, &before) > 0.0, "{key}"),
        Effect::Loads(name) => {
            let preset = presets::find(name).unwrap().scene(&[]).unwrap();
            let expected = fields_of(&preset);
            session.press(key);
            session.wait_for(key, |state| {
                let runs_or_is_metered = |field: &str| field == "disk.time" || field == METERED;
                state.scene.len() == expected.len()
                    && expected.iter().all(|(field, value)| {
                        state.scene.get(field) == Some(value) || runs_or_is_metered(field)
                    })
            });
        }
        Effect::Switches(is_on) => {
            assert!(!is_on(&before), "{key}");
            session.press(key);
            session.wait_for(key, is_on);
            session.press(key);
            session.wait_for(&format!("{key} again"), |state| !is_on(state));
        }
        Effect::Script(script) => script(session, key),
    }
}

/// How much a number of the scene changes while a key is held.
fn held(session: &Session, key: &str, field: &str, before: &State) -> f64 {
    let change = |state: &State| state.number(field) - before.number(field);
    session.hold(key);
    let after = session.wait_for(key, |state| change(state) != 0.0);
    session.let_go(key);
    change(&after)
}

#[test]
fn every_control_has_an_effect_that_is_tested() {
    let tested: BTreeSet<&str> = EFFECTS.iter().map(|(id, _)| *id).collect();
    let controls: BTreeSet<&str> = CONTROLS.iter().map(|control| control.id).collect();
    assert_eq!(tested, controls);
    assert_eq!(tested.len(), EFFECTS.len(), "a control is listed twice");
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn every_key_of_the_table_changes_what_its_row_says_and_leads_to_its_message_within_two_frames() {
    let mut session = Session::open(&[]);
    let mut silent = Vec::new();
    for (id, effect) in EFFECTS {
        let control = control_named(id).unwrap();
        for key in x_keys(control) {
            println!("{id}: {key}");
            session.answers.borrow_mut().clear();
            check(&mut session, &key, effect);
            // What leaves the program says nothing more. A screenshot of the window would show its own
            // message, which comes when it is written; its script waits for that. Looking around turns
            // the whole picture, and no read-out has the direction.
            let speaks = !["window.quit", "window.screenshot_of_window"].contains(id)
                && !id.starts_with("fly.look_");
            if speaks && !says(control, &session.answers.borrow()[&key]) {
                silent.push(format!("{id}: {key}"));
            }
        }
    }
    assert!(silent.is_empty(), "silent: {silent:?}");
}

/// Whether the answer to the first press of a control's key is its message. A preset says its number,
/// a switch its state. What a held key changes is read from the read-outs, and commands say what they
/// do in their own words.
fn says(control: &Control, answer: &Answer) -> bool {
    let scene = presets::find("2").unwrap().scene(&[]).unwrap();
    let words = match control.action {
        Action::Edit(_) => edited(control, &scene, &scene)
            .and_then(|after| statement(control, &after))
            .and_then(|words| Some(words.split_once(':')?.0.to_owned())),
        Action::Load(number) => Some(number.to_string()),
        _ => None,
    };
    match words {
        Some(words) => answer.shown.iter().any(|text| text.starts_with(&words)),
        None => !answer.new.is_empty(),
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_screenshot_that_cannot_be_written_is_answered_by_one_sentence() {
    // Not even root creates a file there.
    let session = Session::open(&[("XDG_PICTURES_DIR", "/proc")]);
    let sentence = "Nothing is saved: /proc/lightfall-edge-on-0001.png: cannot be written: ";
    for key in ["F12", "shift+F12"] {
        session.press(key);
        session.wait_for(key, |state| state.shows(sentence));
        // Another message takes its place.
        session.press("g");
        session.wait_for("another message", |state| !state.shows("Nothing is saved"));
    }
}
