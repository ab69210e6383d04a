//! The rows of an observer's matrix, kind by kind, before the sphere's tangent vectors become
//! Cartesian.

use super::{ObserverError, ObserverKind};
use crate::geometry::kerr::{Kerr, MASS};
use crate::geometry::sphere::polar_sin_cos;

/// A boost, or an observer's rows before the sphere's tangent vectors become Cartesian.
pub(super) type Matrix4 = [[f64; 4]; 4];

/// The metric's functions that the rows of several kinds share, at one place.
struct Local {
    sin: f64,
    /// See [`Kerr::area`].
    area: f64,
    sigma: f64,
    delta: f64,
}

impl Local {
    fn new(kerr: Kerr, r: f64, theta: f64) -> Self {
        let (sin, cos) = polar_sin_cos(theta);
        Self {
            sin,
            area: kerr.area(r, (sin, cos)),
            sigma: kerr.sigma(r, cos),
            delta: kerr.delta(r),
        }
    }
}

/// The rows of an observer of this kind at radius `r` (r_s) and polar angle `theta` (radians),
/// where it exists ([`ObserverKind::check_place`]).
///
/// # Errors
/// No timelike circular orbit has this radius.
pub(super) fn rows_of(
    kind: ObserverKind,
    kerr: Kerr,
    r: f64,
    theta: f64,
) -> Result<Matrix4, ObserverError> {
    match kind {
        ObserverKind::Static => Ok(at_rest(kerr, r, theta)),
        ObserverKind::Zamo => Ok(zero_angular_momentum(kerr, r, theta)),
        ObserverKind::Orbit => in_orbit(kerr, r),
        ObserverKind::Rain => Ok(in_free_fall(kerr, r, theta)),
    }
}

/// Zero angular momentum: u = -N dt with N^2 = Sigma Delta / A, axes sqrt(Sigma/Delta) dr,
/// sqrt(Sigma) dtheta, sin(theta) sqrt(A/Sigma) (dphi - omega dt) with omega = 2 M a r / A.
/// Bardeen, Press & Teukolsky 1972 eqs. 2.5, 3.2.
fn zero_angular_momentum(kerr: Kerr, r: f64, theta: f64) -> Matrix4 {
    let Local {
        sin,
        area,
        sigma,
        delta,
    } = Local::new(kerr, r, theta);
    let width = (area / sigma).sqrt();
    let omega = 2.0 * MASS * kerr.a() * r / area;
    [
        [
            (sigma * delta / area).sqrt(),
            0.0,
            0.0,
            -sin * width * omega,
        ],
        [0.0, -(sigma * delta).sqrt() / (r * r), 0.0, 0.0],
        [0.0, 0.0, -sigma.sqrt() / r, 0.0],
        [0.0, 0.0, 0.0, -width / r],
    ]
}

/// At rest: u along d/dt, so p_t = -sqrt(f) whatever the direction, f = 1 - 2 M r / Sigma; the
/// third axis, orthogonal to u in the (t, phi) plane, has p_phi = sin(theta) sqrt(Delta / f).
/// Derived.
fn at_rest(kerr: Kerr, r: f64, theta: f64) -> Matrix4 {
    let limit = kerr.static_limit(polar_sin_cos(theta).1);
    let Local {
        sin, sigma, delta, ..
    } = Local::new(kerr, r, theta);
    // The roots of r^2 - 2 M r + a^2 cos^2 theta are the static limit and 2 M minus it.
    let root_f = ((r - limit) * (r - (2.0 * MASS - limit)) / sigma).sqrt();
    [
        [root_f, 0.0, 0.0, 0.0],
        [0.0, -(sigma * delta).sqrt() / (r * r), 0.0, 0.0],
        [0.0, 0.0, -sigma.sqrt() / r, 0.0],
        [
            -2.0 * MASS * kerr.a() * sin / (sigma * root_f),
            0.0,
            0.0,
            -delta.sqrt() / (root_f * r),
        ],
    ]
}

/// On the prograde circular geodesic: p = u has -p_t = E, p_phi = L of the orbit; the third axis,
/// orthogonal to u in the (t, phi) plane, is (p_t, p_phi) = sqrt(Delta) (-u^phi, u^t). Derived.
fn in_orbit(kerr: Kerr, r: f64) -> Result<Matrix4, ObserverError> {
    let orbit = kerr.circular_orbit(r).ok_or_else(|| ObserverError::Orbit {
        r,
        photon_orbit: kerr.photon_orbit_prograde(),
    })?;
    let root_delta = kerr.delta(r).sqrt();
    Ok([
        [
            orbit.energy,
            0.0,
            0.0,
            -root_delta * orbit.angular_velocity * orbit.u_t,
        ],
        [0.0, -root_delta / r, 0.0, 0.0],
        [0.0, 0.0, -1.0, 0.0],
        [
            orbit.angular_momentum / r,
            0.0,
            0.0,
            -root_delta * orbit.u_t / r,
        ],
    ])
}

/// Free fall from rest at infinity with E = 1, L = 0, theta constant:
/// Sigma u^r = -sqrt(2 M r (r^2 + a^2)), which is the speed beta = sqrt(2 M r (r^2 + a^2) / A)
/// inward for the zero-angular-momentum observer; its outward axis has Sigma e^r = sqrt(A) and
/// e_t = beta. All of it is regular at the horizon. Derived; the frame is Doran's (2000).
fn in_free_fall(kerr: Kerr, r: f64, theta: f64) -> Matrix4 {
    let Local {
        sin, area, sigma, ..
    } = Local::new(kerr, r, theta);
    let width = (area / sigma).sqrt();
    let fall = (2.0 * MASS * r * (r * r + kerr.a().powi(2))).sqrt();
    [
        [
            1.0,
            fall / area.sqrt(),
            0.0,
            -sin * 2.0 * MASS * kerr.a() * r / (area * sigma).sqrt(),
        ],
        [-fall / (r * r), -area.sqrt() / (r * r), 0.0, 0.0],
        [0.0, 0.0, -sigma.sqrt() / r, 0.0],
        [0.0, 0.0, 0.0, -width / r],
    ]
}
