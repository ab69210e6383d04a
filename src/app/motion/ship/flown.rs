//! What the ship flies: freely, or on a mission.

use super::pace::move_on;
use glam::DVec3;
use lightfall_core::geometry::ship::{Ship, ShipError};
use lightfall_core::optics::ship::{Attempt, Orders, Voyage};
use lightfall_core::scene::mission::{Comparison, Quantity};

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

    pub(super) fn advance(&mut self, time: f64) -> Result<(), ShipError> {
        match self {
            Self::Free(voyage) => move_on(voyage, time),
            Self::Mission(attempt) => attempt.advance(time).map(drop),
        }
    }

    /// How many goals of a mission are reached.
    pub(super) fn goals_reached(&self) -> usize {
        match self {
            Self::Free(_) => 0,
            Self::Mission(attempt) => attempt.reached().len(),
        }
    }

    /// The radii in the conditions of the next goal.
    pub(super) fn radii(&self) -> Vec<f64> {
        let Self::Mission(attempt) = self else {
            return Vec::new();
        };
        let goal = attempt.mission.goals.get(attempt.reached().len());
        let conditions = goal.map_or(&[][..], |goal| &goal.all);
        let radii = conditions
            .iter()
            .filter(|condition| condition.quantity == Quantity::R)
            .filter(|condition| condition.comparison != Comparison::Equal);
        radii.map(|condition| condition.value).collect()
    }
}
