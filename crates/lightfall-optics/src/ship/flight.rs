//! A ship under orders, in frames of time whose lengths do not matter.
//!
//! What an autopilot or a course commands is constant during a tick. A tick depends on the ship's
//! state alone, and a frame may end in the middle of one, so that a flight is the same for every rate
//! of frames.

use super::heading::{Heading, motion_rate, turn_to};
use super::holds::{Hold, HoldRefusal};
use super::rocket::Rocket;
use glam::{DMat3, DQuat, DVec3};
use lightfall_model::geometry::ship::{Controls, Ship, ShipError};
use lightfall_model::geometry::timelike::Limit;

/// Length of a tick, as an angle of the motion: it lasts this over [`motion_rate`].
pub const TICK: f64 = 0.02;

/// The largest turn of a tick toward a heading, in radians.
const MAX_TURN: f64 = 0.2;

/// What the engine does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Thrust {
    /// Nothing.
    Off,
    /// This proper acceleration on the ship's axes, in c^2/r_s.
    Axes(DVec3),
    /// This proper acceleration along a heading, in c^2/r_s.
    Along(Heading, f64),
    /// What a hold needs, up to this proper acceleration, in c^2/r_s.
    Hold(Hold, f64),
}

/// What the pilot orders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orders {
    /// What the engine does. The engine's own limit comes on top.
    pub thrust: Thrust,
    /// Rotation by hand, on the ship's axes, in radians per r_s/c of own time.
    pub rotation: DVec3,
    /// What the nose follows, in place of the gyroscopes and the hand.
    pub face: Option<Heading>,
}

impl Orders {
    /// Engine off, hands off.
    pub const COAST: Self = Self {
        thrust: Thrust::Off,
        rotation: DVec3::ZERO,
        face: None,
    };

    /// Whether the controls stay the same for as long as the orders do.
    fn are_steady(&self) -> bool {
        matches!(self.thrust, Thrust::Off | Thrust::Axes(_)) && self.face.is_none()
    }
}

/// Controls that stay for some time.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tick {
    controls: Controls,
    left: f64,
}

/// What happened in an advance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The ship reached a limit, where the flight ends.
    Limit(Limit),
    /// The hold is not possible any more: the engine is off now.
    Refused(HoldRefusal),
}

/// A ship with a rocket, under orders.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight {
    /// The ship.
    pub ship: Ship,
    /// Its rocket.
    pub rocket: Rocket,
    /// The direction on the ship's axes that follows `face`.
    pub nose: DVec3,
    orders: Orders,
    tick: Option<Tick>,
    acceleration: DVec3,
    peak_acceleration: f64,
    turned: f64,
}

impl Flight {
    /// A ship that coasts, with its nose along its first axis.
    pub fn new(ship: Ship, rocket: Rocket) -> Self {
        Self {
            ship,
            rocket,
            nose: DVec3::X,
            orders: Orders::COAST,
            tick: None,
            acceleration: DVec3::ZERO,
            peak_acceleration: 0.0,
            turned: 0.0,
        }
    }

    /// The orders that hold now.
    pub fn orders(&self) -> &Orders {
        &self.orders
    }

    /// Gives other orders. The same orders again change nothing.
    pub fn order(&mut self, orders: Orders) {
        if orders != self.orders {
            (self.orders, self.tick) = (orders, None);
        }
        if orders.thrust == Thrust::Off {
            self.acceleration = DVec3::ZERO;
        }
    }

    /// Turns the ship at once, by hand: about this axis on the ship's axes, by its length in radians.
    pub fn turn(&mut self, rotation: DVec3) {
        if rotation != DVec3::ZERO {
            self.ship
                .turn(DMat3::from_quat(DQuat::from_scaled_axis(rotation)));
            self.turned += rotation.length();
            // What a tick commands is on the axes before the turn.
            self.tick = None;
        }
    }

    /// The proper acceleration of the engine now, in c^2/r_s on the ship's axes.
    pub fn acceleration(&self) -> DVec3 {
        self.acceleration
    }

    /// The largest proper acceleration so far, in c^2/r_s.
    pub fn peak_acceleration(&self) -> f64 {
        self.peak_acceleration
    }

    /// By how much the ship was turned against its gyroscopes so far, by hand or by `face`, in
    /// radians.
    pub fn turned(&self) -> f64 {
        self.turned
    }

    /// Lets `proper_time` (r_s/c, not negative) pass on the ship's clock, or less if something
    /// happens.
    ///
    /// # Errors
    /// As those of [`Ship::advance`].
    pub fn advance(&mut self, proper_time: f64) -> Result<Option<Event>, ShipError> {
        if !(proper_time >= 0.0 && proper_time.is_finite()) {
            return Err(ShipError::Duration(proper_time));
        }
        let mut left = proper_time;
        while left > 0.0 {
            let tick = match self.tick {
                Some(tick) => tick,
                None => match self.next_tick()? {
                    Ok(tick) => tick,
                    Err(refusal) => {
                        self.order(Orders {
                            thrust: Thrust::Off,
                            ..self.orders
                        });
                        return Ok(Some(Event::Refused(refusal)));
                    }
                },
            };
            self.acceleration = tick.controls.acceleration;
            let length = left.min(tick.left);
            let before = self.ship.proper_time();
            let limit = self.ship.advance(&tick.controls, length)?;
            // Less than the rounding of the clock empties a tank as well: the clock's difference would
            // leave a rest for ever.
            let passed = match limit {
                Some(_) => self.ship.proper_time() - before,
                None => length,
            };
            let size = tick.controls.acceleration.length();
            self.peak_acceleration = self.peak_acceleration.max(size);
            self.rocket.spend(size * passed);
            self.turned += tick.controls.rotation.length() * passed;
            // A tick that ends with the frame, but for rounding, ends.
            let rest = tick.left - length;
            self.tick = (rest > 1e-12 * tick.left).then_some(Tick { left: rest, ..tick });
            if let Some(limit) = limit {
                return Ok(Some(Event::Limit(limit)));
            }
            left -= length;
        }
        Ok(None)
    }

    /// The controls of the orders, and for how long they stay. Those that change are the ones of the
    /// middle of the tick, where a ship with those of its start leads: so the flight differs from one
    /// with controls that follow at once by the square of a tick.
    fn next_tick(&self) -> Result<Result<Tick, HoldRefusal>, ShipError> {
        let mut acceleration = match self.wanted(&self.ship) {
            Ok(wanted) => wanted,
            Err(refusal) => return Ok(Err(refusal)),
        };
        let length = if self.orders.are_steady() {
            f64::INFINITY
        } else {
            let length = TICK / motion_rate(&self.ship);
            let mut middle = self.ship;
            middle.advance(
                &Controls {
                    acceleration,
                    rotation: DVec3::ZERO,
                },
                0.5 * length,
            )?;
            // A hold that is refused so soon is refused at the next tick.
            acceleration = self.wanted(&middle).unwrap_or(acceleration);
            length
        };
        // The tank empties at the end of a tick.
        let length = length.min(self.rocket.time_left(acceleration.length()));
        let rotation = match self.orders.face {
            Some(heading) => self.rotation_toward(heading, acceleration, length)?,
            None => self.orders.rotation,
        };
        Ok(Ok(Tick {
            controls: Controls {
                acceleration,
                rotation,
            },
            left: length,
        }))
    }

    /// The acceleration that the orders want of a ship, as far as the engine gives it.
    fn wanted(&self, ship: &Ship) -> Result<DVec3, HoldRefusal> {
        let wanted = match self.orders.thrust {
            Thrust::Off => DVec3::ZERO,
            Thrust::Axes(acceleration) => acceleration,
            Thrust::Along(heading, size) => heading
                .direction(ship)
                .map_or(DVec3::ZERO, |direction| size * direction),
            Thrust::Hold(hold, most) => {
                hold.acceleration(ship, most.min(self.rocket.max_acceleration()))?
            }
        };
        Ok(wanted.clamp_length_max(self.rocket.max_acceleration()))
    }

    /// The rotation with which the nose is at the heading when the tick ends. Where the heading will
    /// be is seen from a ship that flies ahead.
    fn rotation_toward(
        &self,
        heading: Heading,
        acceleration: DVec3,
        length: f64,
    ) -> Result<DVec3, ShipError> {
        let mut ahead = self.ship;
        ahead.advance(
            &Controls {
                acceleration,
                rotation: DVec3::ZERO,
            },
            length,
        )?;
        let Some(direction) = heading.direction(&ahead) else {
            return Ok(DVec3::ZERO);
        };
        let turn = DQuat::from_mat3(&turn_to(self.nose, direction)).to_scaled_axis();
        Ok(turn.clamp_length_max(MAX_TURN) / length)
    }
}
