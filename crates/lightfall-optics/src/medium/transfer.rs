//! The light that comes through matter, along one ray.

use super::nodes::Nodes;
use super::spans::Span;
use crate::delay::Lag;
use crate::reference::{self, HoleAndDisk, time_to_plane};
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries, PhotonState};

/// A place on the way of a ray. Where and when light left it cost more than the place itself.
pub struct Emission<'a> {
    pub(super) kerr: Kerr,
    pub(super) constants: &'a PhotonConstants,
    lag: &'a Lag<'a>,
    step: &'a reference::Step<'a>,
    /// Mino time since the start of the step.
    pub(super) time: f64,
}

impl Emission<'_> {
    /// The motion from the start of the step on.
    pub(super) fn series(&self) -> &PhotonSeries {
        self.step.expansion
    }

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

/// Matter with depth, which emits light or absorbs it.
pub(super) trait Emitter {
    /// The spans of a step of this length inside the matter, in the order of the backward ray. Within
    /// each of them its light is smooth.
    fn spans(&self, series: &PhotonSeries, length: f64) -> Vec<Span>;

    /// The light that a place emits, and its optical depth, for each unit of Mino time.
    fn rates(&self, at: &Emission) -> (DVec3, f64);
}

/// What fills the space around a hole.
pub(super) struct Filling<'a> {
    /// The hole, and the radii between which there is matter.
    pub way: HoleAndDisk,
    /// The matter with depth.
    pub emitters: Vec<&'a dyn Emitter>,
    /// The light of a sheet in the plane where a ray crosses it, and the optical depth of the sheet.
    pub sheet: Option<&'a dyn Fn(&Emission) -> (DVec3, f64)>,
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
    kerr: Kerr,
    constants: &'a PhotonConstants,
    step: &'a reference::Step<'a>,
    lag: &'a Lag<'a>,
    nodes: &'a Nodes,
}

impl Filling<'_> {
    /// Follows the backward ray with these constants from `start`, and returns the light that
    /// reaches its start.
    pub fn passage(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        nodes: &Nodes,
        tolerance: Tolerance,
    ) -> Passage {
        let kerr = self.way.kerr;
        let mut passage = Passage {
            light: DVec3::ZERO,
            depth: 0.0,
        };
        let mut lag = Lag::new(kerr, constants, &start);
        self.way.follow_to_inner_edge(constants, start, |step| {
            if passage.depth > tolerance.end_depth {
                return;
            }
            let step_way = Step {
                kerr,
                constants,
                step,
                lag: &lag,
                nodes,
            };
            passage = step_way.followed(passage, self, tolerance.relative);
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
    /// A passage, and what it meets in this step.
    fn followed(&self, mut passage: Passage, filling: &Filling, relative: f64) -> Passage {
        let (series, length) = (self.step.expansion, self.step.length);
        let emitters = filling.emitters.iter();
        let all_spans: Vec<_> = emitters.map(|e| (*e, e.spans(series, length))).collect();
        let spans = all_spans.iter().flat_map(|(_, spans)| spans);
        let mut marks: Vec<f64> = spans.flatten().copied().collect();
        let crossing = filling.sheet.and_then(|sheet| {
            let end = series.at(length).n.z;
            Some((sheet, time_to_plane(series, end, length)?))
        });
        marks.extend(crossing.map(|(_, time)| time));
        marks.sort_by(f64::total_cmp);
        for (i, from) in marks.iter().enumerate() {
            // A mark may be there twice; the sheet is met once.
            let repeated = i > 0 && marks[i - 1] == *from;
            if let Some((sheet, time)) = crossing
                && time == *from
                && !repeated
            {
                let (light, depth) = sheet(&self.emission(time));
                passage = passage.followed_by(Passage { light, depth });
            }
            let Some(to) = marks.get(i + 1).filter(|to| *to > from) else {
                continue;
            };
            let middle = 0.5 * (from + to);
            let within = |span: &&Span| span[0] <= middle && middle <= span[1];
            let there: Vec<_> = all_spans
                .iter()
                .filter(|(_, spans)| spans.iter().any(|span| within(&span)))
                .map(|(emitter, _)| *emitter)
                .collect();
            if !there.is_empty() {
                let span = [*from, *to];
                let whole = self.chunk(&there, span);
                let piece = self.refined(&there, span, whole, relative, MAX_HALVINGS);
                passage = passage.followed_by(piece);
            }
        }
        passage
    }

    fn emission(&self, time: f64) -> Emission<'_> {
        Emission {
            kerr: self.kerr,
            constants: self.constants,
            lag: self.lag,
            step: self.step,
            time,
        }
    }

    /// The light of a span, by the nodes.
    fn chunk(&self, emitters: &[&dyn Emitter], [from, to]: Span) -> Passage {
        let length = to - from;
        let sample = |place: &f64| {
            let at = self.emission(from + length * place);
            let rates = emitters.iter().map(|emitter| emitter.rates(&at));
            rates.fold((DVec3::ZERO, 0.0), |sum, (light, depth)| {
                (sum.0 + light, sum.1 + depth)
            })
        };
        let samples: Vec<(DVec3, f64)> = self.nodes.places.iter().map(sample).collect();
        let depth_by = |weights: &[f64]| {
            let terms = weights.iter().zip(&samples);
            length * terms.map(|(weight, (_, rate))| weight * rate).sum::<f64>()
        };
        let mut light = DVec3::ZERO;
        let rows = self.nodes.partial.iter().zip(&self.nodes.weights);
        for ((partial, weight), (emitted, _)) in rows.zip(&samples) {
            light += (-depth_by(partial)).exp() * weight * length * *emitted;
        }
        Passage {
            light,
            depth: depth_by(&self.nodes.weights),
        }
    }

    /// The light of a span whose chunk is `whole`, halved until the halves agree with it.
    fn refined(
        &self,
        emitters: &[&dyn Emitter],
        [from, to]: Span,
        whole: Passage,
        relative: f64,
        halvings: u32,
    ) -> Passage {
        let middle = 0.5 * (from + to);
        let [near, far] = [[from, middle], [middle, to]];
        let [first, second] = [near, far].map(|span| self.chunk(emitters, span));
        let halves = first.followed_by(second);
        if halvings == 0 || whole.agrees(&halves, relative) {
            return halves;
        }
        let first = self.refined(emitters, near, first, relative, halvings - 1);
        first.followed_by(self.refined(emitters, far, second, relative, halvings - 1))
    }
}
