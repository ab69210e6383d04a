//! A window with the plain scene, in which a test presses keys and reads what they lead to.

use crate::PLAIN;
use crate::desktop::Desktop;
use lightfall_core::scene::load;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::{Deref, DerefMut};
use watched::{Answer, Order, State, fields_of};

/// Time of a frame, in seconds.
const STEP: f64 = 0.05;

/// The window, and the answers to the keys pressed in it.
pub struct Session {
    desktop: Desktop,
    /// The answer to the first press of each key.
    pub answers: RefCell<BTreeMap<String, Answer>>,
}

impl Deref for Session {
    type Target = Desktop;

    fn deref(&self) -> &Desktop {
        &self.desktop
    }
}

impl DerefMut for Session {
    fn deref_mut(&mut self) -> &mut Desktop {
        &mut self.desktop
    }
}

impl Session {
    /// Opens a small window, with these variables of the environment.
    pub fn open(variables: &[(&str, &str)]) -> Self {
        let desktop = Desktop::open_with_variables(variables, &["--preset", PLAIN]);
        desktop.first_picture();
        desktop.order(&Order::Step(STEP));
        Self {
            desktop,
            answers: RefCell::default(),
        }
    }

    /// Presses a key, and returns the state when it has done what it does.
    #[track_caller]
    pub fn press(&self, key: &str) -> State {
        let state = self.desktop.press(key);
        self.keep_answer(key);
        state
    }

    /// Presses a key, and does not let go of it.
    #[track_caller]
    pub fn hold(&self, key: &str) {
        self.desktop.hold(key);
        self.keep_answer(key);
    }

    #[track_caller]
    fn keep_answer(&self, key: &str) {
        let answered = |state: &State| state.answer.key == state.keys;
        let answer = self.wait_for("an answer", answered).answer;
        let mut answers = self.answers.borrow_mut();
        answers.entry(key.to_owned()).or_insert(answer);
    }

    /// Shows the first scene again, and returns its state.
    #[track_caller]
    pub fn show_first_scene(&self) -> State {
        let preset = include_str!("plain.toml");
        let first = fields_of(&load(PLAIN, preset, &[]).unwrap());
        self.order(&Order::Show(preset.into()));
        self.wait_for("the first scene", |state| state.scene == first)
    }
}
