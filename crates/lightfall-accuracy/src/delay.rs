//! The error of a hit's delay, and the part of it that follows from the error of the hit's place.
//!
//! A tiny turn of a ray next to the critical curve moves its hit and changes the delay: the delay
//! may be right for the place that the method has found, and yet differ from the reference's at
//! another place. The dependence follows from Hamilton and Jacobi. The action of light is zero
//! along every ray, so it stays zero when the event of emission moves while the event of arrival
//! stays: p_t dt + p_r dr + p_theta dtheta + p_phi dphi = 0, where p is the photon's momentum at
//! the emission. Hits lie in the disk's plane, so dtheta = 0, and with p_t = -E and p_phi = L the
//! emission is later by (p_r dr + L dphi)/E. The delay shrinks by this.
//!
//! Along a backward ray in Mino time u' = u^2 Delta p_r, so p_r = u' r^2/Delta.
//!
//! A ray's own error moves its hit far only next to the critical curve, where the rays between the
//! two places have almost the same constants of motion. Their u'^2 = U(u) is that of the
//! reference's ray, and the delay grows by -(integral of p_r dr + L dphi)/E. These rays may wind
//! round the hole between the places, so dphi is known up to whole turns; the number that leaves
//! the smallest error is taken. Where r turns between the two places this fails, and an error
//! remains.

use super::answer::{hits, is_same_class};
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::quadrature::integral_on_scale;
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::{Hit, Trace};
use std::f64::consts::TAU;

/// Places closer together than this share of the radius count as the same: the errors of the
/// constants and of the turning points are of second order, and 0.003^2 is 1e-5.
const SAME_PLACE: f64 = 0.003;

/// The relative uncertainty of a hit's radius in f32: eight units in the last place.
const LAST_DIGITS: f64 = 1e-6;

/// Whole turns are counted only if one changes the delay by at least this much, in r_s/c: a hundred
/// times the errors that matter, so that a wrong delay rarely matches by chance.
const LEAST_TURN: f64 = 1.0;

/// The reference's answer to a ray, with the delays of its hits and their dependence on the place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedRay {
    /// The answer. The delays are [lags](lightfall_optics::delay::Lag), which a camera inside the
    /// horizon has as well.
    pub trace: Trace,
    /// `None` without lensing, where nothing magnifies the error of a ray, and without hits.
    motion: Option<Motion>,
}

/// The numbers that give the dependence of the delay on the place.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Motion {
    kerr: Kerr,
    constants: PhotonConstants,
    /// The sign of u' at each hit.
    inward: [f64; 2],
}

/// The error of the delay of one hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DelayError {
    /// The method's hit.
    pub found: Hit,
    /// The reference's hit.
    pub truth: Hit,
    /// The method's delay less the reference's, in r_s/c.
    pub plain: f64,
    /// The method's delay less the right delay of the method's place, in r_s/c.
    pub at_place: f64,
}

impl TimedRay {
    /// Follows the ray that arrives from `direction`, given on the observer's axes.
    pub fn of(reference: &Reference, direction: DVec3) -> Self {
        let trace = reference.trace_with_lags(direction);
        let motion = (reference.lensing() && hits(&trace) > 0)
            .then(|| Motion::of(reference, direction.normalize()));
        Self { trace, motion }
    }

    /// The errors of a method's delays, hit by hit. `None` if outcome or number of hits differ.
    /// Hits without a delay are left out.
    pub fn errors(&self, found: &Trace) -> Option<Vec<DelayError>> {
        let error = |i: usize| self.error(i, found.hits[i]?, self.trace.hits[i]?);
        is_same_class(found, &self.trace).then(|| (0..found.hits.len()).filter_map(error).collect())
    }

    fn error(&self, hit: usize, found: Hit, truth: Hit) -> Option<DelayError> {
        let plain = found.delay? - truth.delay?;
        let mut error = DelayError {
            found,
            truth,
            plain,
            at_place: plain,
        };
        if let Some(motion) = self.motion {
            error.at_place -= motion.change(hit, error.moved(), truth.r);
            let turn = motion.change_in_turn();
            if !error.same_place() && turn.abs() > LEAST_TURN {
                error.at_place -= turn * (error.at_place / turn).round();
            }
        }
        Some(error)
    }
}

impl DelayError {
    /// The difference of the two places: in the radius, in r_s, and in the azimuth.
    pub fn moved(&self) -> [f64; 2] {
        [
            self.found.r - self.truth.r,
            wrap_angle(self.found.phi - self.truth.phi),
        ]
    }

    /// The time, in r_s/c, that light takes along the radius across the place's uncertainty in f32:
    /// the error of the radius, but at most a millionth of the radius. Next to the horizon of a
    /// nearly extremal hole this time is thousands of times the distance.
    pub fn light_time_of_rounding(&self, kerr: Kerr) -> f64 {
        let r = self.truth.r;
        let rounding = self.moved()[0].abs().min(LAST_DIGITS * r);
        rounding * (r * r + kerr.a() * kerr.a()) / kerr.delta(r)
    }

    /// Whether both places are the same, to 0.003 of the radius.
    pub fn same_place(&self) -> bool {
        let [dr, dphi] = self.moved();
        dr.hypot(self.truth.r * dphi) <= SAME_PLACE * self.truth.r
    }
}

impl Motion {
    fn of(reference: &Reference, direction: DVec3) -> Self {
        let hole = reference.hole_and_disk();
        let photon = reference.photon(direction);
        let (r, n) = reference.camera();
        let (constants, start) = PhotonConstants::of_photon(hole.kerr, &photon, r, n);
        let (mut inward, mut found) = ([0.0; 2], 0);
        hole.follow(&constants, start, |step| {
            if let (Some(slot), Some(time)) = (inward.get_mut(found), step.hit) {
                *slot = step.expansion.u.at(time).1.signum();
                found += 1;
            }
        });
        Self {
            kerr: hole.kerr,
            constants,
            inward,
        }
    }

    /// The growth of the delay of hit number `hit` when it moves from radius `r` by (dr, dphi).
    fn change(&self, hit: usize, [dr, dphi]: [f64; 2], r: f64) -> f64 {
        let p_r = |r: f64| {
            let du = self.constants.potential(1.0 / r).max(0.0).sqrt();
            self.inward[hit] * du * r * r / self.kerr.delta(r)
        };
        let by_azimuth = self.change_in_turn() * dphi / TAU;
        by_azimuth - integral_on_scale(1.0, r, r + dr, &p_r) / self.constants.energy
    }

    /// The growth of the delay when the hit moves by a whole turn.
    fn change_in_turn(&self) -> f64 {
        -TAU * self.constants.angular_momentum / self.constants.energy
    }
}
