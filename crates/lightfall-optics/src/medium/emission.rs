//! A place in matter, and what the matter there does to a ray.

use super::means::Means;
use super::spans::Span;
use crate::delay::Lag;
use crate::reference;
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries};

/// A place on the way of a ray. Where and when light left it cost more than the place itself.
pub struct Emission<'a> {
    pub(super) kerr: Kerr,
    pub(super) constants: &'a PhotonConstants,
    pub(super) lag: &'a Lag<'a>,
    pub(super) step: &'a reference::Step<'a>,
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

    /// Where light with this shift comes from.
    pub(super) fn place(&self, g: f64) -> Means {
        let r = self.series().u.at(self.time).0.recip();
        Means {
            r,
            height: r * self.series().n[2].at(self.time).0,
            g,
            delay: self.lag(),
        }
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

    /// What a place does to a ray, for each unit of Mino time.
    fn rates(&self, at: &Emission) -> Rates;
}

/// What matter does to a ray, for each unit of Mino time or, where it is a sheet, in all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rates {
    /// The light that it emits.
    pub light: DVec3,
    /// Its optical depth.
    pub depth: f64,
    /// Observed over emitted frequency of this light.
    pub g: f64,
}
