//! The thin disk: its inner edge, its flux and temperature, and the redshift of its light. The
//! twins in WGSL are shaders/disk.wgsl and shaders/disk/emission.wgsl.

mod newtonian;
mod page_thorne;
pub mod returning;
pub mod returning_table;

pub use newtonian::{NEWTONIAN_PEAK, newtonian_flux};
pub use page_thorne::{PageThorne, TABLE_LEN};
use returning_table::ReturningLight;

use lightfall_model::geometry::kerr::CircularOrbit;
use lightfall_model::scene::{Disk, DiskModel, Scene};
use std::f64::consts::TAU;

/// The period of an orbit at the disk's inner edge, in r_s/c of Boyer-Lindquist's time: that of a
/// distant clock.
pub fn inner_period(scene: &Scene) -> Option<f64> {
    let kerr = scene.kerr();
    let orbit = kerr.circular_orbit(scene.inner_edge())?;
    Some(TAU / orbit.angular_velocity)
}

/// The radial profile of a scene's disk.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "a scene has one profile, which is made once and passed by reference"
)]
pub enum Profile {
    /// [`newtonian_flux`] of a disk with this inner edge, in r_s.
    Newtonian(f64),
    /// The flux of a relativistic disk around a Kerr hole.
    PageThorne(PageThorne),
}

impl Profile {
    /// The profile of the scene's model, spin and inner edge.
    pub fn new(scene: &Scene) -> Self {
        let inner = scene.inner_edge();
        match scene.disk.model {
            DiskModel::Newtonian => Self::Newtonian(inner),
            DiskModel::PageThorne => {
                let spin = scene.hole.spin;
                let disk = PageThorne::new(spin, inner);
                Self::PageThorne(if scene.has_returning_light() {
                    disk.with_returning(ReturningLight::new(spin, scene.disk.limb))
                } else {
                    disk
                })
            }
        }
    }

    /// Relative bolometric flux at radius `r`, in the frame of the matter; zero inside the inner
    /// edge. Without returning light both profiles peak at [`NEWTONIAN_PEAK`].
    pub fn flux(&self, r: f64) -> f64 {
        match self {
            Self::Newtonian(inner) => newtonian_flux(r, *inner),
            Self::PageThorne(disk) => disk.flux(r),
        }
    }
}

/// Inner edge for which the temperature scale and the brightness of a disk that keeps its accretion
/// rate are given, in r_s: the innermost stable orbit without spin.
const STANDARD_EDGE: f64 = 3.0;

/// The scene's disk, with the temperature scale and the brightness for the flux of its profile.
///
/// A profile's peak has a fixed height, but at a fixed accretion rate the flux far out, F ->
/// const/r^3, does not depend on the edge. So the profile (r_in/r)^3 (1 - ...) is multiplied by
/// (3/r_in)^3, and by Page & Thorne's own flux per rate over the scaled one. T goes with the fourth
/// root.
pub fn lit(scene: &Scene) -> Disk {
    let mut disk = scene.disk;
    if disk.keep_accretion {
        let per_peak = match Profile::new(scene) {
            Profile::Newtonian(_) => 1.0,
            Profile::PageThorne(profile) => 1.0 / profile.scale(),
        };
        let gain = per_peak * (STANDARD_EDGE / scene.inner_edge()).powi(3);
        disk.temperature_k *= gain.powf(0.25);
        disk.brightness *= gain;
    }
    disk
}

/// Temperature, in kelvin and in the frame of the matter, where the relative flux is `flux`: T =
/// temperature_k F^(1/4), by the Stefan-Boltzmann law.
pub fn temperature(disk: &Disk, flux: f64) -> f64 {
    disk.temperature_k * flux.powf(0.25)
}

/// The disk's coverage at radius `r`, from 0 to 1: emission and opacity fade together at both
/// edges. The twin in WGSL is `disk_cover` in shaders/disk/emission.wgsl.
pub fn cover(scene: &Scene, r: f64) -> f64 {
    let (inner, disk) = (scene.inner_edge(), &scene.disk);
    let fade = |depth: f64, edge: f64| {
        let share = (depth / (disk.edge_taper * edge).max(1e-6)).clamp(0.0, 1.0);
        share * share * (3.0 - 2.0 * share)
    };
    fade(r - inner, inner) * fade(disk.outer - r, disk.outer)
}

/// Share of the light from behind that passes through the disk at radius `r`.
pub fn transmission(scene: &Scene, r: f64) -> f64 {
    1.0 - (1.0 - scene.disk.transmission) * cover(scene, r)
}

/// Observed over emitted frequency, g = 1 / (u^t (E - Omega L)), for light with the constants E =
/// -p_t and L = p_phi per unit frequency for the camera. Bardeen, Press & Teukolsky 1972 section
/// III, Cunningham 1975; equal to 1 / (E u^t (1 - Omega lambda)) with lambda = L/E.
///
/// The article's 1 + Omega L_n is the same number, since its L_n belongs to the backward ray and is
/// -lambda.
pub fn redshift(orbit: &CircularOrbit, energy: f64, angular_momentum: f64) -> f64 {
    1.0 / (orbit.u_t * (energy - orbit.angular_velocity * angular_momentum))
}
