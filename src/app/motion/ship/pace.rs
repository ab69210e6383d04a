//! How fast the ship's own time passes, and where faster time ends by itself.

use lightfall_core::geometry::bisection::bisection;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::{Apsides, Flight, Rocket, Voyage, time_to_apsis};

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
/// From this radius on, in r_s, a ship that comes away sees nothing new for a long time.
const FAR: f64 = 100.0;
/// There its radius grows by no more than this share of itself in a second of the player's time: from r to
/// r exp(0.5 s) in s seconds.
const GROWTH: f64 = 0.5;
/// Most steps of Newton's method, which doubles the digits in each, and the share of the radius at which
/// it ends.
const MAX_STEPS: usize = 12;
const EXACT: f64 = 1e-13;

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

/// dr/dtau of the ship: V/Sigma.
fn outward_speed(ship: &Ship) -> f64 {
    ship.constants().radial / ship.place().sigma()
}

/// Whether the ship moves outward too fast to come back.
fn comes_away(ship: &Ship) -> bool {
    let constants = ship.constants();
    constants.energy >= 1.0 && constants.radial > 0.0
}

/// The largest own time per second of a ship that comes away, far from the hole. `None` for others.
pub(super) fn far_rate(ship: &Ship) -> Option<f64> {
    let r = ship.place().r;
    (r >= FAR && comes_away(ship)).then(|| GROWTH * r / outward_speed(ship))
}

/// The own time that passes in a frame of so many seconds at this rate, if the ship comes away and would
/// be too far from the hole at the frame's end. The radius at that time depends on the sum of the
/// seconds alone, so it is the same for every length of frames.
pub(super) fn far_time(voyage: &Voyage, rate: f64, seconds: f64) -> Option<f64> {
    let wanted = rate * seconds;
    let r = voyage.flight.ship.place().r;
    if wanted <= 0.0 || !comes_away(&voyage.flight.ship) {
        return None;
    }
    let near = if r < FAR {
        passing(voyage, wanted, FAR)?
    } else {
        0.0
    };
    let mut ahead = voyage.flight;
    ahead.advance(near).ok()?;
    // The seconds of the frame that are left beyond the radius.
    let left = seconds - near / rate;
    let farthest = FAR.max(r) * (GROWTH * left).exp();
    let time = near + time_to_radius(&ahead, farthest)?;
    (time < wanted).then_some(time)
}

/// The own time until a flight that leads outward reaches a radius. `None` if its engine keeps it from
/// there.
fn time_to_radius(flight: &Flight, radius: f64) -> Option<f64> {
    let mut time = 0.0;
    for _ in 0..MAX_STEPS {
        let mut ahead = *flight;
        ahead.advance(time).ok()?;
        let (missing, speed) = (radius - ahead.ship.place().r, outward_speed(&ahead.ship));
        if missing.abs() <= EXACT * radius {
            return Some(time);
        }
        if speed <= 0.0 {
            return None;
        }
        time += missing / speed;
    }
    Some(time)
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
/// `radii` are those of the goals. Turning points are none if it passes them.
pub(super) fn first_stop(
    voyage: &Voyage,
    time: f64,
    radii: &[f64],
    passes_apsides: bool,
) -> Option<(f64, Stop)> {
    let ship = &voyage.flight.ship;
    let place = ship.place();
    let least = LEAST_TIME * place.r.powf(1.5);
    let coasts = voyage.flight.acceleration().length() == 0.0;
    let apsis = (coasts && !passes_apsides && !Apsides::of(ship).are_round())
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
