//! Bounds and results of the thorough search.

use super::part::Part;
use crate::answer::greater;

/// The bounds of the search for a turn, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnBounds {
    /// A turn below this ends the search.
    pub target: f64,
    /// An upper bound of the turn.
    pub upper_bound: f64,
}

impl TurnBounds {
    /// The bounds of a search that decides whether an error exceeds a limit. The target is half of
    /// the limit, so that an error near the limit is exact.
    pub fn for_limit(limit: f64, upper_bound: f64) -> Self {
        Self {
            target: 0.5 * limit,
            upper_bound,
        }
    }
}

/// The turns that explain an answer of another class, in radians.
#[derive(Clone, Copy, Default)]
pub(super) struct Turns {
    /// The turn that explains its sky, and the largest of those that explain its hits.
    pub(super) sky: f64,
    pub(super) hits: f64,
    /// The turn to the nearest ray of its class.
    pub(super) class: f64,
}

impl Turns {
    pub(super) fn add(&mut self, part: Part, turn: f64) {
        match part {
            Part::Sky(_) => self.sky = turn,
            Part::Hit(..) => self.hits = greater(self.hits, turn),
        }
    }

    pub(super) fn min(self, other: Self) -> Self {
        Self {
            sky: self.sky.min(other.sky),
            hits: self.hits.min(other.hits),
            class: self.class.min(other.class),
        }
    }

    pub(super) fn largest(self) -> f64 {
        greater(greater(self.sky, self.hits), self.class)
    }
}

/// The result of the search for a part: the smallest turn that explains it, and the smallest bound
/// of the whole answer's error by a single ray.
#[derive(Clone, Copy)]
pub(super) struct Explained {
    pub(super) part: f64,
    pub(super) whole: f64,
}

impl Explained {
    pub(super) fn min(self, other: Self) -> Self {
        Self {
            part: self.part.min(other.part),
            whole: self.whole.min(other.whole),
        }
    }

    /// Whether no further search is needed.
    pub(super) fn is_within(self, target: f64) -> bool {
        self.part.min(self.whole) <= target
    }
}
