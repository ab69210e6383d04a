//! Where a ship sees a star: in bent light, with the aberration of the ship's motion.

use super::aim::{Eye, aim};
use super::pose::radius;
use glam::{DMat4, DVec3, DVec4, Vec4Swizzles};
use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::observer::{ObserverKind, observer_matrix};
use lightfall_model::geometry::ship::{Ship, components, rain_axes};
use lightfall_model::geometry::sphere::{angle_between, celestial_frame};
use std::f64::consts::PI;

/// The nose is a guess of the direction of stars at most this far from what it points to, in radians.
const NEAR: f64 = 0.2;

/// Number of halvings that find a direction without spin closely enough for a guess.
const HALVINGS: u32 = 16;

/// The star that a ship's nose points to: the unit direction, in the hole's frame, from which the light
/// that arrives there comes. `None` if it comes from the hole.
pub fn star_ahead(ship: &Ship) -> Option<DVec3> {
    let sky = ShipSky::of(ship)?;
    let (star, _) = sky.eye.sky(sky.of_looking(DVec3::X)?)?;
    Some(star)
}

/// The unit direction, on the ship's axes, of the primary image of a star in the unit direction `star` of
/// the hole's frame. `None` where it is not found, as it may be for a star nearly behind a hole that
/// spins.
pub(super) fn seen_star(ship: &Ship, star: DVec3) -> Option<DVec3> {
    let sky = ShipSky::of(ship)?;
    let nose = sky.of_looking(DVec3::X)?;
    let aim_from = |guess: DVec3| aim(guess, |direction| sky.eye.miss_of_star(direction, star));
    let is_near = |(found, _): &(DVec3, f64)| angle_between(*found, star) < NEAR;
    let near_nose = sky.eye.sky(nose).filter(is_near);
    let seen = near_nose
        .and_then(|_| aim_from(nose))
        .or_else(|| aim_from(sky.guess(star)))?;
    sky.looking_to(seen)
}

/// The sky of the observer that falls from rest at infinity past a ship. It exists on both sides of the
/// horizon.
struct ShipSky {
    eye: Eye,
    /// The tangents toward growing theta and phi at the camera's place.
    tangents: [DVec3; 2],
    /// The axes of `rain` and of the ship, on the Kerr-Schild frame.
    rain: DMat4,
    ship: DMat4,
}

impl ShipSky {
    /// `None` for a ship that nothing describes as a camera.
    fn of(ship: &Ship) -> Option<Self> {
        let (kerr, place) = (ship.kerr(), ship.place());
        let r = radius(kerr, place.r);
        // On the axis every azimuth will do.
        let azimuth = place.azimuth().unwrap_or(0.0);
        let (theta, phi) = (place.theta(), azimuth - kerr.camera_azimuth_lead(r));
        let kind = ObserverKind::Rain;
        let frame = observer_matrix(kerr.spin, kind, [0.0; 3], r, theta, phi).ok()?;
        let [n, theta_hat, phi_hat] = celestial_frame(theta, phi);
        Some(Self {
            eye: Eye { kerr, r, n, frame },
            tangents: [theta_hat, phi_hat],
            rain: rain_axes(&place, azimuth),
            ship: ship.frame(),
        })
    }

    /// A looking direction of the ship on the axes of `rain`.
    fn of_looking(&self, direction: DVec3) -> Option<DVec3> {
        carried(&self.ship, &self.rain, direction)
    }

    /// A looking direction of `rain` on the ship's axes.
    fn looking_to(&self, direction: DVec3) -> Option<DVec3> {
        carried(&self.rain, &self.ship, direction)
    }

    /// Where `rain` would see a star without spin: in the plane of the star and the hole, where rays sweep
    /// a larger angle the farther from outward they look.
    fn guess(&self, star: DVec3) -> DVec3 {
        let away = star
            .reject_from_normalized(self.eye.n)
            .try_normalize()
            .unwrap_or(self.tangents[0]);
        let [theta, phi] = self.tangents.map(|tangent| away.dot(tangent));
        let looking = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            DVec3::new(cos, sin * theta, sin * phi)
        };
        let swept = angle_between(self.eye.n, star);
        let falls_short = |angle: f64| {
            let sky = self.eye.sky(looking(angle));
            sky.is_some_and(|(_, sweeps)| sweeps < swept)
        };
        let [low, _] = bisection([0.0, PI], HALVINGS, falls_short);
        looking(low)
    }
}

/// A looking direction on the axes `from` as one on the axes `to`: light from there has the momentum (1,
/// -d).
fn carried(from: &DMat4, to: &DMat4, direction: DVec3) -> Option<DVec3> {
    let momentum = *from * DVec4::from((1.0, -direction));
    (-components(to, momentum).yzw()).try_normalize()
}
