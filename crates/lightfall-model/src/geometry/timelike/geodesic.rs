//! A freely falling particle, advanced by its proper time.

use super::motion::{ParticleConstants, ParticleState, kappa};
use crate::geometry::kerr::Kerr;
use crate::geometry::observer::Photon;
use crate::geometry::taylor::Taylor;
use glam::DVec3;

/// Maximum number of steps of one advance. A step covers about a radian, or half of the way to
/// infinity, so no flight needs as many.
const MAX_STEPS: u32 = 100_000;

/// Maximum number of steps to a turning point. Ten turns are more than any orbit takes but those next to
/// the innermost stable one and to unstable ones, which would take thousands.
const MAX_STEPS_TO_APSIS: u32 = 64;

/// A freely falling particle of unit mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geodesic {
    /// Its constants of the motion.
    pub constants: ParticleConstants,
    /// Its present position and velocity.
    pub state: ParticleState,
}

/// Why an advance ended early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The particle reached the smallest radius.
    Inner,
    /// The particle reached the largest radius.
    Outer,
    /// The series converges no farther. The particle stays at the last accurate place.
    Lost,
}

impl Geodesic {
    /// The particle with the four-velocity `velocity`, in the form of the first column of an
    /// observer's matrix, at radius `r` (r_s) and place `n` on the celestial sphere, with both
    /// clocks at zero. `chi` is its ingoing azimuth minus the azimuth of `n`.
    ///
    /// L = r (n x w)_z, K = r^2 |w|^2 + kappa n_z^2, n' = r w and u' = -(Sigma u^r)/r^2.
    pub fn new(kerr: Kerr, velocity: &Photon, r: f64, n: DVec3, chi: f64) -> Self {
        let (a, energy, w) = (kerr.a(), velocity.energy, r * velocity.w);
        let k = w.length_squared() + kappa(a, energy) * n.z * n.z;
        let (proper_time, ingoing_time) = (0.0, 0.0);
        let state = ParticleState {
            u: 1.0 / r,
            du: -velocity.radial,
            n,
            dn: w,
            chi,
            proper_time,
            ingoing_time,
        };
        Self {
            constants: ParticleConstants {
                a,
                energy,
                angular_momentum: n.x * w.y - n.y * w.x,
                k,
            },
            state,
        }
    }

    /// The four-velocity, in the form of the first column of an observer's matrix at the place n.
    pub fn velocity(&self) -> Photon {
        let ParticleState { u, du, dn, .. } = self.state;
        Photon {
            energy: self.constants.energy,
            radial: -du,
            w: u * dn,
        }
    }

    /// Advances the particle by `proper_time` (r_s, not negative). If it reaches one of the radii
    /// `[inner, outer]` (r_s) earlier, it stays there.
    pub fn advance(&mut self, proper_time: f64, [inner, outer]: [f64; 2]) -> Option<Limit> {
        let end_time = self.state.proper_time + proper_time;
        for _ in 0..MAX_STEPS {
            let ParticleState {
                u, du, proper_time, ..
            } = self.state;
            if u >= 1.0 / inner && du >= 0.0 {
                return Some(Limit::Inner);
            }
            if u <= 1.0 / outer && du <= 0.0 {
                return Some(Limit::Outer);
            }
            if proper_time >= end_time {
                return None;
            }
            let expansion = self.constants.expand(&self.state);
            let reach = self.constants.reach(&expansion);
            if !(reach > 0.0 && reach.is_finite()) {
                return Some(Limit::Lost);
            }
            let mut step = reach;
            if expansion.proper_time.at(step).0 >= end_time {
                step = minus_constant(expansion.proper_time, end_time).root(step);
            }
            for (radius, sign) in [(inner, 1.0), (outer, -1.0)] {
                if sign * (expansion.u.at(step).0 - 1.0 / radius) >= 0.0 && sign * du > 0.0 {
                    step = minus_constant(expansion.u, 1.0 / radius).root(step);
                }
            }
            let mut end = expansion.at(step);
            if !(step > 0.0
                && end.u.is_finite()
                && end.n.is_finite()
                && end.proper_time.is_finite())
            {
                return Some(Limit::Lost);
            }
            // Rounding is removed from these ends, which would need another step of zero length.
            for radius in [inner, outer] {
                if (end.u * radius - 1.0).abs() < 4.0 * f64::EPSILON {
                    end.u = 1.0 / radius;
                }
            }
            if (end.proper_time - end_time).abs() <= 4.0 * f64::EPSILON * end_time {
                end.proper_time = end_time;
            }
            end.n = end.n.normalize();
            self.state = end;
        }
        Some(Limit::Lost)
    }

    /// Advances the particle to its next turning point, where u' changes its sign. If it reaches one
    /// of the radii `[inner, outer]` (r_s) earlier, it stays near there. A turning point at the start
    /// does not count, and one more than about ten turns away counts as lost.
    pub fn advance_to_apsis(&mut self, [inner, outer]: [f64; 2]) -> Option<Limit> {
        for _ in 0..MAX_STEPS_TO_APSIS {
            let ParticleState { u, du, .. } = self.state;
            if u >= 1.0 / inner && du >= 0.0 {
                return Some(Limit::Inner);
            }
            if u <= 1.0 / outer && du <= 0.0 {
                return Some(Limit::Outer);
            }
            let expansion = self.constants.expand(&self.state);
            let reach = self.constants.reach(&expansion);
            if !(reach > 0.0 && reach.is_finite()) {
                return Some(Limit::Lost);
            }
            let turns = expansion.u.at(reach).1 * du < 0.0;
            let step = if turns {
                expansion.u.derivative().root(reach)
            } else {
                reach
            };
            let mut end = expansion.at(step);
            if !(end.u > 0.0 && end.u.is_finite() && end.n.is_finite()) {
                return Some(Limit::Lost);
            }
            end.n = end.n.normalize();
            self.state = end;
            if turns {
                self.state.du = 0.0;
                return None;
            }
        }
        Some(Limit::Lost)
    }
}

fn minus_constant(mut series: Taylor, constant: f64) -> Taylor {
    series.0[0] -= constant;
    series
}
