//! The quantities that conditions of missions compare.

use super::apsides::Apsides;
use super::clocks::Clocks;
use super::flight::{Event, Flight};
use super::heading::{motion_rate, speed_for_zamo};
use super::life::radial_life;
use super::records::{Records, tide_of};
use crate::readout::si::HoleMass;
use glam::DVec3;
use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::ship::{Ship, ShipError, VectorConstants, minkowski};
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_model::numbers::YEAR;
use lightfall_model::scene::Disk;
use lightfall_model::scene::mission::{Condition, Quantity};
use std::f64::consts::TAU;

/// The longest piece of a voyage, as an angle of the motion: turns are counted, and conditions looked
/// at, at the end of each.
const MAX_PIECE: f64 = 0.3;

/// Number of halvings that find when something happens to the last digit.
const HALVINGS: u32 = 52;

/// How far from the plane of a disk, as a cosine, a ship counts as in the gas of a disk.
const IN_GAS: f64 = 1e-3;

/// A flight, with what its quantities need to know of its past.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Voyage {
    /// The flight.
    pub flight: Flight,
    mass: HoleMass,
    /// The normal of the disk, in the hole's frame.
    disk_normal: DVec3,
    /// E at the start, with a full tank.
    start_energy: f64,
    /// Boyer-Lindquist's azimuth since the start, in radians; outside the horizon only.
    azimuth: f64,
    /// The own time at which the ship crossed the horizon inward.
    crossing: Option<f64>,
    records: Records,
}

impl Voyage {
    /// A voyage around a hole of this mass with this disk, which begins now.
    pub fn new(flight: Flight, mass: HoleMass, disk: &Disk) -> Self {
        let (kerr, r) = (flight.ship.kerr(), flight.ship.place().r);
        Self {
            records: Records::new(&flight),
            flight,
            mass,
            disk_normal: disk.hole_from_disk().z_axis,
            start_energy: flight.ship.constants().energy * flight.rocket.mass(),
            azimuth: 0.0,
            crossing: (r <= kerr.horizon()).then_some(0.0),
        }
    }

    /// The extremes of the flight so far.
    pub fn records(&self) -> &Records {
        &self.records
    }

    /// The longest own time to advance at once, in r_s/c.
    pub fn longest_piece(&self) -> f64 {
        MAX_PIECE / motion_rate(&self.flight.ship)
    }

    /// Advances by at most [`longest_piece`](Self::longest_piece).
    ///
    /// # Errors
    /// As those of [`Ship::advance`].
    pub fn advance(&mut self, proper_time: f64) -> Result<Option<Event>, ShipError> {
        let before = self.flight;
        let event = self.pass(proper_time)?;
        self.records.add(&before, &self.flight);
        Ok(event)
    }

    /// As [`advance`](Self::advance), without the records.
    fn pass(&mut self, proper_time: f64) -> Result<Option<Event>, ShipError> {
        let before = *self;
        let event = self.flight.advance(proper_time)?;
        let outside = |ship: &Ship| ship.place().r > ship.kerr().horizon();
        let (from, to) = (&before.flight.ship, &self.flight.ship);
        if outside(to) {
            self.azimuth += wrap_angle(far_azimuth(to) - far_azimuth(from));
        } else if self.crossing.is_none() {
            let length = to.proper_time() - from.proper_time();
            let [crossing, _] = bisection([0.0, length], HALVINGS, |time| {
                let mut middle = before.flight;
                middle.advance(time).is_ok() && outside(&middle.ship)
            });
            self.crossing = Some(from.proper_time() + crossing);
        }
        Ok(event)
    }

    /// The voyage at an own time between that of `self` and that of a later state of it.
    pub(super) fn on_to(&self, proper_time: f64) -> Result<Self, ShipError> {
        let mut voyage = *self;
        voyage.advance(self.until(proper_time))?;
        Ok(voyage)
    }

    /// As [`on_to`](Self::on_to), to look at conditions: without the records.
    pub(super) fn at(&self, proper_time: f64) -> Result<Self, ShipError> {
        let mut voyage = *self;
        voyage.pass(self.until(proper_time))?;
        Ok(voyage)
    }

    fn until(&self, proper_time: f64) -> f64 {
        (proper_time - self.flight.ship.proper_time()).max(0.0)
    }

    /// Whether all these conditions hold.
    pub fn meets(&self, conditions: &[Condition]) -> bool {
        conditions
            .iter()
            .all(|condition| condition.holds(self.quantity(condition.quantity)))
    }

    /// The own time, between now and `end`, at which `is_so` becomes true. It is false now and true at
    /// `end`.
    pub(super) fn moment(&self, end: f64, is_so: impl Fn(&Self) -> bool) -> f64 {
        let start = self.flight.ship.proper_time();
        let [_, after] = bisection([start, end], HALVINGS, |time| {
            self.at(time).is_ok_and(|voyage| !is_so(&voyage))
        });
        after
    }

    /// A quantity now; `None` where it is not known.
    pub fn quantity(&self, quantity: Quantity) -> Option<f64> {
        let Self { flight, mass, .. } = self;
        let ship = &flight.ship;
        let place = ship.place();
        let years = mass.seconds() / YEAR;
        let outside = place.r > place.kerr.horizon();
        let far = || Clocks::new(ship).far;
        Some(match quantity {
            Quantity::R => place.r,
            Quantity::ThetaDeg => place.theta().to_degrees(),
            Quantity::Tau => ship.proper_time(),
            Quantity::T => far()?,
            Quantity::TauYears => ship.proper_time() * years,
            Quantity::TYears => far()? * years,
            Quantity::Rate => Clocks::new(ship).far_rate?,
            Quantity::Energy => ship.constants().energy,
            Quantity::AngularMomentum => ship.constants().angular_momentum,
            Quantity::CarterQ => ship.constants().carter_q(&place),
            Quantity::Periapsis => Apsides::of(ship).periapsis.unwrap_or(0.0),
            Quantity::Apoapsis if outside => Apsides::of(ship).apoapsis.unwrap_or(f64::INFINITY),
            Quantity::Apoapsis => return None,
            Quantity::Turns => self.azimuth.abs() / TAU,
            Quantity::Speed => speed_for_zamo(ship)?,
            Quantity::GasSpeed => gas_speed(ship, self.disk_normal)?,
            Quantity::Thrust => flight.acceleration().length(),
            Quantity::RapidityUsed => flight.rocket.used(),
            Quantity::RotationUsedDeg => flight.turned().to_degrees(),
            Quantity::EnergyRatio => {
                flight.rocket.mass() * ship.constants().energy / self.start_energy
            }
            Quantity::LifeInside => self.life_inside(),
            Quantity::Tide => tide_of(ship),
            Quantity::GLoad => flight.acceleration().length() * mass.gees(),
        })
    }

    fn life_inside(&self) -> f64 {
        let ship = &self.flight.ship;
        let Some(crossing) = self.crossing else {
            return 0.0;
        };
        let lived = ship.proper_time() - crossing;
        if ship.kerr().spin == 0.0 {
            lived + radial_life(ship.place().r, ship.constants().energy)
        } else {
            lived
        }
    }
}

/// Boyer-Lindquist's azimuth outside the horizon; on the axis any.
fn far_azimuth(ship: &Ship) -> f64 {
    let place = ship.place();
    place.azimuth().unwrap_or(0.0) - place.kerr.camera_azimuth_lead(place.r)
}

/// The speed relative to matter on the circular orbit at the ship's place, in the plane of the disk with
/// this normal. Only without spin are there disks in another plane than the equator.
fn gas_speed(ship: &Ship, normal: DVec3) -> Option<f64> {
    let place = ship.place();
    let orbit = place.kerr.circular_orbit(place.r)?;
    if place.n.dot(normal).abs() > IN_GAS {
        return None;
    }
    let gas = VectorConstants {
        energy: orbit.energy,
        angular_momentum: orbit.angular_momentum * normal.z,
        radial: 0.0,
        w: orbit.angular_momentum * normal.cross(place.n).normalize(),
        mass2: 1.0,
    }
    .vector(&place);
    let gamma = -minkowski(ship.velocity(), gas);
    Some((1.0 - 1.0 / (gamma * gamma)).max(0.0).sqrt())
}
