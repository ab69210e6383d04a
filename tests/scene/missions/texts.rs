//! The texts of missions and lessons, in which names in braces stand for keys.

use lightfall::app::{Bindings, control_named, unknown_controls};
use lightfall_core::scene::journey::{self, LESSONS};
use lightfall_core::scene::mission::{self, MISSIONS, MissionKey};

/// A name in braces stands for a key.
#[test]
fn texts_of_missions_and_lessons_name_controls_that_exist() {
    let check = |name: &str, text: &str| {
        for part in text.split('{').skip(1) {
            let (id, _) = part
                .split_once('}')
                .unwrap_or_else(|| panic!("{name}: {text}"));
            assert!(control_named(id).is_some(), "{name}: {id}");
        }
    };
    for (name, text) in MISSIONS {
        let mission = mission::load(name, text).unwrap();
        mission.texts().iter().for_each(|text| check(name, text));
    }
    for (name, text) in LESSONS {
        let lesson = journey::load(name, text).unwrap();
        lesson.texts().iter().for_each(|text| check(name, text));
    }
}

/// The card at the start lists controls that exist, and names in braces stand for keys.
#[test]
fn keys_that_a_mission_can_need_are_controls_and_texts_have_their_names() {
    for id in MissionKey::WORDS {
        assert!(control_named(id).is_some(), "{id}");
    }
    for (name, text) in MISSIONS {
        let keys = mission::load(name, text).unwrap().keys;
        assert!(keys.is_some_and(|keys| !keys.is_empty()), "{name}");
    }
    let bindings = Bindings::default();
    for (text, words) in [
        ("Hold {fly.forward}: it brakes.", "Hold W: it brakes."),
        (
            "let go. {motion.faster} lets time run faster",
            "let go. \".\" lets time run faster",
        ),
        ("{fly.left}{fly.right}", "AD"),
        ("{fly.nowhere} and { and {", "{fly.nowhere} and { and {"),
    ] {
        assert_eq!(bindings.with_keys(text), words);
    }
}

#[test]
fn names_in_braces_that_no_control_has_are_told_with_what_was_probably_meant() {
    let text = "Press {inspector}, {fly.left}, {fly.lefft} or {nothing like it}".to_owned();
    let there_is_no = |name: &str, rest: &str| {
        format!("there is no control {{{name}}}, and the text keeps its braces{rest}")
    };
    assert_eq!(
        unknown_controls([&text]),
        [
            there_is_no("inspector", "; did you mean {window.inspector}?"),
            there_is_no("fly.lefft", "; did you mean {fly.left}?"),
            there_is_no("nothing like it", ""),
        ]
    );
}
