//! The values of the ship's instruments, in words.

use super::needed::Needed;
use super::quantities::{plunges, present};
use crate::app::motion::ship::{
    LITTLE_FUEL, ShipFlight, acceleration, fuel, heading_words, multiple, tide,
};
use lightfall_core::geometry::ship::Ship;
use lightfall_core::numbers::{four_digits, percent, ratio, three_digits};
use lightfall_core::optics::readout::held_acceleration;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{
    Apsides, Clocks, Flight, Hold, longest_life, speed_for_zamo, tide_of, time_to_apsis,
};
use lightfall_core::scene::ObserverKind;
use lightfall_core::scene::mission::Quantity;

/// An instrument: what it shows, and the value.
#[derive(Clone, Debug, PartialEq)]
pub struct Instrument {
    /// The quantity.
    pub label: &'static str,
    /// Its value with its unit.
    pub value: String,
    /// Whether a narrow window leaves it out.
    pub is_minor: bool,
    /// Whether the smallest window shows it, too: the mission names it.
    pub is_needed: bool,
    /// Whether its value is a warning.
    pub is_warning: bool,
}

impl Instrument {
    pub(super) fn new(label: &'static str, value: String) -> Self {
        Self {
            label,
            value,
            is_minor: false,
            is_needed: false,
            is_warning: false,
        }
    }

    fn minor(label: &'static str, value: String) -> Self {
        Self {
            is_minor: true,
            ..Self::new(label, value)
        }
    }
}

/// The instruments of a ship with a pilot, but for its clocks; `mass` is the hole's. Empty without a
/// pilot.
#[must_use]
pub fn instruments(flown: &ShipFlight, mass: HoleMass, units: Units) -> Vec<Instrument> {
    let mission = flown.attempt().map(|attempt| &attempt.mission);
    instruments_of(flown, &Needed::of(mission), mass, units)
}

/// As [`instruments`], where it is known what the flight needs.
pub(super) fn instruments_of(
    flown: &ShipFlight,
    needed: &Needed,
    mass: HoleMass,
    units: Units,
) -> Vec<Instrument> {
    let Some(voyage) = flown.voyage() else {
        return Vec::new();
    };
    let flight = &voyage.flight;
    let ship = &flight.ship;
    let mut all = vec![
        motion(ship, units),
        tank(flight, units),
        thrust(flight, mass, units),
    ];
    all.extend(path(ship, units));
    all.push(Instrument::new("nose", nose(flown)));
    all.extend(
        flown
            .hold()
            .map(|hold| Instrument::new("held", held(hold, units))),
    );
    all.push(Instrument::new(TIME, time(flown, units)));
    all.push(to_hover(ship, mass, units));
    all.push(Instrument::minor("tide", tide(tide_of(ship), mass)));
    all.extend(signal(ship, units));
    let value = |quantity: Quantity| {
        let attempt = flown.attempt();
        attempt.map_or_else(String::new, |attempt| present(attempt, quantity, units))
    };
    needed.complete(&mut all, value);
    all
}

/// The label of the pace.
pub(super) const TIME: &str = "time";
/// The label of the fuel.
pub(super) const FUEL: &str = "fuel";
/// The label of what stands in place of both turning points inside the horizon.
pub(super) const LIFE: &str = "life left";

/// The radius, and the speed relative to the observer with zero angular momentum.
fn motion(ship: &Ship, units: Units) -> Instrument {
    let r = length(ship.place().r, units);
    let value = match speed_for_zamo(ship) {
        Some(speed) => format!("{r} · {speed:.3} c"),
        None => format!("{r} · inside the horizon"),
    };
    Instrument::new("radius, speed", value)
}

/// The fuel that is left and, for specialists, the mass that is left with it.
fn tank(flight: &Flight, units: Units) -> Instrument {
    let rocket = &flight.rocket;
    let (left, full) = (rocket.left(), rocket.left() + rocket.used());
    let value = if full == 0.0 {
        "no engine".into()
    } else if left == 0.0 {
        "the tank is empty".into()
    } else {
        let left = fuel(left, full, |rapidity| format!("{rapidity:.4}"));
        match units.are_simple() {
            true => left,
            false => format!("{left} · mass {}", percent(rocket.mass())),
        }
    };
    Instrument {
        is_warning: left < LITTLE_FUEL * full,
        ..Instrument::new(FUEL, value)
    }
}

fn thrust(flight: &Flight, mass: HoleMass, units: Units) -> Instrument {
    let thrust = flight.acceleration().length();
    let value = match thrust {
        0.0 => "off".into(),
        _ => acceleration(thrust, mass, units),
    };
    Instrument::new("thrust", value)
}

fn to_hover(ship: &Ship, mass: HoleMass, units: Units) -> Instrument {
    let place = ship.place();
    let limit = place.kerr.static_limit(place.n.z);
    let value = match place.r {
        r if r <= place.kerr.horizon() => "nothing holds a ship here".into(),
        r if r <= limit => "nothing stands still here".into(),
        r => {
            let needed = held_acceleration(place.kerr, ObserverKind::Static, r, place.theta());
            acceleration(needed, mass, units)
        }
    };
    Instrument::minor("to stand still", value)
}

/// The turning points ahead, or what is left of life inside the horizon.
fn path(ship: &Ship, units: Units) -> Vec<Instrument> {
    let place = ship.place();
    let steady = |time: f64| units.steady_time(time);
    if place.r <= place.kerr.horizon() {
        let left = longest_life(place.kerr, place.r, place.n.z);
        let left = format!("at most {}", steady(left));
        return vec![Instrument::new(LIFE, left)];
    }
    let apsides = Apsides::of(ship);
    let next = time_to_apsis(ship);
    let falls = ship.constants().radial < 0.0;
    let point = |radius: Option<f64>, none: &str, is_next: bool| match (radius, next) {
        (None, _) => none.to_owned(),
        // At the turning point itself the time is zero, or what rounding leaves of it.
        (Some(radius), Some(next)) if is_next && next < 1e-3 => {
            format!("{}, now", length(radius, units))
        }
        (Some(radius), Some(next)) if is_next => {
            format!("{}, in {}", length(radius, units), steady(next))
        }
        (Some(radius), _) => length(radius, units),
    };
    let lowest = Instrument::new(
        "lowest point",
        point(apsides.periapsis, "in the hole", falls),
    );
    // A path that only leads into the hole has none.
    let highest = (!plunges(ship)).then(|| {
        let radius = point(apsides.apoapsis, "none: you come away", !falls);
        Instrument::new("highest point", radius)
    });
    std::iter::once(lowest).chain(highest).collect()
}

/// A radius with three decimals, as missions compare them.
fn length(radius: f64, units: Units) -> String {
    units.length(radius, |radius| match radius {
        radius if radius < 100.0 => format!("{radius:.3}"),
        radius => four_digits(radius),
    })
}

fn nose(flown: &ShipFlight) -> String {
    match flown.heading() {
        Some(heading) => heading_words(heading).into(),
        None => "held by the gyroscopes".into(),
    }
}

fn held(hold: Hold, units: Units) -> String {
    match hold {
        Hold::Orbit(r) => format!("orbit at {}", length(r, units)),
        Hold::Hover(r) => format!("still at {}", length(r, units)),
        Hold::Zamo(r) => format!("radius {}", length(r, units)),
    }
}

fn time(flown: &ShipFlight, units: Units) -> String {
    let rate = units.time(flown.rate(), three_digits);
    format!("{} ×, {rate} a second", multiple(flown.pace()))
}

/// How long a signal takes to reach home, and by how much home's light is shifted.
fn signal(ship: &Ship, units: Units) -> Option<Instrument> {
    let clocks = Clocks::new(ship);
    let light = format!("home's light × {}", ratio(clocks.home_light));
    let value = match clocks.signal_delay {
        Some(delay) => format!("{} · {light}", units.steady_time(delay)),
        None => format!("reaches nobody · {light}"),
    };
    Some(Instrument::minor("signal home", value))
}
