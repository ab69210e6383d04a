//! How long a ship can live inside the horizon.

use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::quadrature::integral;

/// The longest proper time from the radius `r` inside the horizon to the inner horizon (without spin,
/// to the centre), in r_s/c, of motion at the polar angle with this cosine. Zero inside the inner
/// horizon. From outside it is counted from the horizon.
///
/// dtau^2 <= Sigma/(-Delta) dr^2 there, and equality is a motion with P = 0. With r = r_- + (r_+ -
/// r_-) sin^2(x), dr/sqrt(-Delta) = 2 dx. On the axis it is the longest of all. Without spin it is
/// arcsin(sqrt(r)) - sqrt(r (1 - r)), pi/2 from the horizon (Misner, Thorne & Wheeler 1973 exercise
/// 31.4).
pub fn longest_life(kerr: Kerr, r: f64, cos_theta: f64) -> f64 {
    let (outer, inner) = (kerr.horizon(), kerr.inner_horizon());
    let share = ((r - inner) / (outer - inner)).clamp(0.0, 1.0);
    let rate = |x: f64| {
        let r = inner + (outer - inner) * x.sin().powi(2);
        2.0 * kerr.sigma(r, cos_theta).sqrt()
    };
    integral(0.0, share.sqrt().asin(), &rate)
}

/// The proper time to the centre of a hole without spin, in r_s/c, of a free fall along the radius
/// with the energy `energy` from inside the horizon at `r`: that of the cycloid (Misner, Thorne &
/// Wheeler 1973 eq. 31.10), or of its continuation for E of one and more.
pub fn radial_life(r: f64, energy: f64) -> f64 {
    // dr/dtau = -sqrt(E^2 - 1 + 1/r); with r = s^2 the integrand is smooth at the centre.
    let rate = |s: f64| 2.0 * s * s / (1.0 + (energy * energy - 1.0) * s * s).sqrt();
    integral(0.0, r.sqrt(), &rate)
}
