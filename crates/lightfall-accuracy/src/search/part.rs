//! The parts of an answer that a turn of the ray has to explain: its sky direction and its hits.

use super::chart::Chart;
use crate::answer::is_same_class;
use crate::reference_camera::ReferenceCamera;
use glam::{DVec2, DVec3};
use lightfall_model::geometry::sphere::{angle_between, wrap_angle};
use lightfall_optics::trace::{Hit, Trace};

/// The sky of an answer, or one of its hits.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// The direction that the ray comes from.
    Sky(DVec3),
    /// A crossing of the disk, with its index.
    Hit(usize, Hit),
}

impl Part {
    pub(super) fn all(given: &Trace) -> impl Iterator<Item = Self> {
        let hits = given
            .hits
            .into_iter()
            .enumerate()
            .filter_map(|(i, hit)| hit.map(|hit| Self::Hit(i, hit)));
        given.sky.map(Self::Sky).into_iter().chain(hits)
    }

    /// The difference of another answer from this part, in two components: of a direction, in the
    /// stereographic projection about it; of a hit, in 1/r (relative), which unlike r is smooth up
    /// to infinity, and in the azimuth. `None` if the other answer has no such part, or if the
    /// difference is not finite.
    pub(super) fn miss(&self, found: &Trace) -> Option<DVec2> {
        let miss = match self {
            Self::Sky(wanted) => found.sky.map(|found| {
                let (u, v) = wanted.any_orthonormal_pair();
                let toward = DVec2::new(found.dot(u), found.dot(v)).normalize_or(DVec2::X);
                2.0 * (0.5 * angle_between(found, *wanted)).tan() * toward
            }),
            Self::Hit(i, wanted) => {
                found.hits[*i].and_then(|found| Self::miss_of_hit(wanted, &found))
            }
        };
        miss.filter(|miss| miss.is_finite())
    }

    /// The difference of another hit from a wanted one. `None` if it is not finite.
    pub(super) fn miss_of_hit(wanted: &Hit, found: &Hit) -> Option<DVec2> {
        let azimuth = wrap_angle(found.phi - wanted.phi);
        Some(DVec2::new(1.0 - wanted.r / found.r, azimuth)).filter(|miss| miss.is_finite())
    }

    /// The difference in the sky's height over the disk's plane, or in the hit's 1/r. Next to a
    /// fast-spinning hole it changes much more slowly than the azimuth.
    pub(super) fn height(&self, found: &Trace) -> Option<f64> {
        match self {
            Self::Sky(wanted) => found.sky.map(|found| found.z - wanted.z),
            Self::Hit(..) => self.miss(found).map(|miss| miss.x),
        }
    }

    pub(super) fn azimuth(&self, found: &Trace) -> Option<f64> {
        match self {
            Self::Sky(wanted) => found
                .sky
                .map(|found| wrap_angle(found.y.atan2(found.x) - wanted.y.atan2(wanted.x))),
            Self::Hit(..) => self.miss(found).map(|miss| miss.y),
        }
    }
}

/// The bound of an answer's error by one ray: the largest of the turn to that ray, whose answer is
/// `found`, and of the misses of all parts. Infinite if the answers differ in class.
pub(super) fn bound_of_whole(given: &Trace, turn: f64, found: &Trace) -> f64 {
    if !is_same_class(given, found) {
        return f64::INFINITY;
    }
    let miss = |part: Part| part.miss(found).map_or(f64::INFINITY, DVec2::length);
    Part::all(given).map(miss).fold(turn, f64::max)
}

/// The miss of a part as a function of the place on a chart. `visit` is called with each direction
/// and its answer.
pub(super) fn miss_on_chart(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    visit: &dyn Fn(DVec3, &Trace),
) -> impl Fn(DVec2) -> Option<DVec2> {
    move |place| {
        let direction = chart.at(place);
        let trace = camera.trace(direction);
        visit(direction, &trace);
        part.miss(&trace)
    }
}
