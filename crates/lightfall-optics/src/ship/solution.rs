//! The solution of a mission, flown.

use super::apsides::time_to_apsis;
use super::flight::{Event, Orders, Thrust};
use super::heading::Heading;
use super::holds::{Hold, HoldRefusal};
use super::mission::{Attempt, Outcome};
use super::quantities::Voyage;
use glam::DVec3;
use lightfall_model::geometry::ship::ShipError;
use lightfall_model::scene::mission::{Burn, Push, Until};
use thiserror::Error;

/// The longest own time that a part of a solution may take, in r_s/c.
const MAX_TIME: f64 = 1e4;

/// What is left of a part's time, as a share of the ship's clock, when rounding ends it.
const ROUNDING: f64 = 1e-14;

/// Why a solution cannot be flown.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SolutionError {
    /// A part never ends.
    #[error("solution {0} has not ended after {MAX_TIME} r_s/c")]
    NeverEnds(usize),
    /// A part never ends, because nothing is left in the tank.
    #[error("solution {0} has not ended after {MAX_TIME} r_s/c, because the tank is empty")]
    Empty(usize),
    /// There is no turning point ahead.
    #[error("solution {0} ends at a turning point, and there is none ahead")]
    NoApsis(usize),
    /// A hold is not possible.
    #[error("solution {number}: {refusal}")]
    Refused {
        /// The part, from 1.
        number: usize,
        /// Why.
        refusal: HoldRefusal,
    },
    /// The ship cannot move so.
    #[error(transparent)]
    Ship(#[from] ShipError),
}

/// Flies parts of a solution, one after the other, until they or the attempt are over.
///
/// # Errors
/// A part cannot be flown.
pub fn fly(attempt: &mut Attempt, burns: &[Burn]) -> Result<Outcome, SolutionError> {
    for (index, burn) in burns.iter().enumerate() {
        attempt.order(orders(burn));
        fly_part(attempt, index + 1, burn)?;
        if attempt.is_over() {
            break;
        }
    }
    attempt.order(Orders::COAST);
    Ok(attempt.outcome())
}

fn orders(burn: &Burn) -> Orders {
    let size = burn.acceleration;
    let thrust = match burn.push {
        Push::Off => Thrust::Off,
        Push::Along(course) => Thrust::Along(course.into(), size),
        Push::Axes(axes) => Thrust::Along(Heading::Observer(DVec3::from_array(axes)), size),
        Push::Hover(r) => Thrust::Hold(Hold::Hover(r), size),
        Push::Orbit(r) => Thrust::Hold(Hold::Orbit(r), size),
    };
    Orders {
        thrust,
        ..Orders::COAST
    }
}

fn is_empty(voyage: &Voyage) -> bool {
    voyage.flight.rocket.left() == 0.0
}

fn fly_part(attempt: &mut Attempt, number: usize, burn: &Burn) -> Result<(), SolutionError> {
    let start = attempt.voyage().flight.ship.proper_time();
    let end = match burn.until {
        Until::Passed(time) => start + time,
        Until::Apsis => {
            let time = time_to_apsis(&attempt.voyage().flight.ship);
            start + time.ok_or(SolutionError::NoApsis(number))?
        }
        Until::Holds(_) => start + MAX_TIME,
    };
    loop {
        let before = *attempt.voyage();
        let left = end - before.flight.ship.proper_time();
        if left <= ROUNDING * end {
            return match burn.until {
                Until::Holds(_) if burn.push != Push::Off && is_empty(&before) => {
                    Err(SolutionError::Empty(number))
                }
                Until::Holds(_) => Err(SolutionError::NeverEnds(number)),
                Until::Passed(_) | Until::Apsis => Ok(()),
            };
        }
        let mut after = before;
        let event = after.advance(left.min(before.longest_piece()))?;
        if let Until::Holds(condition) = burn.until {
            let conditions = [condition];
            if after.meets(&conditions) {
                let own = after.flight.ship.proper_time();
                let time = if before.meets(&conditions) {
                    before.flight.ship.proper_time()
                } else {
                    before.moment(own, |voyage| voyage.meets(&conditions))
                };
                attempt.go_on_to(before.on_to(time)?, None)?;
                return Ok(());
            }
        }
        attempt.go_on_to(after, event)?;
        match event {
            Some(Event::Refused(refusal)) => {
                return Err(SolutionError::Refused { number, refusal });
            }
            Some(Event::Limit(_)) => return Ok(()),
            None => {}
        }
        if attempt.is_over() {
            return Ok(());
        }
    }
}
