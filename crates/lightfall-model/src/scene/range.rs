//! What values a field may have: its kind and, for a number, the interval.

use crate::words::Choice;
use std::fmt;
use std::ops::Bound::{self, Excluded, Included, Unbounded};

/// The kind of value that a field takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A finite number.
    Float(Range),
    /// A whole number.
    Integer(Range),
    /// True or false.
    Boolean,
    /// One of these.
    Choice(&'static [Choice]),
    /// One line of text, no longer than [`MAX_TEXT_CHARS`].
    Text,
    /// Three finite numbers, the components of a velocity below that of light.
    Velocity,
    /// Two numbers, to the right and upward, of at most 10.
    Pair,
}

impl Kind {
    /// The same kind, narrowed to a range if it is a number.
    pub(super) const fn within(self, range: Range) -> Self {
        match self {
            Self::Float(_) => Self::Float(range),
            Self::Integer(_) => Self::Integer(range),
            other => other,
        }
    }

    /// The range of a number; every finite number for the other kinds.
    pub fn range(self) -> Range {
        match self {
            Self::Float(range) | Self::Integer(range) => range,
            _ => Range::FINITE,
        }
    }

    /// What a field of this kind takes, in words, e.g. `a number from 0 to 180 degrees`: within
    /// `range`, in this unit.
    pub(super) fn in_words(self, range: Range, unit: &str) -> String {
        let words = |noun: &str| {
            let space = if unit.is_empty() { "" } else { " " };
            match range {
                Range::FINITE => format!("{noun}{space}{unit}"),
                Range {
                    low: Included(low),
                    high: Included(high),
                } if low == high => format!("{}{space}{unit}", number(low)),
                _ => format!("{noun} {range}{space}{unit}"),
            }
        };
        match self {
            Self::Float(_) => words("a number"),
            Self::Integer(_) => words("an integer"),
            Self::Boolean => "true or false".into(),
            Self::Choice(choices) => {
                let words = choices.iter().map(|choice| choice.word);
                format!("one of {}", words.collect::<Vec<_>>().join(", "))
            }
            Self::Text => format!("one line of text, at most {MAX_TEXT_CHARS} characters"),
            Self::Velocity => {
                "three numbers, [outward, toward growing theta, toward growing phi], of length below 1 c".into()
            }
            Self::Pair => {
                format!("two numbers, [to the right, upward], from -{MAX_PAIR} to {MAX_PAIR}")
                    + if unit.is_empty() { "" } else { " " }
                    + unit
            }
        }
    }
}

/// The largest size of either number of a pair.
pub const MAX_PAIR: f64 = 10.0;

/// Maximum number of characters of a text field.
pub const MAX_TEXT_CHARS: usize = 200;

/// An interval of numbers, each end open or closed. Whole numbers up to 2^53 are exact in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end.
    pub low: Bound<f64>,
    /// Upper end.
    pub high: Bound<f64>,
}

impl Range {
    /// Every finite number.
    pub const FINITE: Self = Self {
        low: Unbounded,
        high: Unbounded,
    };

    /// `low <= x <= high`.
    pub(super) const fn closed(low: f64, high: f64) -> Self {
        Self {
            low: Included(low),
            high: Included(high),
        }
    }

    /// `low < x <= high`.
    pub(super) const fn above(low: f64, high: f64) -> Self {
        Self {
            low: Excluded(low),
            high: Included(high),
        }
    }

    /// `low < x < high`.
    pub(super) const fn between(low: f64, high: f64) -> Self {
        Self {
            low: Excluded(low),
            high: Excluded(high),
        }
    }

    /// Whether a number is finite and inside.
    pub fn contains(&self, number: f64) -> bool {
        number.is_finite() && std::ops::RangeBounds::contains(&(self.low, self.high), &number)
    }
}

impl fmt::Display for Range {
    /// The interval in words, e.g. `above 0 and at most 16`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lower = |low| number(round_inside(low, 1.0));
        let upper = |high| number(round_inside(high, -1.0));
        let low = match (self.low, self.high) {
            (Included(low), Included(high)) if low == high => {
                return write!(f, "equal to {}", number(low));
            }
            (Included(low), Included(high)) => {
                return write!(f, "from {} to {}", lower(low), upper(high));
            }
            (Included(low), _) => Some(format!("at least {}", lower(low))),
            (Excluded(low), _) => Some(format!("above {}", lower(low))),
            (Unbounded, _) => None,
        };
        let high = match self.high {
            Included(high) => Some(format!("at most {}", upper(high))),
            Excluded(high) => Some(format!("below {}", upper(high))),
            Unbounded => None,
        };
        let ends: Vec<_> = low.into_iter().chain(high).collect();
        f.write_str(&ends.join(" and "))
    }
}

/// A limit with few digits, rounded into the interval, so that the number in the message is
/// allowed: `side` is 1 for a lower limit and -1 for an upper one. A limit that has few digits
/// already stays as it is.
fn round_inside(limit: f64, side: f64) -> f64 {
    const DIGITS: i32 = 6;
    if limit.fract() == 0.0
        || !limit.is_finite()
        || format!("{limit:e}")
            .find('e')
            .is_some_and(|length| length <= 10)
    {
        return limit;
    }
    let scale = 10.0_f64.powi(DIGITS - 1 - limit.abs().log10().floor() as i32);
    side * (side * limit * scale).ceil() / scale
}

/// A number with the fewest digits from which it can be read back; an exponent only where zeros
/// would hide its size.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 || (1e-4..1e16).contains(&x.abs()) || !x.is_finite() {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}
