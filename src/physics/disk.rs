//! The thin disk: where it begins, how hot it is, how its matter moves.

use crate::{
    physics::kerr::{CircularOrbit, Kerr},
    scene::{Disk, DiskModel, Scene},
};

/// The disk's inner edge, in r_s: `disk.inner`, or the innermost stable circular orbit where that lies farther out.
#[must_use]
pub fn inner_edge(scene: &Scene) -> f64 {
    scene.disk.inner.max(Kerr { spin: scene.hole.spin }.isco())
}

/// Relative bolometric flux, without unit, at radius `r` of a disk with inner edge `inner`; zero inside.
///
/// Newtonian: F = (r_in/r)^3 (1 - sqrt(r_in/r)), Shakura & Sunyaev 1973 without torque at the inner edge.
#[must_use]
pub fn flux(model: DiskModel, r: f64, inner: f64) -> f64 {
    match model {
        DiskModel::Newtonian => {
            let x = inner / r;
            if x < 1.0 { x.powi(3) * (1.0 - x.sqrt()) } else { 0.0 }
        }
    }
}

/// Temperature in kelvin at radius `r`, in the frame of the matter: T = temperature_k F^(1/4), after Stefan-Boltzmann.
#[must_use]
pub fn temperature(disk: &Disk, r: f64, inner: f64) -> f64 {
    disk.temperature_k * flux(disk.model, r, inner).powf(0.25)
}

/// g = observed over emitted frequency: g = 1 / (u^t (E - Omega L)), for light with the constants E = -p_t and L = p_phi
/// per unit frequency for the camera. Bardeen, Press & Teukolsky 1972 section III, Cunningham 1975; the same as
/// 1 / (E u^t (1 - Omega lambda)) with lambda = L/E.
///
/// The article's 1 + Omega L_n is the same number: its L_n is that of the backward ray, which is -lambda.
#[must_use]
pub fn redshift(orbit: &CircularOrbit, energy: f64, angular_momentum: f64) -> f64 {
    1.0 / (orbit.u_t * (energy - orbit.angular_velocity * angular_momentum))
}
