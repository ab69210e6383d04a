//! The light of jets on the way of a ray.

use super::Jet;
use crate::medium::emission::{Emission, Emitter, Rates};
use crate::medium::nodes::Nodes;
use crate::medium::passage::Passage;
use crate::medium::spans::{Span, spans};
use crate::medium::transfer::{Filling, Tolerance};
use glam::DVec3;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries, PhotonState};

/// A place in the jets on the way of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JetPlace {
    /// Radius, in r_s.
    pub r: f64,
    /// n_z, the cosine of the angle from the disk's normal.
    pub cos_theta: f64,
    /// Observed over emitted frequency of the matter's light.
    pub g: f64,
}

/// Jets, and the light that the camera sees for each unit of their emission.
pub(crate) struct JetMatter<'a, L> {
    pub jet: &'a Jet,
    pub light: L,
}

impl<L: Fn(&JetPlace, &Emission) -> DVec3> Emitter for JetMatter<'_, L> {
    fn spans(&self, series: &PhotonSeries, length: f64) -> Vec<Span> {
        let inside = |r: f64, z: f64| self.jet.inside(r, z);
        spans(&inside, &self.jet.radii(), series, length)
    }

    fn rates(&self, at: &Emission) -> Rates {
        let ((u, du), (cos_theta, dz)) = (at.series().u.at(at.time), at.series().n[2].at(at.time));
        let r = u.recip();
        let constants = [at.constants.energy, at.constants.angular_momentum];
        let slowing = self.jet.slowing([r, cos_theta], constants, [du, dz]);
        let place = JetPlace {
            r,
            cos_theta,
            g: slowing.recip(),
        };
        let length = slowing * self.jet.kerr.sigma(r, cos_theta);
        let emitted = self.jet.emissivity(r, cos_theta) * length;
        Rates {
            light: emitted * (self.light)(&place, at),
            depth: 0.0,
            g: place.g,
        }
    }
}

impl Jet {
    /// Follows the backward ray with these constants from `start`, and returns the light that
    /// reaches its start. `light` is what the camera sees for each unit of emission.
    pub fn passage(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        nodes: &Nodes,
        tolerance: Tolerance,
        light: impl Fn(&JetPlace, &Emission) -> DVec3,
    ) -> Passage {
        let matter = JetMatter { jet: self, light };
        let radii = [self.shape.base, self.shape.length];
        let filling = Filling::of_one(self.kerr, radii, &matter);
        filling.passage(constants, start, nodes, tolerance)
    }
}
