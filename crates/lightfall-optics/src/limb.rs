//! Limb darkening: the brightness of the disk's surface as a function of the angle of emission. The
//! twin in WGSL is shaders/disk/limb/electron_scattering.wgsl.

use crate::camera_rays::camera_in_disk_frame;
use crate::shift::{RestFrame, Shift};
use crate::{disk, straight};
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::Photon;
use lightfall_model::scene::{LimbDarkening, Scene};
use std::f64::consts::FRAC_PI_2;

/// Intensity of an electron-scattering atmosphere over its mean, flux/pi, as a function of the
/// cosine `mu` of the angle between the light and the normal.
///
/// It is a fit to Chandrasekhar 1960, table XXIV, within 0.25 % of the table. The usual fit,
/// 0.41441 (1 + 2.06 mu), is wrong by up to 4.8 %, and by 1.6 % in the flux. Here the flux is
/// exact: the integral of 2 mu times this from 0 to 1 is 0.41344 + (4/5) 0.1137 + (2/3) 0.7434 = 1.
pub fn electron_scattering(mu: f64) -> f64 {
    0.413_44 + 0.1137 * mu.sqrt() + 0.7434 * mu
}

/// The limb darkening of a scene's disk, for the light that its camera sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb {
    law: LimbDarkening,
    kerr: Kerr,
    lensing: bool,
    camera_lapse: f64,
    camera_r: f64,
    n: DVec3,
}

impl Limb {
    /// The limb darkening of the scene's disk.
    pub fn new(scene: &Scene) -> Self {
        Self {
            law: scene.disk.limb,
            kerr: scene.kerr(),
            lensing: scene.effects.lensing,
            camera_lapse: Shift::new(scene).camera().lapse,
            camera_r: scene.camera.r,
            n: camera_in_disk_frame(scene),
        }
    }

    /// The ratio of the intensity of light from the disk at `r`, which is `photon` at the camera,
    /// to the mean of all directions.
    pub fn factor(&self, photon: &Photon, r: f64) -> f64 {
        match self.law {
            LimbDarkening::None => 1.0,
            LimbDarkening::ElectronScattering => {
                self.cosine(photon, r).map_or(0.0, electron_scattering)
            }
        }
    }

    /// The cosine of the angle between the light from `r` and the disk's normal for the matter
    /// there (Cunningham 1975): mu = g sqrt(Q) / r, with g and Q per unit frequency for the camera.
    /// `None` where no matter can orbit.
    ///
    /// On straight rays sqrt(Q) is the light's momentum along the normal for the observer with zero
    /// angular momentum (ZAMO) at the camera. That of the ZAMO at the disk is larger by the ratio
    /// of their lapses, and the matter moves along the disk, which does not change it.
    pub fn cosine(&self, photon: &Photon, r: f64) -> Option<f64> {
        let orbit = self.kerr.circular_orbit(r)?;
        let j = self.camera_r * self.n.cross(photon.w);
        let across = j.x * j.x + j.y * j.y;
        let (normal, angular_momentum) = if self.lensing {
            let q = across - (self.kerr.a() * photon.energy * self.n.z).powi(2);
            (q.max(0.0).sqrt(), j.z)
        } else {
            let lapse = RestFrame::at(self.kerr, r, FRAC_PI_2).lapse;
            // The photon's momentum for the camera's ZAMO is its energy over the lapse.
            let moment_z = -j.z * self.camera_lapse / photon.energy;
            let lambda = straight::lambda(self.kerr, &orbit, r, moment_z);
            (
                across.sqrt() * self.camera_lapse / lapse,
                photon.energy * lambda,
            )
        };
        let g = disk::redshift(&orbit, photon.energy, angular_momentum);
        Some((g * normal / r).clamp(0.0, 1.0))
    }
}
