//! The axes of the observer that falls from rest at infinity, and of the one with zero angular
//! momentum, on the Kerr-Schild frame.

use super::Place;
use super::constants::vector;
use super::vectors::boost;
use crate::geometry::kerr::MASS;
use crate::geometry::sphere::celestial_frame;
use glam::{DMat4, DVec3, DVec4};

/// The axes of `rain` on the Kerr-Schild frame, one per column: its four-velocity, then outward,
/// toward growing theta, toward growing azimuth. Those of the scene's observer of that kind
/// ([`observer_matrix`](crate::geometry::observer::observer_matrix)), regular at the horizon.
///
/// On the axis, `azimuth` (Kerr's ingoing one, in radians) says where the last two point. Elsewhere
/// it has no effect.
///
/// With f = sqrt(2 M r (r^2 + a^2)) and Y = [`Kerr::area`](crate::geometry::kerr::Kerr::area):
/// E = 1, V = -f, L = w = 0, h = rho^2/(rho^2 + f) of the four-velocity; E = -f/sqrt(Y), V =
/// sqrt(Y), h = (Sigma - a^2 sin^2 f^2/Y)/(rho^2 f/sqrt(Y) + sqrt(Y)) of the outward axis. Derived
/// from `in_free_fall`'s rows; the frame is Doran's (2000).
pub fn rain_axes(place: &Place, azimuth: f64) -> DMat4 {
    let (r, rho2, sigma) = (place.r, place.rho2(), place.sigma());
    let (sin, area) = (place.sin_theta(), place.area());
    let (fall, root) = ((2.0 * MASS * r * rho2).sqrt(), area.sqrt());
    let u = vector(place, 1.0, 0.0, -fall, DVec3::ZERO, rho2 / (rho2 + fall));
    let tilt = place.kerr.a() * sin * fall;
    let h = (sigma - tilt * tilt / area) / (rho2 * fall / root + root);
    let outward = vector(place, -fall / root, 0.0, root, DVec3::ZERO, h);
    let [_, theta_hat, phi_hat] =
        celestial_frame(place.theta(), place.azimuth().unwrap_or(azimuth));
    let tangent = |v: DVec3| place.on_frame(DVec4::from((0.0, place.spread(v))));
    DMat4::from_cols(
        u,
        outward,
        tangent(theta_hat / sigma.sqrt()),
        tangent(phi_hat * (sigma / area).sqrt()),
    )
}

/// The axes of the observer with zero angular momentum, as those of [`rain_axes`], from which a pure
/// boost outward leads to them, with gamma v = f/sqrt(Sigma Delta). `None` at and inside the
/// horizon, where there is no such observer.
pub fn zamo_axes(place: &Place, azimuth: f64) -> Option<DMat4> {
    let (r, delta) = (place.r, place.kerr.delta(place.r));
    (r > place.kerr.horizon()).then(|| {
        let momentum = (2.0 * MASS * r * place.rho2() / (place.sigma() * delta)).sqrt();
        rain_axes(place, azimuth) * boost(momentum * DVec3::X)
    })
}
