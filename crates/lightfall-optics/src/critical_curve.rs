//! The edge of the hole's shadow: the directions of light that comes from the photon orbits.

use glam::DVec3;
use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::kerr::{Kerr, MASS};
use lightfall_model::geometry::observer::Photon;
use lightfall_model::geometry::schwarzschild::shadow_half_angle_rain;
use lightfall_model::geometry::sphere::{celestial_frame, polar_sin_cos};
use lightfall_model::geometry::tetrad::rain_components;
use std::f64::consts::PI;

/// Below this spin the shadow's mean radius equals the one without spin to a relative 1e-8, since
/// it is an even function of the spin.
pub const NEGLIGIBLE_SPIN: f64 = 1e-4;

/// An observer closer to the axis than this, in radians, is moved to this angle.
const MIN_AXIS_ANGLE: f64 = 1e-6;

/// The edge of the shadow for the observer `rain` at one place, as a closed curve of directions on
/// its axes (outward, toward growing theta, toward growing phi). For this observer the shadow is
/// smaller than a hemisphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalCurve {
    kerr: Kerr,
    /// Radius, polar angle and azimuth of the observer, in r_s and radians.
    place: [f64; 3],
    /// Radii of the innermost and outermost photon orbit that is seen, in units of M.
    orbits: [f64; 2],
}

impl CriticalCurve {
    /// The curve for `rain` at (`r`, `theta`, `phi`) (r_s, radians).
    pub fn new(kerr: Kerr, r: f64, theta: f64, phi: f64) -> Self {
        let theta = theta.clamp(MIN_AXIS_ANGLE, PI - MIN_AXIS_ANGLE);
        let mut curve = Self {
            kerr,
            place: [r, theta, phi],
            orbits: [0.0; 2],
        };
        if kerr.spin.abs() >= NEGLIGIBLE_SPIN {
            let polar = kerr.photon_orbit_polar() / MASS;
            let is_seen = |p: f64| curve.orbit(p).polar_speed2 > 0.0;
            // 64 halvings reach the last bit.
            curve.orbits = [kerr.photon_orbit_prograde(), kerr.photon_orbit_retrograde()]
                .map(|end| bisection([polar, end / MASS], 64, is_seen)[0]);
        }
        curve
    }

    /// The curve's point at `angle` (radians), which goes once around it.
    ///
    /// Without spin the curve is a circle. With spin, light leaves the spherical photon orbit at p
    /// outward or inward: R(r) = (r - p)^2 (r^2 + 2 r p - a^2 Q/p^2) has a double root there.
    pub fn at(&self, angle: f64) -> DVec3 {
        let [r, theta, phi] = self.place;
        if self.kerr.spin.abs() < NEGLIGIBLE_SPIN {
            let (sin, cos) = shadow_half_angle_rain(r).sin_cos();
            return DVec3::new(-cos, -sin * angle.sin(), -sin * angle.cos());
        }
        let [min, max] = self.orbits;
        let p = 0.5 * (min + max) - 0.5 * (max - min) * angle.cos();
        let orbit = self.orbit(p);
        let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
        let p_theta = orbit.polar_speed2.max(0.0).sqrt().copysign(angle.sin());
        let ratio = r / MASS;
        let speed = (ratio - p)
            * (ratio * (ratio + 2.0 * p) - orbit.radial_rest)
                .max(0.0)
                .sqrt()
            / (ratio * ratio);
        let sin = polar_sin_cos(theta).0;
        let photon = Photon {
            energy: 1.0,
            radial: speed,
            w: (p_theta * theta_hat + orbit.lambda / sin * phi_hat) / ratio,
        };
        let (frequency, momentum) = rain_components(self.kerr, r, theta, phi, &photon, 0.0);
        -momentum / frequency
    }

    /// The light of the spherical photon orbit at radius p, for M = E = 1 (Teo 2003):
    ///
    /// lambda = (p^2 (3 - p) - a^2 (p + 1)) / (a (p - 1)),
    /// Q = p^3 (4 a^2 - p (p - 3)^2) / (a^2 (p - 1)^2).
    fn orbit(&self, p: f64) -> PhotonOrbit {
        let (a, below) = (self.kerr.spin, p - 1.0);
        let (sin, cos) = polar_sin_cos(self.place[1]);
        let lambda = (p * p * (3.0 - p) - a * a * (p + 1.0)) / (a * below);
        let q = p.powi(3) * (4.0 * a * a - p * (p - 3.0).powi(2)) / (a * below).powi(2);
        PhotonOrbit {
            lambda,
            radial_rest: a * a * q / (p * p),
            polar_speed2: q + (a * cos).powi(2) - (lambda * cos / sin).powi(2),
        }
    }
}

/// The light of a spherical photon orbit, in units of M.
struct PhotonOrbit {
    lambda: f64,
    /// a^2 Q/p^2, which R(r) contains.
    radial_rest: f64,
    /// Theta = p_theta^2 at the observer; negative where the light does not pass.
    polar_speed2: f64,
}
