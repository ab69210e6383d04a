//! What the ship has left: its engine, its fuel, and what a hold takes of it.

use super::ship_flight::ShipFlight;
use lightfall_core::optics::ship::Voyage;

impl ShipFlight {
    /// Whether the ship has an engine. A tank without fuel is one.
    #[must_use]
    pub fn has_engine(&self) -> bool {
        self.voyage().is_some_and(|voyage| {
            let rocket = &voyage.flight.rocket;
            rocket.left() + rocket.used() > 0.0
        })
    }

    /// Whether the engine can push: there is fuel.
    #[must_use]
    pub fn can_push(&self) -> bool {
        self.has_engine() && !self.is_empty()
    }

    /// The fuel that the hold takes to reach its motion, and the fuel that is left, as shares of a full tank.
    #[must_use]
    pub fn hold_takes(&self) -> Option<[f64; 2]> {
        let flight = &self.voyage()?.flight;
        let rapidity = self.hold()?.rapidity(&flight.ship).ok()?;
        let left = flight.rocket.left();
        let tank = left + flight.rocket.used();
        Some([rapidity, left].map(|fuel| fuel / tank))
    }

    /// Whether the tank of its engine is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let is_empty = |voyage: &Voyage| voyage.flight.rocket.left() == 0.0;
        self.has_engine() && self.voyage().is_some_and(is_empty)
    }
}
