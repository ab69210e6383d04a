//! A question with a number as its answer, as missions and lessons ask it.

use crate::numbers::four_digits;
use serde::Deserialize;

/// A question with a number as its answer.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// The question.
    pub text: String,
    /// The answer.
    pub answer: f64,
    /// By how much an answer may differ.
    pub tolerance: f64,
    /// The answer's unit, as it follows the number. Empty for a number without one.
    #[serde(default)]
    pub unit: String,
}

impl Question {
    /// The number that was typed as an answer, and a sentence that says whether it is right.
    ///
    /// # Errors
    /// A sentence that says that no number was typed.
    pub fn judge(&self, typed: &str) -> Result<(f64, String), String> {
        let typed = typed.trim().replace(',', ".");
        let number = typed.strip_suffix(&self.unit).unwrap_or(&typed).trim();
        let answer: Option<f64> = number.parse().ok();
        let Some(answer) = answer.filter(|answer| answer.is_finite()) else {
            return Err(format!("{typed:?} is not a number"));
        };
        let said = if (answer - self.answer).abs() <= self.tolerance {
            let right = [four_digits(self.answer), self.unit.clone()].join(" ");
            format!("Right: it is {}", right.trim_end())
        } else {
            format!("It is not {typed}")
        };
        Ok((answer, said))
    }
}
