//! The forces on an observer: the thrust that holds it in place, and the tide.

use glam::DVec3;
use lightfall_model::geometry::kerr::{Kerr, MASS};
use lightfall_model::geometry::observer::Photon;
use lightfall_model::geometry::sphere::polar_sin_cos;
use lightfall_model::scene::ObserverKind;

/// Proper acceleration, in c^2/r_s, of an observer of this kind at (`r`, `theta`) (r_s, radians),
/// where the observer exists.
///
/// `static` follows the Killing vector d/dt, and `zamo` is orthogonal to the slices of constant t.
/// So the acceleration of each is the gradient of a potential: ln sqrt(f) with f = 1 - 2 M r/Sigma,
/// and ln N with N^2 = Sigma Delta/A. Misner, Thorne & Wheeler 1973 exercise 23.1 in Schwarzschild;
/// Thorne & MacDonald 1982 for ln N. `orbit` and `rain` fall freely.
pub fn held_acceleration(kerr: Kerr, kind: ObserverKind, r: f64, theta: f64) -> f64 {
    let [outward, along_theta] = held_acceleration_components(kerr, kind, r, theta);
    outward.hypot(along_theta)
}

/// The two components of [`held_acceleration`]: outward, and toward growing theta.
pub fn held_acceleration_components(
    kerr: Kerr,
    kind: ObserverKind,
    r: f64,
    theta: f64,
) -> [f64; 2] {
    let (sin, cos) = polar_sin_cos(theta);
    let a2 = kerr.a().powi(2);
    let (sigma, delta) = (kerr.sigma(r, cos), kerr.delta(r));
    let sigma_theta = -2.0 * a2 * sin * cos;
    // Derivatives of the potential with respect to r and theta.
    let [by_r, by_theta] = match kind {
        ObserverKind::Static => {
            let f = 1.0 - 2.0 * MASS * r / sigma;
            let [f_r, f_theta] =
                [2.0 * r * r - sigma, r * sigma_theta].map(|g| 2.0 * MASS * g / (sigma * sigma));
            [f_r / (2.0 * f), f_theta / (2.0 * f)]
        }
        ObserverKind::Zamo => {
            // 1/N^2 = 1 + g, g = 2 M r (r^2 + a^2)/(Sigma Delta).
            let area = kerr.area(r, (sin, cos));
            let share = 2.0 * MASS * r * (r * r + a2) / area;
            let by_r =
                1.0 / r + 2.0 * r / (r * r + a2) - 2.0 * r / sigma - 2.0 * (r - MASS) / delta;
            [-0.5 * share * by_r, 0.5 * share * sigma_theta / sigma]
        }
        ObserverKind::Orbit | ObserverKind::Rain => return [0.0; 2],
    };
    [(delta / sigma).sqrt() * by_r, by_theta / sigma.sqrt()]
}

/// The largest tidal stretching, in c^2/r_s^2, of a body with the four-velocity `u` at radius `r`
/// (r_s) and the place `n` on the celestial sphere: the relative acceleration of two of its points
/// divided by their distance, along the direction where it is largest.
///
/// In the frame of Carter's tetrad the Weyl tensor is psi (1 - 3 e e), with psi = M/(r - i a
/// cos(theta))^3 and e the radial direction (Kinnersley 1969). A boost along e changes nothing. A
/// boost by gamma across e turns e into the complex unit vector (gamma, 0, i sqrt(gamma^2 - 1)), as
/// for an electric field (Landau & Lifshitz, Classical Theory of Fields, section 25). So the
/// stretching is the larger eigenvalue of a two by two matrix. Without spin gamma^2 = 1 + L^2/r^2
/// and the stretching is (M/r^3)(2 + 3 L^2/r^2), in agreement with Marck 1983.
pub fn tide(kerr: Kerr, r: f64, n: DVec3, u: &Photon) -> f64 {
    let (a, sigma) = (kerr.a(), kerr.sigma(r, n.z));
    // The part of the momentum across e: r w minus a E sin(theta) phi_hat.
    let across = r * u.w - a * u.energy * DVec3::Z.cross(n);
    let excess = across.length_squared() / sigma;
    // psi = M (r + i a cos)^3 / Sigma^3.
    let height = a * n.z;
    let scale = MASS / sigma.powi(3);
    let real = scale * r * (r * r - 3.0 * height * height);
    let imaginary = scale * height * (3.0 * r * r - height * height);
    let half_difference = 1.5 * real * (1.0 + 2.0 * excess);
    let coupling = 3.0 * imaginary * ((1.0 + excess) * excess).sqrt();
    (0.5 * real + half_difference.hypot(coupling)).max(-real)
}
