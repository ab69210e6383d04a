//! The light that comes through a medium, along one ray.

use super::nodes::Nodes;
use super::spans::{Span, spans};
use super::thick_disk::ThickDisk;
use crate::reference::HoleAndDisk;
use glam::DVec3;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries, PhotonState};

/// A place on the way of a ray inside a medium.
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

/// What reaches the camera along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage {
    /// The light of the medium.
    pub light: DVec3,
    /// The optical depth of the whole way.
    pub depth: f64,
}

/// How well light is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The largest difference between a chunk and its halves, as a share of the light so far.
    pub relative: f64,
    /// The optical depth after which a ray ends.
    pub end_depth: f64,
}

impl Tolerance {
    /// Light to ten digits: what everything else is measured against.
    pub const TRUTH: Self = Self {
        relative: 1e-11,
        end_depth: 60.0,
    };
}

/// Maximum number of times that a chunk is halved.
const MAX_HALVINGS: u32 = 16;

/// The ray's way through one step, and what integrates it.
struct Step<'a> {
    disk: &'a ThickDisk,
    constants: &'a PhotonConstants,
    series: &'a PhotonSeries,
    nodes: &'a Nodes,
    light: &'a dyn Fn(&Place) -> DVec3,
}

impl ThickDisk {
    /// Follows the backward ray with these constants from `start`, and returns the light that
    /// reaches its start. `light` is the radiance of an opaque body in the place of the matter, as
    /// the camera sees it.
    pub fn passage(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        nodes: &Nodes,
        tolerance: Tolerance,
        light: impl Fn(&Place) -> DVec3,
    ) -> Passage {
        let way = HoleAndDisk {
            kerr: self.kerr,
            annulus: Some(self.shape.edges),
        };
        let mut passage = Passage {
            light: DVec3::ZERO,
            depth: 0.0,
        };
        way.follow_to_inner_edge(constants, start, |step| {
            if passage.depth > tolerance.end_depth {
                return;
            }
            let step_way = Step {
                disk: self,
                constants,
                series: step.expansion,
                nodes,
                light: &light,
            };
            for span in spans(self, step.expansion, step.length) {
                let whole = step_way.chunk(span);
                let limit = tolerance.relative;
                let piece = step_way.refined(span, whole, limit, MAX_HALVINGS);
                passage = passage.followed_by(piece);
            }
        });
        passage
    }
}

impl Passage {
    /// This part of a ray's way, and the next one behind it.
    fn followed_by(self, next: Self) -> Self {
        Self {
            light: self.light + (-self.depth).exp() * next.light,
            depth: self.depth + next.depth,
        }
    }

    /// Whether another result for the same way agrees.
    fn agrees(&self, other: &Self, relative: f64) -> bool {
        let size = self.light.abs().max_element();
        let light = (self.light - other.light).abs().max_element() <= relative * size;
        let depth = (self.depth - other.depth).abs() <= relative * self.depth.max(1.0);
        light && depth
    }
}

impl Step<'_> {
    /// The place at a Mino time, and the optical depth for each unit of Mino time.
    fn at(&self, t: f64) -> (Place, f64) {
        let (r, cos_theta) = (self.series.u.at(t).0.recip(), self.series.n[2].at(t).0);
        let [omega, u_t] = self.disk.rotation(r, cos_theta);
        let constants = self.constants;
        let emitted = u_t * (constants.energy - omega * constants.angular_momentum);
        let place = Place {
            r,
            cos_theta,
            g: emitted.recip(),
            source: self.disk.source(r, cos_theta),
        };
        let length = emitted * self.disk.kerr.sigma(r, cos_theta);
        (place, self.disk.opacity(r, cos_theta) * length)
    }

    /// The light of a span, by the nodes.
    fn chunk(&self, [from, to]: Span) -> Passage {
        let length = to - from;
        let sample = |place: &f64| self.at(from + length * place);
        let samples: Vec<(Place, f64)> = self.nodes.places.iter().map(sample).collect();
        let depth_by = |weights: &[f64]| {
            let terms = weights.iter().zip(&samples);
            length * terms.map(|(weight, (_, rate))| weight * rate).sum::<f64>()
        };
        let mut light = DVec3::ZERO;
        let rows = self.nodes.partial.iter().zip(&self.nodes.weights);
        for ((partial, weight), (place, rate)) in rows.zip(&samples) {
            let seen = (-depth_by(partial)).exp() * weight * length * rate;
            light += seen * place.source * (self.light)(place);
        }
        Passage {
            light,
            depth: depth_by(&self.nodes.weights),
        }
    }

    /// The light of a span whose chunk is `whole`, halved until the halves agree with it.
    fn refined(&self, [from, to]: Span, whole: Passage, relative: f64, halvings: u32) -> Passage {
        let middle = 0.5 * (from + to);
        let [near, far] = [[from, middle], [middle, to]];
        let [first, second] = [near, far].map(|span| self.chunk(span));
        let halves = first.followed_by(second);
        if halvings == 0 || whole.agrees(&halves, relative) {
            return halves;
        }
        let first = self.refined(near, first, relative, halvings - 1);
        first.followed_by(self.refined(far, second, relative, halvings - 1))
    }
}
