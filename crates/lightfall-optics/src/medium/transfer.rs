//! The light that comes through a medium, along one ray.

use super::nodes::Nodes;
use super::spans::{Span, spans};
use super::thick_disk::ThickDisk;
use crate::delay::Lag;
use crate::reference::{self, HoleAndDisk};
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonState};

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

/// Where and when light left a place. Both cost more than the place itself, and a smooth disk needs
/// neither.
pub struct Emission<'a> {
    kerr: Kerr,
    constants: &'a PhotonConstants,
    lag: &'a Lag<'a>,
    step: &'a reference::Step<'a>,
    /// Mino time since the start of the step.
    time: f64,
}

impl Emission<'_> {
    /// Boyer-Lindquist azimuth, in radians, of any number of turns.
    pub fn azimuth(&self) -> f64 {
        let state = self.step.expansion.at(self.time);
        let lead = if self.constants.ingoing {
            self.kerr.ingoing_azimuth_lead(1.0 / state.u)
        } else {
            0.0
        };
        state.n.y.atan2(state.n.x) + state.chi - lead
    }

    /// Time from the emission to the arrival at the camera, in r_s/c: [`Lag`].
    pub fn lag(&self) -> f64 {
        self.lag.at(self.step, self.time)
    }
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
    step: &'a reference::Step<'a>,
    lag: &'a Lag<'a>,
    nodes: &'a Nodes,
    matter: &'a dyn Fn(&Place, &Emission) -> Matter,
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
        let way = HoleAndDisk {
            kerr: self.kerr,
            annulus: Some(self.shape.edges),
        };
        let mut passage = Passage {
            light: DVec3::ZERO,
            depth: 0.0,
        };
        let mut lag = Lag::new(self.kerr, constants, &start);
        way.follow_to_inner_edge(constants, start, |step| {
            if passage.depth > tolerance.end_depth {
                return;
            }
            let step_way = Step {
                disk: self,
                constants,
                step,
                lag: &lag,
                nodes,
                matter: &matter,
            };
            for span in spans(self, step.expansion, step.length) {
                let whole = step_way.chunk(span);
                let limit = tolerance.relative;
                let piece = step_way.refined(span, whole, limit, MAX_HALVINGS);
                passage = passage.followed_by(piece);
            }
            lag.add(step);
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
    /// The light of opaque matter at a Mino time, and the optical depth for each unit of Mino time.
    fn at(&self, t: f64) -> (DVec3, f64) {
        let series = self.step.expansion;
        let (r, cos_theta) = (series.u.at(t).0.recip(), series.n[2].at(t).0);
        let [omega, u_t] = self.disk.rotation(r, cos_theta);
        let constants = self.constants;
        let emitted = u_t * (constants.energy - omega * constants.angular_momentum);
        let place = Place {
            r,
            cos_theta,
            g: emitted.recip(),
            source: self.disk.source(r, cos_theta),
        };
        let emission = Emission {
            kerr: self.disk.kerr,
            constants,
            lag: self.lag,
            step: self.step,
            time: t,
        };
        let matter = (self.matter)(&place, &emission);
        let length = emitted * self.disk.kerr.sigma(r, cos_theta);
        let rate = self.disk.opacity(r, cos_theta) * matter.density * length;
        (place.source * matter.light, rate)
    }

    /// The light of a span, by the nodes.
    fn chunk(&self, [from, to]: Span) -> Passage {
        let length = to - from;
        let sample = |place: &f64| self.at(from + length * place);
        let samples: Vec<(DVec3, f64)> = self.nodes.places.iter().map(sample).collect();
        let depth_by = |weights: &[f64]| {
            let terms = weights.iter().zip(&samples);
            length * terms.map(|(weight, (_, rate))| weight * rate).sum::<f64>()
        };
        let mut light = DVec3::ZERO;
        let rows = self.nodes.partial.iter().zip(&self.nodes.weights);
        for ((partial, weight), (source, rate)) in rows.zip(&samples) {
            light += (-depth_by(partial)).exp() * weight * length * rate * *source;
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
