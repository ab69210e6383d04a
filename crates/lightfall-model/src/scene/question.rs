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
    /// Everything that is read of it.
    pub(super) fn texts(&self) -> [&String; 3] {
        [&self.text, &self.unit, &self.hint]
    }

    /// What was typed, as an answer.
    ///
    /// # Errors
    /// A sentence that says that no number was typed.
    pub fn judge(&self, typed: &str) -> Result<JudgedAnswer, String> {
        let typed = typed.trim();
        let Some(number) = typed_number(typed, &self.unit) else {
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

/// The number that was typed: with a decimal point or comma, as a fraction such as `27/4`, in percent, or in
/// degrees with their sign, and with the `unit` behind it or without. None for anything else.
pub fn typed_number(typed: &str, unit: &str) -> Option<f64> {
    let typed = typed.trim();
    let typed = typed.strip_suffix(unit).unwrap_or(typed).trim_end();
    // Percent of a question whose unit they are have gone with the unit.
    let (typed, parts) = match typed.strip_suffix('%') {
        Some(typed) => (typed, 100.0),
        None => (typed, 1.0),
    };
    let typed = typed.strip_suffix('°').unwrap_or(typed);
    let number = match typed.split_once('/') {
        Some((above, below)) => decimal(above)? / decimal(below)?,
        None => decimal(typed)?,
    };
    Some(number / parts).filter(|number| number.is_finite())
}

/// A finite number with a point or a comma. Keyboards for phones type the minus of typography.
fn decimal(typed: &str) -> Option<f64> {
    let plain = typed.trim().replace(',', ".").replace('\u{2212}', "-");
    plain.parse().ok().filter(|number: &f64| number.is_finite())
}
