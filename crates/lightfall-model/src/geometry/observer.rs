//! Observers: the photon that arrives at an observer from a direction, and the places where an
//! observer can be.
//!
//! With d the unit looking direction on the observer's own axes (outward, toward growing theta,
//! toward growing phi), the photon that arrives from d with unit frequency has the future-directed
//! momentum p = e_t - d^i e_i. It is linear in (1, d), so an observer is a matrix.

mod error;
pub mod expansion;
mod kind;
mod rows;

pub use error::ObserverError;
pub use expansion::ExpandedMatrix;
pub use kind::{Limit, ObserverKind, ObserverProperties, min_infall_radius};

use super::sphere::celestial_frame;
use crate::geometry::kerr::Kerr;
use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};
use rows::{Matrix4, rows_of};

/// Maps (1, d) to the photon that arrives from the direction d with unit frequency for the
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
/// All entries are dimensionless.
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

    /// The unit looking direction from which a photon arrives at the observer, whose unit vector on
    /// the celestial sphere is `n`; the photon's frequency does not matter. `None` if the observer
    /// measures no frequency.
    pub fn direction_of(&self, photon: &Photon, n: DVec3) -> Option<DVec3> {
        let [energy, radial, x, y, z] = self.rows.map(DVec4::from_array);
        let (u, v) = n.any_orthonormal_pair();
        let along = |axis: DVec3| axis.x * x + axis.y * y + axis.z * z;
        let rows = DMat4::from_cols(energy, radial, along(u), along(v)).transpose();
        let Photon { energy, radial, w } = *photon;
        let ray = rows.inverse() * DVec4::new(energy, radial, w.dot(u), w.dot(v));
        (ray.yzw() / ray.x).try_normalize()
    }

    /// The same observer with `w` on the axes of another frame, to which `rotation` turns the
    /// hole's.
    #[must_use]
    pub fn turned(&self, rotation: DMat3) -> Self {
        let [energy, radial, w @ ..] = self.rows;
        let on_axis = |axis: usize| {
            let along = rotation.row(axis).to_array();
            std::array::from_fn(|column| (0..3).map(|i| along[i] * w[i][column]).sum())
        };
        Self {
            rows: [energy, radial, on_axis(0), on_axis(1), on_axis(2)],
        }
    }
}

/// The matrix of an observer of kind `kind` around a hole of spin `spin` (chi), at (`r`, `theta`,
/// `phi`) (r_s, radians), which moves with `velocity` (units of c; outward, toward growing theta,
/// toward growing phi) in the frame of that kind.
///
/// The axes are those of the zero-angular-momentum observer (Bardeen, Press & Teukolsky 1972 eqs.
/// 3.2-3.4) carried along by pure boosts: first to the kind's observer, then by `velocity`.
///
/// # Errors
/// There is no such observer: see [`ObserverError`].
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
    kind.check_place(kerr, r, theta)?;
    let rows = rows_of(kind, kerr, r, theta)?;
    let [energy, radial, w_theta, w_phi] = product(rows, boost(velocity)?);
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let w = |axis: usize| {
        std::array::from_fn(|i| w_theta[i] * theta_hat[axis] + w_phi[i] * phi_hat[axis])
    };
    Ok(ObserverMatrix {
        rows: [energy, radial, w(0), w(1), w(2)],
    })
}

/// The pure boost that takes a light ray (1, d) of an observer that moves with `velocity` v in a
/// frame to that frame's own (frequency, frequency times direction): gamma (1 - v.d) and d +
/// (gamma^2 / (gamma + 1)) (v.d) v - gamma v. The Lorentz transformation, d being opposite to the
/// momentum.
///
/// # Errors
/// The speed is not below that of light.
pub fn boost(velocity: [f64; 3]) -> Result<[[f64; 4]; 4], ObserverError> {
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
