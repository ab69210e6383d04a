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
    /// such a unit, and the one before it if `and`, `to` or `or` joins them.
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
            let number = |word: &str| word.parse::<f64>().ok().filter(|it| it.is_finite());
            let ends = after.chars().all(|it| !it.is_alphanumeric());
            let (Some(value), true, true) = (number(&words[place - 1]), !unit.is_empty(), ends)
            else {
                place += 1;
                continue;
            };
            let in_units = |value: f64| match unit {
                "r_s" => self.length(value, four_digits),
                _ => self.time(value, four_digits),
            };
            words[place - 1] = in_units(value) + &after;
            words.remove(place);
            let is_joined = place >= 3 && ["and", "to", "or"].contains(&words[place - 2].as_str());
            if let Some(first) = number(&words[place.saturating_sub(3)]).filter(|_| is_joined) {
                words[place - 3] = in_units(first);
            }
        }
        words.join(" ")
    }

    /// Whether texts leave out what only specialists ask for.
    pub fn are_simple(self) -> bool {
        self != Self::Hole
    }
}
