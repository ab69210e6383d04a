//! What the ship flies: freely, or on a mission.

use super::track::Track;
use glam::DVec3;
use lightfall_core::geometry::ship::{Ship, ShipError};
use lightfall_core::optics::ship::{Attempt, Orders, Voyage};
use lightfall_core::scene::mission::{Comparison, Quantity};

/// An event ends a piece of a voyage before this share of its time.
const WHOLE: f64 = 0.999_999;

/// A voyage, freely or on a mission.
#[derive(Clone, Debug)]
pub enum Flown {
    /// Freely.
    Free(Box<Voyage>),
    /// On a mission.
    Mission(Box<Attempt>),
}

impl Flown {
    /// The voyage.
    #[must_use]
    pub fn voyage(&self) -> &Voyage {
        match self {
            Self::Free(voyage) => voyage,
            Self::Mission(attempt) => attempt.voyage(),
        }
    }

    /// The ship.
    #[must_use]
    pub fn ship(&self) -> &Ship {
        &self.voyage().flight.ship
    }

    pub(super) fn order(&mut self, orders: Orders) {
        match self {
            Self::Free(voyage) => voyage.flight.order(orders),
            Self::Mission(attempt) => attempt.order(orders),
        }
    }

    pub(super) fn turn(&mut self, rotation: DVec3) {
        match self {
            Self::Free(voyage) => voyage.flight.turn(rotation),
            Self::Mission(attempt) => attempt.turn(rotation),
        }
    }

    /// The ship or, once a mission is decided, where it was then.
    fn scored_ship(&self) -> &Ship {
        match self {
            Self::Free(voyage) => &voyage.flight.ship,
            Self::Mission(attempt) => &attempt.scored().flight.ship,
        }
    }

    /// Lets own time pass, in pieces that a voyage takes, and adds them to the track. What happens in it
    /// is seen from the ship.
    pub(super) fn advance(&mut self, time: f64, track: &mut Track) -> Result<(), ShipError> {
        let mut left = time;
        while left > 0.0 {
            let length = left.min(self.voyage().longest_piece());
            let before = self.ship().proper_time();
            let is_over = match self {
                Self::Free(voyage) => voyage.advance(length)?.is_some(),
                Self::Mission(attempt) => {
                    attempt.advance(length)?;
                    let now = attempt.voyage().flight.ship.proper_time();
                    now - before < WHOLE * length
                }
            };
            track.note(self.scored_ship());
            if is_over {
                break;
            }
            left -= length;
        }
        Ok(())
    }

    /// How many goals of a mission are reached.
    pub(super) fn goals_reached(&self) -> usize {
        match self {
            Self::Free(_) => 0,
            Self::Mission(attempt) => attempt.reached().len(),
        }
    }

    /// Whether a mission has come to its end.
    pub(super) fn is_over(&self) -> bool {
        matches!(self, Self::Mission(attempt) if attempt.is_over())
    }

    /// The radii at which the ship must be for the next goal.
    pub(super) fn radii(&self) -> Vec<f64> {
        self.radii_of(&[Quantity::R])
    }

    /// The same, with those at which the lowest and the highest point of the path must be.
    pub(super) fn goal_radii(&self) -> Vec<f64> {
        self.radii_of(&[Quantity::R, Quantity::Periapsis, Quantity::Apoapsis])
    }

    /// The values of these quantities in the conditions of the next goal.
    fn radii_of(&self, quantities: &[Quantity]) -> Vec<f64> {
        let Self::Mission(attempt) = self else {
            return Vec::new();
        };
        let goal = attempt.mission.goals.get(attempt.reached().len());
        let conditions = goal.map_or(&[][..], |goal| &goal.all);
        let radii = conditions
            .iter()
            .filter(|condition| quantities.contains(&condition.quantity))
            .filter(|condition| condition.comparison != Comparison::Equal);
        radii.map(|condition| condition.value).collect()
    }
}
