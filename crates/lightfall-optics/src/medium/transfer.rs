//! The light that comes through matter, along one ray.

use super::emission::{Emission, Emitter, Rates};
use super::means::Sums;
use super::nodes::Nodes;
use super::passage::Passage;
use super::spans::Span;
use crate::delay::Lag;
use crate::reference::{self, HoleAndDisk, time_to_plane};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonState};

/// What fills the space around a hole.
pub(super) struct Filling<'a> {
    /// The hole, and the radii between which there is matter.
    pub way: HoleAndDisk,
    /// The matter with depth.
    pub emitters: Vec<&'a dyn Emitter>,
    /// What a sheet in the plane does to a ray that crosses it; `None` where there is no sheet at
    /// the crossing.
    pub sheet: Option<&'a dyn Fn(&Emission) -> Option<Rates>>,
    /// Whether passages say where their light comes from.
    pub with_means: bool,
}

/// A piece of a ray's way: what it met there, from the camera on.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    /// Mino times since the camera at which it begins and ends.
    pub times: [f64; 2],
    /// The radii, in r_s, and the heights above the plane, in r_s, of its ends.
    pub ends: [[f64; 2]; 2],
    /// The indices of the emitters in it; none in a sheet.
    pub emitters: Vec<usize>,
    /// What it does to the ray.
    pub passage: Passage,
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
    /// Mino time at its start.
    start: f64,
}

impl<'a> Filling<'a> {
    /// One kind of matter, between two radii.
    pub fn of_one(kerr: Kerr, radii: [f64; 2], emitter: &'a dyn Emitter) -> Self {
        Self {
            way: HoleAndDisk {
                kerr,
                annulus: Some(radii),
            },
            emitters: vec![emitter],
            sheet: None,
            with_means: false,
        }
    }

    /// Follows the backward ray with these constants from `start`, and returns the light that
    /// reaches its start.
    pub fn passage(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        nodes: &Nodes,
        tolerance: Tolerance,
    ) -> Passage {
        let mut passage = Passage::default();
        self.follow(constants, start, nodes, tolerance, |piece| {
            passage = passage.followed_by(piece.passage);
        });
        passage
    }

    /// As [`Self::passage`], piece by piece.
    pub fn follow(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        nodes: &Nodes,
        tolerance: Tolerance,
        mut meet: impl FnMut(Piece),
    ) {
        let kerr = self.way.kerr;
        let (mut depth, mut time) = (0.0, 0.0);
        let mut lag = Lag::new(kerr, constants, &start);
        self.way.follow_to_inner_edge(constants, start, |step| {
            if depth > tolerance.end_depth {
                return;
            }
            let step_way = Step {
                kerr,
                constants,
                step,
                lag: &lag,
                nodes,
                start: time,
            };
            step_way.follow(self, tolerance.relative, &mut |piece| {
                depth += piece.passage.depth;
                meet(piece);
            });
            lag.add(step);
            time += step.length;
        });
    }
}

/// The emitters of a span.
struct MatterThere<'a> {
    emitters: Vec<&'a dyn Emitter>,
    with_means: bool,
}

impl MatterThere<'_> {
    /// What a place does to a ray, for each unit of Mino time.
    fn sample(&self, at: &Emission) -> Passage {
        let mut sample = Passage::default();
        for emitter in &self.emitters {
            let Rates { light, depth, g } = emitter.rates(at);
            sample.light += light;
            sample.depth += depth;
            if self.with_means {
                sample.sums = sample.sums + Sums::of(light, &at.place(g));
            }
        }
        sample
    }
}

impl Step<'_> {
    /// Gives the pieces of this step in their order.
    fn follow(&self, filling: &Filling, relative: f64, meet: &mut impl FnMut(Piece)) {
        let (series, length) = (self.step.expansion, self.step.length);
        let emitters = filling.emitters.iter();
        let all_spans: Vec<_> = emitters.map(|e| e.spans(series, length)).collect();
        let mut marks: Vec<f64> = all_spans.iter().flatten().flatten().copied().collect();
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
                let at = self.emission(time);
                if let Some(rates) = sheet(&at) {
                    let sums = if filling.with_means {
                        Sums::of(rates.light, &at.place(rates.g))
                    } else {
                        Sums::default()
                    };
                    let passage = Passage {
                        light: rates.light,
                        depth: rates.depth,
                        sums,
                    };
                    meet(self.piece([time; 2], Vec::new(), passage));
                }
            }
            let Some(to) = marks.get(i + 1).filter(|to| *to > from) else {
                continue;
            };
            let middle = 0.5 * (from + to);
            let within = |span: &Span| span[0] <= middle && middle <= span[1];
            let spans = all_spans.iter().enumerate();
            let there = spans.filter(|(_, spans)| spans.iter().any(within));
            let there: Vec<usize> = there.map(|(index, _)| index).collect();
            if !there.is_empty() {
                let matter = MatterThere {
                    emitters: there.iter().map(|index| filling.emitters[*index]).collect(),
                    with_means: filling.with_means,
                };
                let span = [*from, *to];
                let whole = self.chunk(&matter, span);
                let passage = self.refined(&matter, span, whole, relative, MAX_HALVINGS);
                meet(self.piece(span, there, passage));
            }
        }
    }

    /// The piece between two times of this step.
    fn piece(&self, times: [f64; 2], emitters: Vec<usize>, passage: Passage) -> Piece {
        let end = |time| {
            let state = self.step.expansion.at(time);
            [state.u.recip(), state.n.z / state.u]
        };
        Piece {
            times: times.map(|time| self.start + time),
            ends: times.map(end),
            emitters,
            passage,
        }
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
    fn chunk(&self, matter: &MatterThere, [from, to]: Span) -> Passage {
        let length = to - from;
        let places = self.nodes.places.iter();
        let samples: Vec<Passage> = places
            .map(|place| matter.sample(&self.emission(from + length * place)))
            .collect();
        let depth_by = |weights: &[f64]| {
            let terms = weights.iter().zip(&samples);
            length
                * terms
                    .map(|(weight, sample)| weight * sample.depth)
                    .sum::<f64>()
        };
        let mut passage = Passage {
            depth: depth_by(&self.nodes.weights),
            ..Passage::default()
        };
        let rows = self.nodes.partial.iter().zip(&self.nodes.weights);
        for ((partial, weight), sample) in rows.zip(&samples) {
            let share = (-depth_by(partial)).exp() * weight * length;
            passage.light += share * sample.light;
            passage.sums = passage.sums + share * sample.sums;
        }
        passage
    }

    /// The light of a span whose chunk is `whole`, halved until the halves agree with it.
    fn refined(
        &self,
        matter: &MatterThere,
        [from, to]: Span,
        whole: Passage,
        relative: f64,
        halvings: u32,
    ) -> Passage {
        let middle = 0.5 * (from + to);
        let [near, far] = [[from, middle], [middle, to]];
        let [first, second] = [near, far].map(|span| self.chunk(matter, span));
        let halves = first.followed_by(second);
        if halvings == 0 || whole.agrees(&halves, relative) {
            return halves;
        }
        let first = self.refined(matter, near, first, relative, halvings - 1);
        first.followed_by(self.refined(matter, far, second, relative, halvings - 1))
    }
}
