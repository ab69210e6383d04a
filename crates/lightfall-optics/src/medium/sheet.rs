//! A disk without thickness among matter with depth: what a ray meets where it crosses the plane.

use super::emission::{Emission, Rates};
use crate::disk::{self, Profile, lit, temperature};
use crate::limb::Limb;
use crate::photometry::DISK_HDR_SCALE;
use crate::reference::HoleAndDisk;
use crate::shift::Shift;
use crate::spectrum;
use crate::structure::{Covariance, Event, Structure};
use glam::DVec3;
use lightfall_model::geometry::observer::Photon;
use lightfall_model::scene::Scene;

/// The disk of a scene.
#[derive(Clone, Debug)]
pub(super) struct Sheet {
    scene: Scene,
    way: HoleAndDisk,
    profile: Profile,
    limb: Limb,
    shift: Shift,
    structure: Option<Structure>,
}

impl Sheet {
    /// The disk of a scene; `None` if it has none, or one with thickness.
    pub fn of(scene: &Scene) -> Option<Self> {
        let there = scene.disk.enabled && !scene.has_thick_disk();
        there.then(|| Self {
            way: HoleAndDisk {
                kerr: scene.kerr(),
                annulus: Some([scene.inner_edge(), scene.disk.outer]),
            },
            profile: Profile::new(scene),
            limb: Limb::new(scene),
            shift: Shift::new(scene),
            structure: Structure::new(scene, None),
            scene: scene.clone(),
        })
    }

    /// What the disk does to the ray of this photon at the camera where it crosses the plane; `None`
    /// outside of the disk's edges.
    pub fn crossed(&self, photon: &Photon, at: &Emission) -> Option<Rates> {
        let crossing = at.series().at(at.time);
        let r = crossing.u.recip();
        let hit = self.way.hit(at.constants, &crossing);
        let inside = self
            .way
            .annulus
            .is_some_and(|[inner, outer]| r > inner && r < outer);
        let hit = hit.filter(|_| inside)?;
        let scene = &self.scene;
        let factor = self.structure.as_ref().map_or(1.0, |structure| {
            let event = Event {
                r,
                phi: hit.phi,
                cos_theta: 0.0,
                time: scene.disk.time - at.lag(),
            };
            let field = structure.field(&event, Covariance::POINT);
            field.factor(structure.model.contrast)
        });
        let lambda = at.constants.angular_momentum / at.constants.energy;
        let g = self.shift.of_disk(hit.g, r, lambda);
        let (flux, lit) = (self.profile.flux(r) * factor, lit(scene));
        let scale = flux * self.shift.beaming_factor(g) * self.limb.factor(photon, r);
        let colour = DVec3::from(spectrum::colour(g * temperature(&lit, flux)));
        Some(Rates {
            light: colour * scale * lit.brightness * DISK_HDR_SCALE * disk::cover(scene, r),
            depth: -disk::transmission(scene, r).ln(),
            g: hit.g,
        })
    }
}
