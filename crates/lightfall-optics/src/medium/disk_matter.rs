//! The light of a disk with thickness on the way of a ray.

use super::emission::{Emission, Emitter, Rates};
use super::nodes::Nodes;
use super::passage::Passage;
use super::spans::{Span, spans};
use super::thick_disk::ThickDisk;
use super::transfer::{Filling, Tolerance};
use glam::DVec3;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries, PhotonState};

/// A place in a disk on the way of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Radius, in r_s.
    pub r: f64,
    /// n_z, the cosine of the angle from the disk's normal.
    pub cos_theta: f64,
    /// Observed over emitted frequency of the matter's light.
    pub g: f64,
    /// The source function over F/pi.
    pub source: f64,
}

/// What the matter does to light at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matter {
    /// Its density over that of the smooth disk.
    pub density: f64,
    /// The radiance of an opaque body in its place, as the camera sees it.
    pub light: DVec3,
}

impl Matter {
    /// Matter of a smooth disk.
    pub fn smooth(light: DVec3) -> Self {
        Self {
            density: 1.0,
            light,
        }
    }
}

/// A disk, and what its matter does at a place.
pub(super) struct DiskMatter<'a, M> {
    pub disk: &'a ThickDisk,
    pub matter: M,
}

impl<M: Fn(&Place, &Emission) -> Matter> Emitter for DiskMatter<'_, M> {
    fn spans(&self, series: &PhotonSeries, length: f64) -> Vec<Span> {
        let inside = |r: f64, z: f64| {
            let opening = self.disk.half_opening(r);
            opening * opening - z * z
        };
        spans(&inside, &self.disk.radii(), series, length)
    }

    fn rates(&self, at: &Emission) -> Rates {
        let (series, constants) = (at.series(), at.constants);
        let (r, cos_theta) = (series.u.at(at.time).0.recip(), series.n[2].at(at.time).0);
        let [omega, u_t] = self.disk.rotation(r, cos_theta);
        let emitted = u_t * (constants.energy - omega * constants.angular_momentum);
        let place = Place {
            r,
            cos_theta,
            g: emitted.recip(),
            source: self.disk.source(r, cos_theta),
        };
        let matter = (self.matter)(&place, at);
        let length = emitted * self.disk.kerr.sigma(r, cos_theta);
        let rate = self.disk.opacity(r, cos_theta) * matter.density * length;
        Rates {
            light: rate * place.source * matter.light,
            depth: rate,
            g: place.g,
        }
    }
}

impl ThickDisk {
    /// Follows the backward ray with these constants from `start`, and returns the light that
    /// reaches its start. `matter` says what the matter at a place does.
    pub fn passage(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        nodes: &Nodes,
        tolerance: Tolerance,
        matter: impl Fn(&Place, &Emission) -> Matter,
    ) -> Passage {
        let disk = DiskMatter { disk: self, matter };
        let filling = Filling::of_one(self.kerr, self.shape.edges, &disk);
        filling.passage(constants, start, nodes, tolerance)
    }
}
