//! Momenta in an observer's frame, and the rotation between the axes of two observers with the same
//! four-velocity.

use crate::geometry::kerr::{Kerr, MASS};
use crate::geometry::observer::{ObserverMatrix, Photon};
use crate::geometry::sphere::{celestial_frame, polar_sin_cos};
use glam::{DMat3, DMat4, DVec3, DVec4};

/// The observer's four-velocity, in the form of a photon: the first column of its matrix holds
/// -u_t, Sigma u^r / r^2 and so on.
pub fn four_velocity(matrix: &ObserverMatrix) -> Photon {
    let [energy, radial, x, y, z] = matrix.rows.map(|row| row[0]);
    Photon {
        energy,
        radial,
        w: DVec3::new(x, y, z),
    }
}

/// The energy and the momentum (outward, toward growing theta, toward growing phi) that the
/// observer `rain`, which falls from rest at infinity, measures at (`r`, `theta`, `phi`) (r_s,
/// radians). `mass_squared` is the rest mass squared.
///
/// Let beta = sqrt(2 M r (r^2 + a^2)/A) be the speed of rain relative to the zero-angular-momentum
/// observer. One of the light-cone components energy -+ outward has the factor 1 - beta, which
/// vanishes at the horizon. It is computed from the other one instead: their product is the mass
/// squared plus the square of the momentum across. So the result is regular at the horizon for
/// everything that falls inward. Derived.
pub fn rain_components(
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
    let along_theta = r * momentum.w.dot(theta_hat) / sigma.sqrt();
    let along_phi = r * momentum.w.dot(phi_hat) / (area / sigma).sqrt();
    let beta = (2.0 * MASS * r * (r * r + a2) / area).sqrt();
    let energy =
        momentum.energy - sin * 2.0 * MASS * kerr.a() * r / (area * sigma).sqrt() * along_phi;
    let radial = momentum.radial * r * r / area.sqrt();
    let product = mass_squared + along_theta * along_theta + along_phi * along_phi;
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
        DVec3::new(0.5 * (plus - minus), along_theta, along_phi),
    )
}

/// The velocity relative to `rain`, in c on its axes, of a body with the four-velocity `u`.
pub fn velocity_in_rain(kerr: Kerr, r: f64, theta: f64, phi: f64, u: &Photon) -> DVec3 {
    let (gamma, momentum) = rain_components(kerr, r, theta, phi, u, 1.0);
    momentum / gamma
}

/// The velocity of `observer` relative to `frame` at the same place, in c on the frame's axes. Not
/// defined at the horizon.
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
pub fn rotation_between(from: &ObserverMatrix, to: &ObserverMatrix, theta: f64, phi: f64) -> DMat3 {
    let lorentz = transformation(from, to, theta, phi);
    let axis = |column: DVec4| DVec3::new(column.y, column.z, column.w);
    // Orthonormalized, since rounding leaves only an approximate rotation.
    let x = axis(lorentz.y_axis).normalize();
    let y = axis(lorentz.z_axis).reject_from_normalized(x).normalize();
    DMat3::from_cols(x, y, x.cross(y))
}

/// The Lorentz transformation from (1, d) of one observer to (frequency, frequency times d) of
/// another at the same place. Not defined at the horizon. The first column of a matrix is the
/// observer's four-velocity and the other columns are minus its axes, so a four-velocity has the
/// components (gamma, -gamma v).
pub fn transformation(from: &ObserverMatrix, to: &ObserverMatrix, theta: f64, phi: f64) -> DMat4 {
    let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
    let square = |matrix: &ObserverMatrix| {
        let row = |i: usize| DVec4::from_array(matrix.rows[i]);
        let along = |hat: DVec3| hat.x * row(2) + hat.y * row(3) + hat.z * row(4);
        DMat4::from_cols(row(0), row(1), along(theta_hat), along(phi_hat)).transpose()
    };
    square(to).inverse() * square(from)
}
