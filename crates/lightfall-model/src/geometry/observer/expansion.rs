//! An observer's matrix, expanded about one direction.
//!
//! A photon that is small compared with the matrix is a difference of large numbers, unless the
//! matrix is expanded about the direction from which the smallest photon arrives.

use super::{ObserverMatrix, Photon};
use crate::geometry::bisection::bisection;
use glam::{DMat3, DVec3, DVec4, Vec4Swizzles};

/// Number of halvings that find the multiplier of [`least_on_sphere`] to its last digit.
const HALVINGS: u32 = 120;

/// An observer's matrix, expanded about the direction from which the smallest photons arrive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExpandedMatrix {
    /// The direction, on the observer's axes.
    pub centre: DVec3,
    /// What [`expand_about`] makes of each row.
    rows: [(DVec4, f64); 5],
}

impl ExpandedMatrix {
    /// Expands the matrix of an observer at radius `r` (r_s).
    pub fn new(matrix: &ObserverMatrix, r: f64) -> Self {
        let rows = matrix.rows.map(DVec4::from_array);
        let centre = expansion_centre(rows, r).unwrap_or(DVec3::NEG_X);
        Self {
            centre,
            rows: rows.map(|row| expand_about(row, centre)),
        }
    }

    /// The photon that arrives from the unit looking direction `direction`, as
    /// [`ObserverMatrix::photon`] gives it, to more digits.
    pub fn photon(&self, direction: DVec3) -> Photon {
        let off = direction - self.centre;
        let [energy, radial, x, y, z] = self.rows.map(|(row, curvature)| {
            row.dot(DVec4::from((1.0, off))) + 0.5 * curvature * off.length_squared()
        });
        Photon {
            energy,
            radial,
            w: DVec3::new(x, y, z),
        }
    }
}

/// The direction of expansion for an observer at `r`: that of the least energy or, where light can
/// have negative energy, that of the smallest photon. `None` if all light has the same energy.
fn expansion_centre(rows: [DVec4; 5], r: f64) -> Option<DVec3> {
    let [energy, _, w_x, w_y, w_z] = rows;
    let slope = energy.yzw();
    if slope.length() <= 1e-6 * energy.x.abs() {
        return None;
    }
    if slope.length() < energy.x {
        return Some(-slope.normalize());
    }
    // A photon's size is 4 E^2 + |r w|^2, as in shaders/method/kerr_constants.wgsl, and so a sum of
    // squares that are linear in (1, d).
    let mut square = DMat3::ZERO;
    let mut linear = DVec3::ZERO;
    for row in [2.0 * energy, r * w_x, r * w_y, r * w_z] {
        let slope = row.yzw();
        square += DMat3::from_cols(slope.x * slope, slope.y * slope, slope.z * slope);
        linear += row.x * slope;
    }
    Some(least_on_sphere(square, linear))
}

/// The unit vector x at which x.A x + 2 b.x is least, for a symmetric A without negative
/// eigenvalues: (A + m) x = -b, with the multiplier m at which |x| = 1 and A + m is positive
/// definite (Conn, Gould & Toint 2000, section 7.2).
fn least_on_sphere(a: DMat3, b: DVec3) -> DVec3 {
    let shifted = |m: f64| a + m * DMat3::IDENTITY;
    let solution = |m: f64| shifted(m).inverse() * -b;
    // |x| falls with m.
    let is_below = |m: f64| !is_positive_definite(shifted(m)) || solution(m).length() > 1.0;
    let trace = a.x_axis.x + a.y_axis.y + a.z_axis.z;
    let [_, high] = bisection([-trace, b.length()], HALVINGS, is_below);
    solution(high).try_normalize().unwrap_or(DVec3::NEG_X)
}

/// Whether all leading minors of a symmetric matrix are positive (Sylvester's criterion).
fn is_positive_definite(a: DMat3) -> bool {
    a.x_axis.x > 0.0 && a.x_axis.x * a.y_axis.y > a.x_axis.y * a.x_axis.y && a.determinant() > 0.0
}

/// Rewrites dot(row, (1, d)), for unit d, as dot(expanded, (1, off)) + curvature |off|^2/2 with
/// off = d - m. Returns `expanded` and the curvature.
///
/// With row = (s, b m + q), q perpendicular to m, it is s + b m.m + b m.off + q.off, and
/// m.off = (1 - |m|^2 - |off|^2)/2.
pub fn expand_about(row: DVec4, m: DVec3) -> (DVec4, f64) {
    let slope = row.yzw();
    let along = slope.dot(m) / m.length_squared();
    let across = slope - along * m;
    let at_m = row.x + 0.5 * along * (1.0 + m.length_squared());
    (DVec4::new(at_m, across.x, across.y, across.z), -along)
}
