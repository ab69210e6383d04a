//! Where in a text a fault is.

use std::fmt;

/// What is wrong, and the line of a text in which it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Located<F> {
    /// From 1. None for a fault of the whole text, or of an option of the command line.
    pub(super) line: Option<usize>,
    /// What is wrong.
    pub(super) what: F,
}

impl<F: fmt::Display> fmt::Display for Located<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.what),
            None => write!(f, "{}", self.what),
        }
    }
}

/// The line of a place in a text, from 1.
pub(super) fn line_number(text: &str, at: usize) -> usize {
    let before = text.as_bytes().iter().take(at);
    1 + before.filter(|byte| **byte == b'\n').count()
}
