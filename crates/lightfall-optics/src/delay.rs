//! The travel time of the light of a hit, in f64. The twin in WGSL is shaders/delay/mino.wgsl.
//!
//! Along a backward ray in Mino time, dt/dtau = (1/u^2 + a^2) W/D + a L - a^2 E (1 - n_z^2) with
//! W = E + (a^2 E - a L) u^2 and D = 1 - u + a^2 u^2 (Carter 1968; Misner, Thorne & Wheeler 1973
//! eq. 33.32d). Its first term is infinite at infinity and at the horizon. Since W^2 - u'^2 = K'
//! u^2 D, it is K' (1 + a^2 u^2)/(W + |u'|) plus the change of the tortoise coordinate r* per Mino
//! time. So on every leg, on which r does not turn, the light takes
//!
//! |r*(end) - r*(start)| +
//! integral of [K' (1 + a^2 u^2)/(W + |u'|) + a L - a^2 E (1 - n_z^2)] dtau,
//!
//! where the integrand is finite everywhere. Derived.

use crate::reference::{HoleAndDisk, Step};
use crate::trace::Trace;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries, PhotonState};
use lightfall_model::geometry::quadrature::integral_on_scale;

/// The lag of the places along a backward ray, summed step by step: the camera's time less the
/// Boyer-Lindquist time at which the ray's light was at a place, in r_s/c. The camera's time is
/// Boyer-Lindquist's outside the horizon, where the lag is the delay. At and inside the horizon it
/// is Kerr's ingoing time, which is finite there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag<'a> {
    kerr: Kerr,
    constants: &'a PhotonConstants,
    /// r* at the start of the first leg, until the first step tells whether that leg leads outward.
    /// Zero inside the horizon, where the ingoing time contains it.
    start: f64,
    /// The sum over the steps so far, without r* at the end of the present leg.
    sum: f64,
}

impl HoleAndDisk {
    /// As [`trace`](Self::trace), with the hits' [lags](Lag) in place of their delays.
    pub fn trace_with_lags(&self, constants: &PhotonConstants, start: PhotonState) -> Trace {
        let mut lag = Lag::new(self.kerr, constants, &start);
        let (mut lags, mut found) = ([None; 2], 0);
        let mut trace = self.follow(constants, start, |step| {
            if let (Some(slot), Some(time)) = (lags.get_mut(found), step.hit) {
                *slot = Some(lag.at(step, time));
                found += 1;
            }
            if found < lags.len() {
                lag.add(step);
            }
        });
        for (hit, lag) in trace.hits.iter_mut().flatten().zip(lags) {
            hit.delay = lag;
        }
        trace
    }
}

impl<'a> Lag<'a> {
    /// Begins at the camera.
    pub fn new(kerr: Kerr, constants: &'a PhotonConstants, start: &PhotonState) -> Self {
        let outside = start.u < 1.0 / kerr.horizon();
        Self {
            kerr,
            constants,
            start: if outside {
                kerr.ingoing_time_lead(1.0 / start.u)
            } else {
                0.0
            },
            sum: 0.0,
        }
    }

    /// Adds the ray's next step.
    pub fn add(&mut self, step: &Step) {
        (self.sum, _) = self.until(step, step.length);
        self.start = 0.0;
    }

    /// The lag after the Mino time `time` of the ray's next step.
    pub fn at(&self, step: &Step, time: f64) -> f64 {
        let (sum, outward) = self.until(step, time);
        sum + outward * self.tortoise(step.expansion, time)
    }

    /// The sum up to a place in the next step, and the direction of the leg there: 1 outward, -1
    /// inward.
    fn until(&self, step: &Step, time: f64) -> (f64, f64) {
        let Step {
            expansion, length, ..
        } = *step;
        // At a turning point u'' decides.
        let [_, du, bend, ..] = expansion.u.0;
        let inward = if du == 0.0 { bend } else { du };
        let outward = -inward.signum();
        let sum = self.sum - outward * self.start;
        let turns = outward * expansion.u.at(length).1 > 0.0;
        let turn = (turns && du != 0.0).then(|| expansion.u.derivative().root(length));
        match turn.filter(|turn| *turn < time) {
            Some(turn) => {
                let first = self.integral(expansion, outward, [0.0, turn]);
                let second = self.integral(expansion, -outward, [turn, time]);
                let ends = 2.0 * outward * self.tortoise(expansion, turn);
                (sum + first + ends + second, -outward)
            }
            None => (
                sum + self.integral(expansion, outward, [0.0, time]),
                outward,
            ),
        }
    }

    fn tortoise(&self, expansion: &PhotonSeries, time: f64) -> f64 {
        self.kerr.ingoing_time_lead(1.0 / expansion.u.at(time).0)
    }

    /// The integral over a part of a leg, to 1e-12 r_s/c or a relative 1e-12: it vanishes along the
    /// principal null directions.
    fn integral(&self, expansion: &PhotonSeries, outward: f64, [from, to]: [f64; 2]) -> f64 {
        let PhotonConstants {
            a,
            energy,
            angular_momentum,
            ..
        } = *self.constants;
        let k_prime = self.constants.k_prime();
        let rate = |t: f64| {
            let ((u, du), (n_z, _)) = (expansion.u.at(t), expansion.n[2].at(t));
            let w = self.constants.ingoing_energy(u);
            k_prime * (1.0 + (a * u).powi(2)) / (w - outward * du) + a * angular_momentum
                - a * a * energy * (1.0 - n_z * n_z)
        };
        integral_on_scale(1.0, from, to, &rate)
    }
}
