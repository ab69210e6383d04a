//! The extremes of a flight, whatever the lengths of its frames.

use super::flight::Flight;
use crate::readout::tide;
use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::ship::Ship;

/// Two moments that tell whether a quantity rises are this share of a piece apart. A maximum nearer
/// than this to an end of a piece is taken for the end, which differs by less than 1e-10 of it: a
/// piece is at most 0.3 radians of the motion.
const APART: f64 = 1e-5;

/// Number of halvings that find a maximum. A quantity differs from its maximum by the square of what
/// is left.
const HALVINGS: u32 = 30;

/// The extremes of a flight so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Records {
    /// The largest proper acceleration, in c^2/r_s.
    pub acceleration: f64,
    /// The largest tidal stretching, in c^2/r_s^2.
    pub tide: f64,
    /// The smallest radius, in r_s.
    pub lowest: f64,
}

impl Records {
    /// Those of a flight that begins.
    pub(super) fn new(flight: &Flight) -> Self {
        Self {
            acceleration: 0.0,
            tide: tide_of(&flight.ship),
            lowest: flight.ship.place().r,
        }
    }

    /// Adds those of a piece of the flight between two states under the same orders. A maximum between
    /// its ends is found by bisection.
    pub(super) fn add(&mut self, before: &Flight, after: &Flight) {
        let height = |ship: &Ship| -ship.place().r;
        self.acceleration = self.acceleration.max(after.peak_acceleration());
        self.tide = self.tide.max(maximum(before, after, tide_of));
        self.lowest = self.lowest.min(-maximum(before, after, height));
    }
}

/// The largest tidal stretching at a ship, in c^2/r_s^2.
pub fn tide_of(ship: &Ship) -> f64 {
    let place = ship.place();
    tide(
        place.kerr,
        place.r,
        place.n,
        &ship.constants().photon(&place),
    )
}

/// The largest value of a quantity between two states of a flight that are so near to each other that
/// it has one maximum at most between them.
fn maximum(before: &Flight, after: &Flight, of: impl Fn(&Ship) -> f64) -> f64 {
    let ends = of(&before.ship).max(of(&after.ship));
    let passed = after.ship.proper_time() - before.ship.proper_time();
    let apart = APART * passed;
    let at = |time: f64| {
        let mut flight = *before;
        flight.advance(time).ok()?;
        Some(of(&flight.ship))
    };
    let rises = |time: f64| at(time + apart) > at(time);
    let last = passed - apart;
    if !(passed > 0.0 && rises(0.0) && !rises(last)) {
        return ends;
    }
    let [time, _] = bisection([0.0, last], HALVINGS, rises);
    at(time).map_or(ends, |found| ends.max(found))
}
