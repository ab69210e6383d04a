//! An answer to a question, as it is typed and judged.

use lightfall_core::scene::{JudgedAnswer, Question};

/// What was typed, and what came of it.
#[derive(Default)]
pub(crate) struct TypedAnswer {
    /// What was typed.
    pub(crate) typed: String,
    /// Whether the last answer is right, and what is said of it.
    pub(crate) is_right: bool,
    pub(crate) said: String,
}

impl TypedAnswer {
    /// Judges what was typed. Returns the answer, if it is a number. A wrong one, which the sentence repeats,
    /// leaves the field empty for the next one.
    pub(crate) fn judge(&mut self, question: &Question) -> Option<JudgedAnswer> {
        let judged = match question.judge(&self.typed) {
            Ok(judged) => {
                (self.is_right, self.said) = (judged.is_right, judged.said.clone());
                Some(judged)
            }
            Err(fault) => {
                self.said = fault;
                None
            }
        };
        if !self.is_right {
            self.typed.clear();
        }
        judged
    }
}
