//! The units of lengths and times in texts.

use super::si::HoleMass;
use lightfall_model::numbers::{duration_in_words, four_digits, in_words, steady_digits};

/// The units in which texts for players give lengths and times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Units {
    /// Those of the hole: r_s and r_s/c.
    Hole,
    /// Kilometres, and milliseconds to years, for a hole of this mass.
    Everyday(HoleMass),
}

impl Units {
    /// A length in r_s, with its unit. `digits` writes the number of r_s.
    pub fn length(self, length: f64, digits: impl Fn(f64) -> String) -> String {
        match self {
            Self::Hole => format!("{} r_s", digits(length)),
            Self::Everyday(mass) => format!("{} km", in_words(length * mass.metres() / 1000.0)),
        }
    }

    /// A time in r_s/c, with its unit. `digits` writes the number of r_s/c.
    pub fn time(self, time: f64, digits: impl Fn(f64) -> String) -> String {
        match self {
            Self::Hole => format!("{} r_s/c", digits(time)),
            Self::Everyday(mass) => duration_in_words(time * mass.seconds()),
        }
    }

    /// A time in r_s/c, with digits that keep their number while they change.
    pub fn steady_time(self, time: f64) -> String {
        self.time(time, steady_digits)
    }

    /// A text whose lengths and times are in r_s and r_s/c, with both in these units: every number before
    /// such a unit, with the signs around it, and those of a list before it that commas, `and`, `to` or `or`
    /// join.
    pub fn in_text(self, text: &str) -> String {
        if self == Self::Hole {
            return text.to_owned();
        }
        let mut words: Vec<String> = text.split(' ').map(str::to_owned).collect();
        let mut place = 1;
        while place < words.len() {
            let (unit, after) = match &words[place] {
                word if word.starts_with("r_s/c") => ("r_s/c", word[5..].to_owned()),
                word if word.starts_with("r_s") => ("r_s", word[3..].to_owned()),
                _ => ("", String::new()),
            };
            let ends = after.chars().all(|c| !c.is_alphanumeric());
            let in_units = |word: &str| {
                let (signs, value) = number(word)?;
                let amount = match unit {
                    "r_s" => self.length(value, four_digits),
                    _ => self.time(value, four_digits),
                };
                Some(format!("{signs}{amount}"))
            };
            let is_unit = !unit.is_empty() && ends;
            let Some(last) = in_units(&words[place - 1]).filter(|_| is_unit) else {
                place += 1;
                continue;
            };
            words[place - 1] = last + &after;
            words.remove(place);
            let mut first = place - 1;
            while let Some(before) = listed_before(&words[..first]) {
                let word = &words[before];
                let listed = word.trim_end_matches(',');
                let commas = &word[listed.len()..];
                let Some(amount) = in_units(listed) else {
                    break;
                };
                words[before] = amount + commas;
                first = before;
            }
        }
        words.join(" ")
    }

    /// The same units for a hole of another mass.
    #[must_use]
    pub fn for_mass(self, mass: HoleMass) -> Self {
        match self {
            Self::Hole => Self::Hole,
            Self::Everyday(_) => Self::Everyday(mass),
        }
    }

    /// Whether texts leave out what only specialists ask for.
    pub fn are_simple(self) -> bool {
        self != Self::Hole
    }
}

/// A word as a number, such as `1.6`, `(1.6`, `~2` or `2/3`, after the signs before it.
fn number(word: &str) -> Option<(&str, f64)> {
    let is_sign = |c: char| !c.is_alphanumeric() && !".+-".contains(c);
    let digits = word.trim_start_matches(is_sign);
    let signs = &word[..word.len() - digits.len()];
    let value: f64 = match digits.split_once('/') {
        Some((above, below)) => above.parse::<f64>().ok()? / below.parse::<f64>().ok()?,
        None => digits.parse().ok()?,
    };
    value.is_finite().then_some((signs, value))
}

/// The place of the number with which these words end, if a list goes on after it: one before a joining word,
/// or one with a comma.
fn listed_before(words: &[String]) -> Option<usize> {
    let (last, others) = words.split_last()?;
    let (place, listed) = if ["and", "to", "or"].contains(&last.as_str()) {
        (words.len().checked_sub(2)?, others.last()?.as_str())
    } else {
        (others.len(), last.strip_suffix(',')?)
    };
    number(listed.trim_end_matches(',')).map(|_| place)
}
