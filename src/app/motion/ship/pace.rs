//! How fast the ship's own time passes, and where faster time ends by itself.

use lightfall_core::geometry::bisection::bisection;
use lightfall_core::geometry::ship::ShipError;
use lightfall_core::optics::ship::{Apsides, Rocket, Voyage, time_to_apsis};

/// Own time that passes in a second, divided by r^(3/2), at the usual pace: that of a fall.
const USUAL_PACE: f64 = 0.1;
/// One press changes the pace by this factor.
pub(super) const PACE_STEP: f64 = 2.0;
/// The slowest pace, as a multiple of the usual one.
pub(super) const SLOWEST: f64 = 1.0 / 1024.0;
/// A full tank lasts at least so many seconds at full thrust by hand, so that a press of a key can be
/// short enough.
const TANK_SECONDS: f64 = 30.0;
/// Faster time ends where the ship comes down to so many radii of the horizon.
const NEAR_HORIZON: f64 = 1.2;
/// Faster time does not end nearer to its beginning than this share of r^(3/2).
const LEAST_TIME: f64 = 1e-3;
/// Number of halvings that find when the ship passes a radius.
const HALVINGS: u32 = 30;

/// What the engine does, as far as the pace depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// Nothing.
    Off,
    /// It pushes as the hand says.
    Hand,
    /// It holds the ship.
    Hold,
}

impl Engine {
    /// The fastest pace, as a multiple of the usual one.
    #[must_use]
    pub fn fastest(self) -> f64 {
        match self {
            Self::Off => 1024.0,
            Self::Hold => 16.0,
            Self::Hand => 4.0,
        }
    }
}

/// Own time, in r_s/c, that passes in a second at the radius `r`. `pace` is a multiple of the usual
/// one. While the hand pushes, a full tank lasts some seconds whatever the radius.
#[must_use]
pub fn own_time_rate(r: f64, pace: f64, engine: Engine, rocket: &Rocket) -> f64 {
    let rate = USUAL_PACE * r.powf(1.5) * pace.min(engine.fastest());
    let tank = rocket.left() + rocket.used();
    let longest_burn = tank / rocket.max_acceleration();
    match engine {
        Engine::Hand if longest_burn.is_finite() => {
            rate.min(longest_burn / TANK_SECONDS * pace.min(1.0))
        }
        _ => rate,
    }
}

/// Where faster time ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// At the lowest point of the path.
    Low,
    /// At its highest point.
    High,
    /// At the radius of a goal.
    Goal,
    /// Near the horizon.
    Horizon,
}

/// The first stop of a ship that coasts or is held, within the own time `time`: when, and which.
/// `radii` are those of the goals.
pub(super) fn first_stop(voyage: &Voyage, time: f64, radii: &[f64]) -> Option<(f64, Stop)> {
    let ship = &voyage.flight.ship;
    let place = ship.place();
    let least = LEAST_TIME * place.r.powf(1.5);
    let coasts = voyage.flight.acceleration().length() == 0.0;
    let apsis = (coasts && !Apsides::of(ship).are_round())
        .then(|| time_to_apsis(ship))
        .flatten()
        .map(|after| {
            let falls = ship.constants().radial < 0.0;
            (after, if falls { Stop::Low } else { Stop::High })
        });
    let near = NEAR_HORIZON * place.kerr.horizon();
    let goals = radii.iter().map(|radius| (*radius, Stop::Goal));
    let passed = goals
        .chain((place.r > near).then_some((near, Stop::Horizon)))
        .filter_map(|(radius, stop)| Some((passing(voyage, time, radius)?, stop)));
    passed
        .chain(apsis)
        .filter(|(after, _)| (least..=time).contains(after))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// When the voyage passes a radius within `time`.
fn passing(voyage: &Voyage, time: f64, radius: f64) -> Option<f64> {
    let is_above = |after: f64| {
        let mut ahead = voyage.flight;
        ahead.advance(after).is_ok() && ahead.ship.place().r > radius
    };
    let before = voyage.flight.ship.place().r > radius;
    if is_above(time) == before {
        return None;
    }
    let [_, after] = bisection([0.0, time], HALVINGS, |after| is_above(after) == before);
    Some(after)
}

/// Lets own time pass, in pieces that a voyage takes. What happens in it is seen from the ship.
pub(super) fn move_on(voyage: &mut Voyage, time: f64) -> Result<(), ShipError> {
    let mut left = time;
    while left > 0.0 {
        let length = left.min(voyage.longest_piece());
        if voyage.advance(length)?.is_some() {
            break;
        }
        left -= length;
    }
    Ok(())
}
