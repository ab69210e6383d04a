//! How wrong the delay of a hit is, and how much of that belongs to the place of the hit.
//!
//! A tiny turn of a ray next to the critical curve moves its hit, and the delay with it: the delay
//! is then right for the place that the method has found, and differs from the reference's at
//! another place. How the delay depends on the place follows from Hamilton and Jacobi. The action
//! of light is zero along every ray, so it stays zero when the event of emission moves while the
//! event of arrival stays: p_t dt + p_r dr + p_theta dtheta + p_phi dphi = 0, where p is the
//! photon's momentum at the emission. Hits lie in the disk's plane, so dtheta = 0, and with p_t = -E
//! and p_phi = L the emission is later by (p_r dr + L dphi)/E. The delay grows by the opposite.
//!
//! Along a backward ray in Mino time u' = u^2 Delta p_r, so p_r = u' r^2/Delta.

use super::class::hits;
use crate::geometry::mino::Constants;
use crate::geometry::sphere::wrap_angle;
use crate::optics::reference::Reference;
use crate::optics::trace::{Hit, Trace};
use glam::DVec3;

/// Places that are farther apart than this share of the radius say nothing about the delay: the
/// part that the place explains is of first order, and 0.003^2 is 1e-5.
const SAME_PLACE: f64 = 0.003;

/// The reference's answer to a ray, with the delays of its hits and how they depend on the place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedRay {
    /// The answer. The delays are [lags](crate::optics::delay::Lag), which a camera inside the
    /// horizon has as well.
    pub trace: Trace,
    slopes: [Slope; 2],
}

/// The derivatives of a hit's delay with respect to its radius and its azimuth. Zero without
/// lensing, where nothing magnifies the error of a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Slope {
    r: f64,
    phi: f64,
}

/// The error of the delay of one hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DelayError {
    /// The hit as the method has it.
    pub found: Hit,
    /// The hit as the reference has it.
    pub truth: Hit,
    /// The method's delay less the reference's, in r_s/c.
    pub plain: f64,
    /// The method's delay less that of the place that it has found, in r_s/c. `None` if that place
    /// is too far from the reference's for a comparison of first order.
    pub at_place: Option<f64>,
}

impl TimedRay {
    /// Follows the ray that arrives from `direction`, given on the observer's axes.
    #[must_use]
    pub fn of(reference: &Reference, direction: DVec3) -> Self {
        let mut ray = Self {
            trace: reference.trace_with_lags(direction),
            slopes: [Slope::default(); 2],
        };
        // Most rays miss the disk, and need no second look.
        if reference.lensing() && hits(&ray.trace) > 0 {
            ray.slopes = slopes(reference, direction);
        }
        ray
    }

    /// The errors of a method's delays, hit by hit. `None` if outcome or number of hits differ, so
    /// that there is nothing to compare. Hits without a delay are left out.
    #[must_use]
    pub fn errors(&self, found: &Trace) -> Option<Vec<DelayError>> {
        let alike = found.outcome == self.trace.outcome && hits(found) == hits(&self.trace);
        let pairs = found.hits.into_iter().zip(self.trace.hits).zip(self.slopes);
        alike.then(|| {
            pairs
                .filter_map(|((found, truth), slope)| error(found?, truth?, slope))
                .collect()
        })
    }
}

impl DelayError {
    /// How far apart the two places are: in the radius, in r_s, and in the azimuth.
    #[must_use]
    pub fn moved(&self) -> [f64; 2] {
        moved(&self.found, &self.truth)
    }
}

fn moved(found: &Hit, truth: &Hit) -> [f64; 2] {
    [found.r - truth.r, wrap_angle(found.phi - truth.phi)]
}

fn error(found: Hit, truth: Hit, slope: Slope) -> Option<DelayError> {
    let plain = found.delay? - truth.delay?;
    let [dr, dphi] = moved(&found, &truth);
    let same_place = dr.hypot(truth.r * dphi) <= SAME_PLACE * truth.r;
    Some(DelayError {
        found,
        truth,
        plain,
        at_place: same_place.then(|| plain - (slope.r * dr + slope.phi * dphi)),
    })
}

fn slopes(reference: &Reference, direction: DVec3) -> [Slope; 2] {
    let hole = reference.hole_and_disk();
    let photon = reference.photon(direction.normalize());
    let (r, n) = reference.camera();
    let (constants, start) = Constants::of_photon(hole.kerr, &photon, r, n);
    let mut slopes = [Slope::default(); 2];
    let mut free = slopes.iter_mut();
    hole.follow(&constants, start, |step| {
        let Some(time) = step.hit else { return };
        let (u, du) = step.expansion.u.at(time);
        let r = 1.0 / u;
        if let Some(slope) = free.next() {
            *slope = Slope {
                r: -du * r * r / hole.kerr.delta(r) / constants.energy,
                phi: -constants.angular_momentum / constants.energy,
            };
        }
    });
    slopes
}
