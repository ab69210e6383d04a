//! The brightness of a star's image where the magnification of a point diverges.

/// The smallest angular radius of a star, in radians, that limits its magnification. Real stars are
/// smaller, but directions in f32 are uncertain by a tenth of this.
pub const MIN_SOURCE_RADIUS: f64 = 1e-6;

/// 1/sin(distance) for a star whose middle is at the angle `distance` (radians) from the line
/// through the camera and the hole, averaged over the star's disc of angular radius `radius`.
///
/// The average of 1/x over a disc whose middle is at x = beta is (4/(pi rho)) E(beta^2/rho^2)
/// inside, an elliptic integral; these forms are within 3 % of it.
pub fn inverse_sine(distance: f64, radius: f64) -> f64 {
    let x = distance / radius;
    if x < 1.0 {
        let x2 = x * x;
        return (2.0 - x2 * (0.5 + 0.227 * x2)) / radius;
    }
    let share = 1.0 / (x * x);
    (1.0 + share * (0.125 + 0.148 * share * share)) / distance.sin()
}
