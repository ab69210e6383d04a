//! Answers to the questions of lessons, as a file of comma-separated values beside that of missions: one row
//! for each answer.

use super::result_file::{cell, rewrite, text_cell};
use std::path::Path;

/// The columns.
const HEADER: &str = "lesson,question,answer,is_right,tries,time,pupil";
/// How every header of an earlier version begins, too.
const HEADER_START: &str = "lesson,question,";

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
    /// When it was given, in UTC, as RFC 3339 writes it.
    pub time: String,
    /// Who gave it. Empty if the settings name nobody.
    pub pupil: String,
}

impl LessonAnswer {
    /// The answer as a row.
    #[must_use]
    pub fn row(&self) -> String {
        [
            text_cell(&self.lesson),
            self.question.to_string(),
            cell(self.answer),
            self.is_right.to_string(),
            self.tries.to_string(),
            self.time.clone(),
            text_cell(&self.pupil),
        ]
        .join(",")
    }

    /// Adds the answer to a file.
    ///
    /// # Errors
    /// The file cannot be read or written; one sentence names it.
    pub fn keep(&self, file: &Path) -> Result<(), String> {
        rewrite(file, [HEADER, HEADER_START], |lines| lines.push(self.row()))
    }
}
