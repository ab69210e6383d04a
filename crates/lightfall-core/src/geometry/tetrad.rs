//! Where a momentum stands in an observer's frame, and how the axes of two observers who move alike
//! are turned.

use crate::geometry::kerr::{Kerr, MASS};
use crate::geometry::observer::{ObserverMatrix, Photon};
use crate::geometry::sphere::{celestial_frame, polar_sin_cos};
use glam::{DMat3, DMat4, DVec3, DVec4};

/// The observer's four-velocity: her matrix's first column is -u_t, Sigma u^r / r^2 and so on, as
/// of a photon.
#[must_use]
pub fn four_velocity(matrix: &ObserverMatrix) -> Photon {
    let [energy, radial, x, y, z] = matrix.rows.map(|row| row[0]);
    Photon {
        energy,
        radial,
        w: DVec3::new(x, y, z),
    }
}

/// The components of a momentum of this rest mass squared at (`r`, `theta`, `phi`) for the observer
/// who falls from rest at infinity (`rain`), on her axes: energy; outward, toward growing theta,
/// toward growing phi.
///
/// With beta = sqrt(2 M r (r^2 + a^2)/A) her own speed for the zero-angular-momentum observer, one
/// of the light-cone components energy -+ outward has the factor 1 - beta, which vanishes at the
/// horizon. Their product is the mass squared and what is across squared, and gives it from the
/// other: so nothing that falls inward has a special place at the horizon. Derived.
#[must_use]
pub fn in_rain(
    kerr: Kerr,
    r: f64,
    theta: f64,
    phi: f64,
    momentum: &Photon,
    mass_squared: f64,
) -> (f64, DVec3) {
    let (sin, cos) = polar_sin_cos(theta);
    let (a2, sigma) = (kerr.a().powi(2), kerr.sigma(r, cos));
    let area = kerr.area(r, (sin, cos));
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let down = r * momentum.w.dot(theta_hat) / sigma.sqrt();
    let along = r * momentum.w.dot(phi_hat) / (area / sigma).sqrt();
    let beta = (2.0 * MASS * r * (r * r + a2) / area).sqrt();
    let energy = momentum.energy - sin * 2.0 * MASS * kerr.a() * r / (area * sigma).sqrt() * along;
    let radial = momentum.radial * r * r / area.sqrt();
    let product = mass_squared + down * down + along * along;
    let (minus, plus) = if radial <= 0.0 {
        let minus = (energy - radial) / (1.0 + beta);
        (minus, product / minus)
    } else {
        // 1 - beta^2 = Sigma Delta / A.
        let plus = (energy + radial) * (1.0 + beta) * area / (sigma * kerr.delta(r));
        (product / plus, plus)
    };
    (
        0.5 * (minus + plus),
        DVec3::new(0.5 * (plus - minus), down, along),
    )
}

/// The velocity for `rain`, in c on her axes, of what moves with the four-velocity `u`.
#[must_use]
pub fn velocity_in_rain(kerr: Kerr, r: f64, theta: f64, phi: f64, u: &Photon) -> DVec3 {
    let (gamma, momentum) = in_rain(kerr, r, theta, phi, u, 1.0);
    momentum / gamma
}

/// The velocity of `observer` for `frame` at the same place, in c on the frame's axes. Not at the
/// horizon itself.
#[must_use]
pub fn relative_velocity(
    observer: &ObserverMatrix,
    frame: &ObserverMatrix,
    theta: f64,
    phi: f64,
) -> DVec3 {
    let [gamma, rest @ ..] = transformation(observer, frame, theta, phi)
        .x_axis
        .to_array();
    -DVec3::from_array(rest) / gamma
}

/// The rotation that takes a direction on the axes of one observer to the axes of another with the
/// same four-velocity.
#[must_use]
pub fn turn_between(from: &ObserverMatrix, to: &ObserverMatrix, theta: f64, phi: f64) -> DMat3 {
    let whole = transformation(from, to, theta, phi);
    let axis = |column: DVec4| DVec3::new(column.y, column.z, column.w);
    // What rounding left of a rotation, made one.
    let x = axis(whole.y_axis).normalize();
    let y = axis(whole.z_axis).reject_from_normalized(x).normalize();
    DMat3::from_cols(x, y, x.cross(y))
}

/// Takes (1, d) of one observer to that of another at the same place, but for the frequencies. The
/// matrices' first columns are the observers themselves and the others minus their axes: so a
/// four-velocity is (gamma, -gamma v).
fn transformation(from: &ObserverMatrix, to: &ObserverMatrix, theta: f64, phi: f64) -> DMat4 {
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let square = |matrix: &ObserverMatrix| {
        let row = |i: usize| DVec4::from_array(matrix.rows[i]);
        let along = |hat: DVec3| hat.x * row(2) + hat.y * row(3) + hat.z * row(4);
        DMat4::from_cols(row(0), row(1), along(theta_hat), along(phi_hat)).transpose()
    };
    square(to).inverse() * square(from)
}
