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
    /// What is said after a wrong answer. Empty for nothing.
    #[serde(default)]
    pub hint: String,
}

/// An answer to a question, and whether it is right.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedAnswer {
    /// The number.
    pub number: f64,
    /// Whether it is right.
    pub is_right: bool,
    /// A sentence that says so.
    pub said: String,
}

impl Question {
    /// What was typed, as an answer.
    ///
    /// # Errors
    /// A sentence that says that no number was typed.
    pub fn judge(&self, typed: &str) -> Result<JudgedAnswer, String> {
        let typed = typed.trim().replace(',', ".");
        let number = typed.strip_suffix(&self.unit).unwrap_or(&typed).trim();
        let number: Option<f64> = number.parse().ok();
        let Some(number) = number.filter(|number| number.is_finite()) else {
            return Err(format!("{typed:?} is not a number"));
        };
        let is_right = (number - self.answer).abs() <= self.tolerance;
        let said = if is_right {
            let right = [four_digits(self.answer), self.unit.clone()].join(" ");
            format!("Right: it is {}", right.trim_end())
        } else {
            let wrong = format!("It is not {typed}");
            match self.hint.as_str() {
                "" => wrong,
                hint => format!("{wrong}. {hint}"),
            }
        };
        Ok(JudgedAnswer {
            number,
            is_right,
            said,
        })
    }
}
