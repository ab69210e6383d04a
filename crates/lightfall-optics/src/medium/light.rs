//! The light of a scene's matter with depth.

use super::nodes::Nodes;
use super::thick_disk::ThickDisk;
use super::transfer::{Emission, Matter, Passage, Place, Tolerance};
use crate::camera_rays::camera_in_disk_frame;
use crate::disk::{Profile, lit, temperature};
use crate::photometry::DISK_HDR_SCALE;
use crate::shift::Shift;
use crate::spectrum;
use crate::structure::{Covariance, Event, Structure};
use glam::DVec3;
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::observer::Photon;
use lightfall_model::scene::{Disk, DiskStructure, Scene};

/// The matter with depth of a scene, and how it shines for the scene's camera.
#[derive(Clone, Debug)]
pub struct Medium {
    disk: ThickDisk,
    nodes: Nodes,
    profile: Profile,
    lit: Disk,
    shift: Shift,
    structure: Option<Structure>,
    /// Standard deviations of the logarithms of the flux and of the density.
    spread: [f64; 2],
    r: f64,
    n: DVec3,
}

impl Medium {
    /// The medium of a scene, integrated with so many nodes in a chunk; `None` if it has none.
    pub fn of(scene: &Scene, nodes: usize) -> Option<Self> {
        let structure = Structure::new(scene, None);
        let spread = structure
            .as_ref()
            .map_or([0.0; 2], |structure| structure.spread(&scene.disk));
        Some(Self {
            structure,
            spread,
            disk: ThickDisk::of(scene)?,
            nodes: Nodes::new(nodes),
            profile: Profile::new(scene),
            lit: lit(scene),
            shift: Shift::new(scene),
            r: scene.camera.r,
            n: camera_in_disk_frame(scene),
        })
    }

    /// As [`Self::of`], without the disk's structure.
    pub fn smooth(scene: &Scene, nodes: usize) -> Option<Self> {
        let mut smooth = scene.clone();
        smooth.disk.structure = DiskStructure::None;
        Self::of(&smooth, nodes)
    }

    /// The light in linear sRGB that reaches the camera as this photon, given in the disk's frame,
    /// and the optical depth of its way.
    pub fn seen(&self, photon: &Photon, tolerance: Tolerance) -> Passage {
        let (constants, start) = PhotonConstants::of_photon(self.disk.kerr, photon, self.r, self.n);
        let lambda = constants.angular_momentum / constants.energy;
        let matter = |place: &Place, emission: &Emission| {
            let [flux, density] = self.factors(place, emission);
            Matter {
                density,
                light: self.body_light(place, lambda, flux),
            }
        };
        self.disk
            .passage(&constants, start, &self.nodes, tolerance, matter)
    }

    /// The factors by which the structure multiplies the flux and the density.
    fn factors(&self, place: &Place, emission: &Emission) -> [f64; 2] {
        let Some(structure) = &self.structure else {
            return [1.0; 2];
        };
        let event = Event {
            r: place.r,
            phi: emission.azimuth(),
            cos_theta: place.cos_theta,
            time: self.lit.time - emission.lag(),
        };
        let field = structure.field(&event, Covariance::POINT);
        self.spread.map(|sigma| field.factor(sigma))
    }

    /// The radiance of an opaque body in the place of the matter, as the camera sees it, with the flux
    /// multiplied by a factor.
    fn body_light(&self, place: &Place, lambda: f64, factor: f64) -> DVec3 {
        let theta = place.cos_theta.clamp(-1.0, 1.0).acos();
        let g = self.shift.of_matter(place.g, (place.r, theta), lambda);
        let flux = self.profile.flux(place.r) * factor;
        let colour = DVec3::from(spectrum::colour(g * temperature(&self.lit, flux)));
        colour * flux * self.shift.beaming_factor(g) * self.lit.brightness * DISK_HDR_SCALE
    }
}
