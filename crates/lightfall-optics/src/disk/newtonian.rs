//! The flux of a Newtonian thin disk. The twin in WGSL is shaders/disk/newtonian.wgsl.

/// The largest value of [`newtonian_flux`], at r = (49/36) r_in: (36/49)^3 / 7.
pub const NEWTONIAN_PEAK: f64 = 36.0 * 36.0 * 36.0 / (49.0 * 49.0 * 49.0 * 7.0);

/// Relative bolometric flux, without unit, at radius `r` of a disk with inner edge `inner`; zero
/// inside the edge.
///
/// F = (r_in/r)^3 (1 - sqrt(r_in/r)), Shakura & Sunyaev 1973 without torque at the inner edge.
pub fn newtonian_flux(r: f64, inner: f64) -> f64 {
    let x = inner / r;
    if x < 1.0 {
        x.powi(3) * (1.0 - x.sqrt())
    } else {
        0.0
    }
}
