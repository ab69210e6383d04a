//! The browser's clipboard, which answers some frames later.

use bevy::prelude::Resource;
use lightfall_platform::browser;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};

/// The clipboard, and what it has answered.
#[derive(Resource)]
pub(crate) struct Clipboard {
    answer: Sender<Result<String, String>>,
    answers: Mutex<Receiver<Result<String, String>>>,
}

impl Clipboard {
    pub(super) fn start() -> Self {
        let (answer, answers) = channel();
        Self {
            answer,
            answers: Mutex::new(answers),
        }
    }

    /// Puts a text on the clipboard.
    pub(crate) fn copy(&self, text: String) {
        let answer = self.answer.clone();
        browser::copy(text, move |copied| {
            if let Err(reason) = copied {
                answer.send(Err(unreachable(&reason))).ok();
            }
        });
    }

    /// Asks for the text on the clipboard.
    pub(super) fn paste(&self) {
        let answer = self.answer.clone();
        browser::paste(move |text| {
            answer
                .send(text.map_err(|reason| unreachable(&reason)))
                .ok();
        });
    }

    /// A text to paste, or what could not be done.
    pub(super) fn next_text(&self) -> Option<Result<String, String>> {
        let answers = self.answers.lock().unwrap_or_else(PoisonError::into_inner);
        answers.try_recv().ok()
    }
}

fn unreachable(reason: &str) -> String {
    format!("The clipboard cannot be reached: {reason}")
}
