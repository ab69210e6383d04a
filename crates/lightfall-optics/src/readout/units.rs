//! The units of lengths and times in texts.

use super::si::HoleMass;
use lightfall_model::numbers::{duration_in_words, in_words, steady_digits};

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

    /// Whether texts leave out what only specialists ask for.
    pub fn are_simple(self) -> bool {
        self != Self::Hole
    }
}
