//! What an autopilot does to hold a ship on a circle or in its place.

use super::heading::motion_rate;
use crate::readout::held_acceleration_components;
use glam::{DMat4, DVec2, DVec3, DVec4, Vec4Swizzles};
use lightfall_model::geometry::ship::{Place, Ship, VectorConstants, boost, components, zamo_axes};
use lightfall_model::geometry::sphere::celestial_frame;
use lightfall_model::scene::ObserverKind;
use thiserror::Error;

/// In how much of the motion's time scale, in radians, a hold takes away what the velocity differs
/// by.
const RESPONSE: f64 = 0.16;

/// Largest radial speed at which a hold goes back to its radius, in c.
const MAX_RETURN_SPEED: f64 = 0.3;

/// A hold at a radius in r_s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// On a circle, at the present inclination.
    Orbit(f64),
    /// At rest relative to the stars.
    Hover(f64),
    /// With zero angular momentum: at rest as far as the hole's rotation allows.
    Zamo(f64),
}

/// Why a hold is not possible here.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum HoldRefusal {
    /// Everything inside falls.
    #[error("nothing holds a ship at and inside the horizon, at {horizon:.4} r_s")]
    Inside {
        /// Its radius, in r_s.
        horizon: f64,
    },
    /// The hole's rotation carries everything along.
    #[error(
        "nothing stands still in the ergosphere, which reaches to {limit:.4} r_s here: the hole's rotation carries everything along"
    )]
    Ergosphere {
        /// The static limit at this place, in r_s.
        limit: f64,
    },
    /// No free circle is slower than light.
    #[error("even light does not circle here, at r = {r:.4} r_s")]
    NoOrbit {
        /// The radius, in r_s.
        r: f64,
    },
}

/// The four-velocity that a hold steers to, and the acceleration that it has itself, on the
/// Kerr-Schild frame.
struct Target {
    velocity: DVec4,
    acceleration: DVec4,
}

impl Hold {
    /// The proper acceleration, on the ship's axes, that takes the ship to what this hold wants: at
    /// most `max_acceleration` (c^2/r_s). Constant thrust for at most [`TICK`](super::TICK) of the
    /// motion's time scale follows it closely.
    ///
    /// # Errors
    /// There is no such hold here.
    pub fn acceleration(self, ship: &Ship, max_acceleration: f64) -> Result<DVec3, HoldRefusal> {
        let time = RESPONSE / motion_rate(ship);
        Ok(steer(
            ship,
            &self.target(ship, time)?,
            time,
            max_acceleration,
        ))
    }

    /// The rapidity between the ship's velocity and the one of this hold: what the change takes before the
    /// hold needs its own thrust.
    ///
    /// # Errors
    /// There is no such hold here.
    pub fn rapidity(self, ship: &Ship) -> Result<f64, HoldRefusal> {
        let target = self.target(ship, RESPONSE / motion_rate(ship))?;
        let difference = components(&ship.frame(), target.velocity).yzw();
        Ok(difference.length().asinh())
    }

    /// What the hold steers to, and goes back to its radius in about the time `time`.
    fn target(self, ship: &Ship, time: f64) -> Result<Target, HoldRefusal> {
        let place = ship.place();
        let kerr = place.kerr;
        // Azimuths matter in no hold, so any will do on the axis.
        let zamo =
            zamo_axes(&place, place.azimuth().unwrap_or(0.0)).ok_or(HoldRefusal::Inside {
                horizon: kerr.horizon(),
            })?;
        let back =
            |r: f64| ((r - place.r) / (2.0 * time)).clamp(-MAX_RETURN_SPEED, MAX_RETURN_SPEED);
        match self {
            Self::Orbit(r) => orbit(ship, &place, &zamo, back(r)),
            Self::Hover(r) => at_rest(&place, back(r)),
            Self::Zamo(r) => Ok(with_zamo(&place, &zamo, back(r))),
        }
    }
}

/// The speed of the circular free motion at the ship's place, in c, relative to the observer with zero
/// angular momentum; toward growing theta and phi, along the ship's own motion across the radius, or
/// toward growing phi without one.
///
/// # Errors
/// There is no such motion.
pub fn circular_velocity(ship: &Ship) -> Result<DVec2, HoldRefusal> {
    let place = ship.place();
    let zamo = zamo_axes(&place, place.azimuth().unwrap_or(0.0));
    let zamo = zamo.ok_or(HoldRefusal::Inside {
        horizon: place.kerr.horizon(),
    })?;
    circular(ship, &place, &zamo)
}

/// The turning radius of a tangential motion stays where dR/dr = 4 P E r - (2 r - 1)(r^2 + K') - 2 r
/// Delta vanishes, with R = P^2 - Delta (r^2 + K') (Bardeen, Press & Teukolsky 1972 eq. 2.10). Divided
/// by gamma^2 it is quadratic in the speed v, since E, L and c are linear in (gamma, gamma v). At rest
/// it is negative, and the orbit's speed is the smallest root.
fn circular(ship: &Ship, place: &Place, zamo: &DMat4) -> Result<DVec2, HoldRefusal> {
    let across = components(zamo, ship.velocity()).zw();
    // What is smaller is rounding.
    let along = if across.length() > 1e-12 {
        across.normalize()
    } else {
        DVec2::Y
    };
    let r = place.r;
    let pull = |speed: f64| {
        let u = *zamo * DVec4::new(1.0, 0.0, speed * along.x, speed * along.y);
        let constants = VectorConstants::new(place, u);
        // For u / gamma the square of the mass is 1 - v^2.
        let mass2 = 1.0 - speed * speed;
        let k_prime = constants.carter_vector(place).length_squared()
            + (place.kerr.a() * place.n.z).powi(2) * mass2;
        4.0 * constants.p(place) * constants.energy * r
            - (2.0 * r - 1.0) * (r * r * mass2 + k_prime)
            - 2.0 * r * place.kerr.delta(r) * mass2
    };
    // The quadratic through three of its values.
    let [at_rest, forward, backward] = [0.0, 1.0, -1.0].map(pull);
    let linear = 0.5 * (forward - backward);
    let square = 0.5 * (forward + backward) - at_rest;
    let root = (linear * linear - 4.0 * at_rest * square).sqrt();
    let speed = -2.0 * at_rest / (linear + root);
    if speed > 0.0 && speed < 1.0 {
        Ok(speed * along)
    } else {
        Err(HoldRefusal::NoOrbit { r })
    }
}

fn orbit(ship: &Ship, place: &Place, zamo: &DMat4, back: f64) -> Result<Target, HoldRefusal> {
    let velocity = circular(ship, place, zamo)?;
    let gamma = 1.0 / (1.0 - velocity.length_squared()).sqrt();
    let circling = *zamo * boost(gamma * DVec3::new(0.0, velocity.x, velocity.y));
    Ok(Target {
        velocity: moving(circling.x_axis, circling.y_axis, back),
        acceleration: DVec4::ZERO,
    })
}

/// The observer at rest: u = d_t/sqrt(1 - 2 M r/Sigma), with the radial axis E = L = w = 0, V =
/// sqrt(Sigma Delta).
fn at_rest(place: &Place, back: f64) -> Result<Target, HoldRefusal> {
    let limit = place.kerr.static_limit(place.n.z);
    if place.r <= limit {
        return Err(HoldRefusal::Ergosphere { limit });
    }
    let (sigma, delta) = (place.sigma(), place.kerr.delta(place.r));
    let u = place.on_frame(DVec4::X) / (1.0 - place.r / sigma).sqrt();
    let outward = VectorConstants {
        energy: 0.0,
        angular_momentum: 0.0,
        radial: (sigma * delta).sqrt(),
        w: DVec3::ZERO,
        mass2: -1.0,
    }
    .vector(place);
    let [_, theta_hat, _] = celestial_frame(place.theta(), place.azimuth().unwrap_or(0.0));
    let along_theta = place.on_frame(DVec4::from((0.0, place.spread(theta_hat))) / sigma.sqrt());
    Ok(Target {
        velocity: moving(u, outward, back),
        acceleration: held(place, ObserverKind::Static, outward, along_theta),
    })
}

fn with_zamo(place: &Place, zamo: &DMat4, back: f64) -> Target {
    Target {
        velocity: moving(zamo.x_axis, zamo.y_axis, back),
        acceleration: held(place, ObserverKind::Zamo, zamo.y_axis, zamo.z_axis),
    }
}

fn held(place: &Place, kind: ObserverKind, outward: DVec4, along_theta: DVec4) -> DVec4 {
    let [radial, polar] = held_acceleration_components(place.kerr, kind, place.r, place.theta());
    radial * outward + polar * along_theta
}

/// The four-velocity of a body that moves with the speed `speed` along `outward` for `u`.
fn moving(u: DVec4, outward: DVec4, speed: f64) -> DVec4 {
    (u + speed * outward) / (1.0 - speed * speed).sqrt()
}

/// The thrust that changes the ship's velocity to the target's in the time `time`: the target's own
/// acceleration, and the rapidity between the two per time along its direction. Where it is too
/// large, the former comes first.
fn steer(ship: &Ship, target: &Target, time: f64, max_acceleration: f64) -> DVec3 {
    let frame = ship.frame();
    let own = components(&frame, target.acceleration).yzw();
    // sinh of the rapidity, along its direction.
    let difference = components(&frame, target.velocity).yzw();
    let size = difference.length();
    let rate = if size > 0.0 {
        difference * (size.asinh() / (size * time))
    } else {
        DVec3::ZERO
    };
    let wanted = own + rate;
    if wanted.length() <= max_acceleration {
        return wanted;
    }
    if own.length() >= max_acceleration {
        return own.normalize_or_zero() * max_acceleration;
    }
    // The largest share k of the rest with |own + k rate| = max_acceleration.
    let (a, b) = (rate.length_squared(), own.dot(rate));
    let c = own.length_squared() - max_acceleration * max_acceleration;
    let share = -c / (b + (b * b - a * c).sqrt());
    own + share.clamp(0.0, 1.0) * rate
}
