//! Where a ship is headed: directions on its own axes, and turns toward them.

use super::star::seen_star;
use glam::{DMat3, DQuat, DVec3, DVec4, Vec4Swizzles};
use lightfall_model::geometry::kerr::MASS;
use lightfall_model::geometry::ship::{Place, Ship, boost, components, rain_axes};

/// A direction that a ship can face or push toward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Heading {
    /// Along its motion relative to the observer with zero angular momentum.
    Prograde,
    /// Against it.
    Retrograde,
    /// Toward the hole: where the principal null ray that comes from it arrives from. Without spin it
    /// is the middle of the shadow.
    Hole,
    /// Away from the hole: where the principal null ray that falls in, home's light, arrives from.
    Outward,
    /// Toward a star in this unit direction of the hole's frame, where its light arrives now: its primary
    /// image in bent light, with the aberration of the ship's motion.
    Star(DVec3),
    /// A direction on the axes of the scene's observer: outward, toward growing theta, toward growing
    /// phi, those of `rain` boosted to the ship without rotation. Off the axis only, since there phi
    /// has no direction.
    Observer(DVec3),
}

impl Heading {
    /// The unit direction on the ship's axes. `None` where there is none: prograde of a ship that
    /// stands still, phi on the axis, a star whose image is not found.
    pub fn direction(self, ship: &Ship) -> Option<DVec3> {
        let place = ship.place();
        match self {
            Self::Prograde => prograde(ship, &place),
            Self::Retrograde => prograde(ship, &place).map(|direction| -direction),
            Self::Hole => seen_from(ship, outgoing_ray(&place)),
            Self::Outward => seen_from(ship, DVec4::from((1.0, -place.n))),
            Self::Star(star) => seen_star(ship, star),
            Self::Observer(direction) => {
                place.azimuth()?;
                let rain = rain_axes(&place, 0.0);
                let momentum = components(&rain, ship.velocity()).yzw();
                let observer = rain * boost(momentum);
                let vector = observer * DVec4::from((0.0, direction));
                components(&ship.frame(), vector).yzw().try_normalize()
            }
        }
    }
}

/// d_t + omega d_phi on the Kerr-Schild frame, with omega = 2 M a r/Y: the direction of the observer
/// with zero angular momentum, which is regular at the horizon. Inside it the vector is spacelike.
fn zamo_direction(place: &Place) -> DVec4 {
    let omega = 2.0 * MASS * place.kerr.a() * place.r / place.area();
    let DVec3 { x, y, .. } = place.position;
    place.on_frame(DVec4::new(1.0, -omega * y, omega * x, 0.0))
}

/// Minus the part of the zero-angular-momentum observer's direction that is orthogonal to u: that
/// observer moves backward for the ship.
fn prograde(ship: &Ship, place: &Place) -> Option<DVec3> {
    let relative = components(&ship.frame(), zamo_direction(place));
    // What is smaller is rounding.
    let is_motion = relative.yzw().length() > 1e-14 * relative.x.abs();
    is_motion.then(|| -relative.yzw().normalize())
}

/// The speed relative to the observer with zero angular momentum, in c; `None` at and inside the
/// horizon.
pub fn speed_for_zamo(ship: &Ship) -> Option<f64> {
    let place = ship.place();
    let relative = components(&ship.frame(), zamo_direction(&place));
    (place.r > place.kerr.horizon()).then(|| relative.yzw().length() / relative.x.abs())
}

/// The momentum of the principal null ray that goes out, which inside the horizon falls in too. With
/// E = Delta/(2 Sigma) it is (r^2 + a^2 - Delta/2, n Delta/2 + a B (z^ x n))/Sigma in coordinates,
/// regular everywhere. Derived from c = 0, V = P.
fn outgoing_ray(place: &Place) -> DVec4 {
    let half = 0.5 * place.kerr.delta(place.r);
    let space = half * place.n + place.kerr.a() * place.spread(place.around());
    place.on_frame(DVec4::from((place.rho2() - half, space)) / place.sigma())
}

/// The direction on the ship's axes from which light with this momentum arrives.
fn seen_from(ship: &Ship, momentum: DVec4) -> Option<DVec3> {
    (-components(&ship.frame(), momentum).yzw()).try_normalize()
}

/// The angular rate of the motion, in radians per r_s/c: the time scale of holds. The larger of
/// sqrt(M/r^3) and |r w|/Sigma.
pub fn motion_rate(ship: &Ship) -> f64 {
    let place = ship.place();
    let turning = ship.constants().w.length() / place.sigma();
    (MASS / place.r.powi(3)).sqrt().max(turning)
}

/// The smallest rotation, on the ship's axes, that turns the direction `from` to `to`.
pub fn turn_to(from: DVec3, to: DVec3) -> DMat3 {
    DMat3::from_quat(DQuat::from_rotation_arc(from, to))
}
