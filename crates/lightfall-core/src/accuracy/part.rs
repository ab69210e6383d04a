//! The parts of an answer that a turn of the ray has to explain: its sky direction and its hits.

use super::chart::Chart;
use super::reference_camera::ReferenceCamera;
use crate::geometry::sphere::wrap_angle;
use crate::optics::trace::{Hit, Trace};
use glam::{DVec2, DVec3};

/// The sky of an answer, or one of its hits.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// The direction that the ray comes from.
    Sky(DVec3),
    /// A crossing of the disk, with its index.
    Hit(usize, Hit),
}

impl Part {
    /// The parts of an answer.
    pub(super) fn all(given: &Trace) -> impl Iterator<Item = Self> {
        let hits = given
            .hits
            .into_iter()
            .enumerate()
            .filter_map(|(i, hit)| hit.map(|hit| Self::Hit(i, hit)));
        given.sky.map(Self::Sky).into_iter().chain(hits)
    }

    /// The difference of another answer from this part, in two components: of a direction, along
    /// two axes perpendicular to the wanted one; of a hit, relative in 1/r, which unlike r is
    /// smooth up to infinity, and in the azimuth.
    pub(super) fn miss(&self, found: &Trace) -> Option<DVec2> {
        match self {
            Self::Sky(wanted) => found.sky.map(|found| {
                let (u, v) = wanted.any_orthonormal_pair();
                let miss = found - wanted;
                DVec2::new(miss.dot(u), miss.dot(v))
            }),
            Self::Hit(..) => self
                .height(found)
                .zip(self.azimuth(found))
                .map(|(height, azimuth)| DVec2::new(height, azimuth)),
        }
    }

    /// The component of that difference that is not azimuth. Near a fast hole neighbouring rays
    /// differ much less in this component than in the azimuth.
    pub(super) fn height(&self, found: &Trace) -> Option<f64> {
        match self {
            Self::Sky(wanted) => found.sky.map(|found| found.z - wanted.z),
            Self::Hit(i, wanted) => found.hits[*i].map(|found| 1.0 - wanted.r / found.r),
        }
    }

    /// The difference in azimuth.
    pub(super) fn azimuth(&self, found: &Trace) -> Option<f64> {
        let difference = match self {
            Self::Sky(wanted) => found
                .sky
                .map(|found| found.y.atan2(found.x) - wanted.y.atan2(wanted.x)),
            Self::Hit(i, wanted) => found.hits[*i].map(|found| found.phi - wanted.phi),
        };
        difference.map(wrap_angle)
    }
}

/// The miss of a part as a function of the place on a chart. `visit` is called with the turn and
/// the answer at each place.
pub(super) fn miss_on_chart(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    visit: &dyn Fn(f64, &Trace),
) -> impl Fn(DVec2) -> Option<DVec2> {
    move |place| {
        let trace = camera.trace(chart.at(place));
        visit(chart.turn(place), &trace);
        part.miss(&trace)
    }
}
