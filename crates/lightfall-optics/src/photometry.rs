//! Photometry: from the disk's relative flux to the linear light of a picture.

use crate::{disk, spectrum};
use glam::DVec3;
use lightfall_model::scene::Scene;
use std::f64::consts::PI;

/// Linear light of the disk per unit of `disk.brightness` and relative flux. The profile peaks at
/// 0.057, and light as bright as white paper is 1.
pub const DISK_HDR_SCALE: f64 = 10.0;

/// One of the rings of equal width that a scene's disk is divided into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiskRing {
    /// Mean of its two radii, in r_s.
    pub radius: f64,
    /// Area in the flat plane, in r_s^2.
    pub area: f64,
}

/// Light that a ring of the disk emits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingLight {
    /// Luminous power of both faces, in the units of traced light times r_s^2.
    pub power: f64,
    /// Linear sRGB; the largest channel is 1, and a channel outside the gamut is negative.
    pub colour: DVec3,
}

impl DiskRing {
    /// Ring `index` of `count`, counted from the inner edge. The area is zero where the disk's
    /// outer edge lies inside its inner one.
    pub fn new(scene: &Scene, index: usize, count: usize) -> Self {
        let inner = scene.inner_edge();
        let edge =
            |ring: usize| inner + (scene.disk.outer - inner).max(0.0) * ring as f64 / count as f64;
        let (low, high) = (edge(index), edge(index + 1));
        Self {
            radius: 0.5 * (low + high),
            area: PI * (high * high - low * low),
        }
    }

    /// The ring's light with the flux at its mean radius, without any shift.
    ///
    /// A Lambertian face of radiance B and area A emits the power pi B A.
    pub fn light(&self, scene: &Scene) -> RingLight {
        let flux = disk::Profile::new(scene).flux(self.radius);
        let lit = disk::lit(scene);
        let rgb = DVec3::from(spectrum::colour(disk::temperature(&lit, flux)));
        let largest = rgb.max_element().max(f64::MIN_POSITIVE);
        let radiance = largest * flux * DISK_HDR_SCALE * lit.brightness;
        RingLight {
            power: 2.0 * PI * radiance * self.area,
            colour: rgb / largest,
        }
    }
}
