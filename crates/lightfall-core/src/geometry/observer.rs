//! Observers: which photon arrives from which direction.
//!
//! Whoever looks, the answer is linear in (1, d), d the unit looking direction on the observer's
//! own axes (outward, toward growing theta, toward growing phi): the photon that arrives from d
//! with unit frequency has the momentum p = e_t - d^i e_i, future-directed. So an observer is a
//! matrix.

mod error;

pub use error::ObserverError;

use super::sphere::{celestial_frame, polar_sin_cos};
use crate::geometry::kerr::{Kerr, MASS};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// The frames of reference that have a name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ObserverKind {
    /// At rest with respect to infinity.
    #[default]
    Static,
    /// Zero angular momentum.
    Zamo,
    /// Prograde circular geodesic in the disk's plane.
    Orbit,
    /// Free fall from rest at infinity.
    Rain,
}

/// Four by four: of a boost, or of an observer's rows before the sphere's tangent vectors become
/// Cartesian.
type Matrix4 = [[f64; 4]; 4];

/// Takes (1, d) to the photon that arrives from the direction d with unit frequency for the
/// observer.
///
/// Columns: 1, then d's components outward, toward growing theta, toward growing phi. Rows:
///
/// 0. `energy`: E = -p_t.
/// 1. `radial`: Sigma p^r / r^2 (contravariant; regular at the horizon, where p_r is not).
/// 2. to 4. `w`: (p_theta theta_hat + p_phi / sin(theta) phi_hat) / r as a Cartesian vector of the
///    hole's frame. It is tangent to the celestial sphere at the camera's n; the division by r
///    keeps it of the order of one. The poles are ordinary places.
///
/// All numbers are free of units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObserverMatrix {
    /// The five rows.
    pub rows: [[f64; 4]; 5],
}

/// A photon where it meets the camera: the matrix times (1, d). Per unit frequency for the camera,
/// so 1/E is the frequency ratio of the sky's light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// E = -p_t.
    pub energy: f64,
    /// Sigma p^r / r^2.
    pub radial: f64,
    /// (p_theta theta_hat + p_phi / sin(theta) phi_hat) / r, in the hole's frame.
    pub w: DVec3,
}

impl ObserverMatrix {
    /// The photon that arrives from the unit looking direction `direction`, on the observer's axes.
    #[must_use]
    pub fn photon(&self, direction: DVec3) -> Photon {
        let row = |i: usize| {
            let [one, r, theta, phi] = self.rows[i];
            one + r * direction.x + theta * direction.y + phi * direction.z
        };
        Photon {
            energy: row(0),
            radial: row(1),
            w: DVec3::new(row(2), row(3), row(4)),
        }
    }
}

/// The least radius to which motion leads, in r_s: nine tenths of the way from the outer horizon to
/// the inner one, which without spin is the centre. Beyond it the tide grows without end, or with
/// spin the blueshift of what falls in along with the hole's turning, as 1/|Delta|; and a real
/// hole's inner horizon is no vacuum's (Poisson & Israel 1990).
#[must_use]
pub fn min_infall_radius(kerr: Kerr) -> f64 {
    0.9 * kerr.inner_horizon() + 0.1 * kerr.horizon()
}

/// The matrix of an observer of kind `kind` around a hole of spin `spin` (chi), at (`r`, `theta`,
/// `phi`) (r_s, radians), who moves with `velocity` (units of c; outward, toward growing theta,
/// toward growing phi) in the frame of that kind.
///
/// The axes are those of the zero-angular-momentum observer (Bardeen, Press & Teukolsky 1972 eqs.
/// 3.2-3.4) carried along by pure boosts: first to the kind's observer, then by `velocity`.
///
/// # ErrorSummary
/// If there is no such observer: see [`ObserverError`].
pub fn observer_matrix(
    spin: f64,
    kind: ObserverKind,
    velocity: [f64; 3],
    r: f64,
    theta: f64,
    phi: f64,
) -> Result<ObserverMatrix, ObserverError> {
    if !(spin > -1.0 && spin < 1.0) {
        return Err(ObserverError::Spin(spin));
    }
    for (field, value, shown) in [
        ("r", r, r),
        ("theta_deg", theta, theta.to_degrees()),
        ("phi_deg", phi, phi.to_degrees()),
    ] {
        if !value.is_finite() {
            return Err(ObserverError::Place {
                field,
                value: shown,
            });
        }
    }
    let kerr = Kerr { spin };
    // The inner horizon is zero without spin, and then the centre itself is what lies too deep.
    if r <= kerr.inner_horizon() {
        return Err(ObserverError::TooDeep {
            r,
            inner: kerr.inner_horizon(),
        });
    }
    let rows = match kind {
        ObserverKind::Static => static_rows(kerr, r, theta)?,
        ObserverKind::Zamo => zamo_rows(kerr, r, theta)?,
        ObserverKind::Orbit => orbit_rows(kerr, r, theta)?,
        ObserverKind::Rain => rain_rows(kerr, r, theta),
    };
    let [energy, radial, w_theta, w_phi] = product(rows, boost(velocity)?);
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let w = |axis: usize| {
        std::array::from_fn(|i| w_theta[i] * theta_hat[axis] + w_phi[i] * phi_hat[axis])
    };
    Ok(ObserverMatrix {
        rows: [energy, radial, w(0), w(1), w(2)],
    })
}

/// What the rows of every kind are made of, at one place.
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

/// Zero angular momentum: u = -N dt with N^2 = Sigma Delta / A, axes sqrt(Sigma/Delta) dr,
/// sqrt(Sigma) dtheta, sin(theta) sqrt(A/Sigma) (dphi - omega dt) with omega = 2 M a r / A.
/// Bardeen, Press & Teukolsky 1972 eqs. 2.5, 3.2.
fn zamo_rows(kerr: Kerr, r: f64, theta: f64) -> Result<Matrix4, ObserverError> {
    if r <= kerr.horizon() {
        return Err(ObserverError::Zamo {
            r,
            horizon: kerr.horizon(),
        });
    }
    let Local {
        sin,
        area,
        sigma,
        delta,
    } = Local::new(kerr, r, theta);
    let width = (area / sigma).sqrt();
    let omega = 2.0 * MASS * kerr.a() * r / area;
    Ok([
        [
            (sigma * delta / area).sqrt(),
            0.0,
            0.0,
            -sin * width * omega,
        ],
        [0.0, -(sigma * delta).sqrt() / (r * r), 0.0, 0.0],
        [0.0, 0.0, -sigma.sqrt() / r, 0.0],
        [0.0, 0.0, 0.0, -width / r],
    ])
}

/// At rest: u along d/dt, so p_t = -sqrt(f) whatever the direction, f = 1 - 2 M r / Sigma; the
/// third axis, orthogonal to u in the (t, phi) plane, has p_phi = sin(theta) sqrt(Delta / f).
/// Derived.
fn static_rows(kerr: Kerr, r: f64, theta: f64) -> Result<Matrix4, ObserverError> {
    let limit = kerr.static_limit(polar_sin_cos(theta).1);
    if r <= limit {
        return Err(ObserverError::Static { r, limit });
    }
    let Local {
        sin, sigma, delta, ..
    } = Local::new(kerr, r, theta);
    // The roots of r^2 - 2 M r + a^2 cos^2 theta are the static limit and 2 M minus it.
    let root_f = ((r - limit) * (r - (2.0 * MASS - limit)) / sigma).sqrt();
    Ok([
        [root_f, 0.0, 0.0, 0.0],
        [0.0, -(sigma * delta).sqrt() / (r * r), 0.0, 0.0],
        [0.0, 0.0, -sigma.sqrt() / r, 0.0],
        [
            -2.0 * MASS * kerr.a() * sin / (sigma * root_f),
            0.0,
            0.0,
            -delta.sqrt() / (root_f * r),
        ],
    ])
}

/// On the prograde circular geodesic: p = u has -p_t = E, p_phi = L of the orbit; the third axis,
/// orthogonal to u in the (t, phi) plane, is (p_t, p_phi) = sqrt(Delta) (-u^phi, u^t). Derived.
fn orbit_rows(kerr: Kerr, r: f64, theta: f64) -> Result<Matrix4, ObserverError> {
    if (theta - FRAC_PI_2).abs() > 1e-9 {
        return Err(ObserverError::OffPlane {
            theta_deg: theta.to_degrees(),
        });
    }
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
/// inward for the zero-angular-momentum observer; its outward axis has Sigma e^r = sqrt(A) and e_t = beta. Nothing
/// here knows of the horizon. Derived; the frame is Doran's (2000).
fn rain_rows(kerr: Kerr, r: f64, theta: f64) -> Matrix4 {
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

/// The pure boost that takes a light ray (1, d) of an observer who moves with `velocity` v in a
/// frame to that frame's own (frequency, frequency times direction): gamma (1 - v.d) and d +
/// (gamma^2 / (gamma + 1)) (v.d) v - gamma v. The Lorentz transformation, d being opposite to the
/// momentum.
fn boost(velocity: [f64; 3]) -> Result<Matrix4, ObserverError> {
    let speed = DVec3::from_array(velocity).length();
    if speed.is_nan() || speed >= 1.0 {
        return Err(ObserverError::Velocity { velocity });
    }
    let gamma = 1.0 / ((1.0 - speed) * (1.0 + speed)).sqrt();
    let stretch = gamma * gamma / (gamma + 1.0);
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| match (i, j) {
            (0, 0) => gamma,
            (0, k) | (k, 0) => -gamma * velocity[k - 1],
            (i, j) => f64::from(u8::from(i == j)) + stretch * velocity[i - 1] * velocity[j - 1],
        })
    }))
}

fn product(left: Matrix4, right: Matrix4) -> Matrix4 {
    left.map(|row| std::array::from_fn(|j| (0..4).map(|k| row[k] * right[k][j]).sum()))
}
