//! Answers to the questions of lessons, as a file of comma-separated values beside that of missions: one row
//! for each answer.

use super::result_file::{cell, quoted, rewrite};
use std::path::Path;

/// The columns.
const HEADER: &str = "lesson,question,answer,is_right,tries";

/// An answer to a question of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct LessonAnswer {
    /// The lesson's title.
    pub lesson: String,
    /// Which of its questions it is, from 1.
    pub question: usize,
    /// The number.
    pub answer: f64,
    /// Whether it is right.
    pub is_right: bool,
    /// Which try it is, from 1.
    pub tries: u32,
}

impl LessonAnswer {
    /// The answer as a row.
    #[must_use]
    pub fn row(&self) -> String {
        [
            quoted(&self.lesson),
            self.question.to_string(),
            cell(self.answer),
            self.is_right.to_string(),
            self.tries.to_string(),
        ]
        .join(",")
    }

    /// Adds the answer to a file.
    ///
    /// # Errors
    /// The file cannot be read or written; one sentence names it.
    pub fn keep(&self, file: &Path) -> Result<(), String> {
        rewrite(file, [HEADER, HEADER], |lines| lines.push(self.row()))
    }
}
