//! The constants and the state of a freely falling particle.

use glam::DVec3;

/// A particle's constants of the motion, per unit rest mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleConstants {
    /// a, in r_s.
    pub a: f64,
    /// E = -u_t.
    pub energy: f64,
    /// L = u_phi, in r_s.
    pub angular_momentum: f64,
    /// K = Q + L^2, in r_s^2.
    pub k: f64,
}

/// Position, velocity and clocks of a particle. Derivatives are with respect to Mino time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParticleState {
    /// u = 1/r.
    pub u: f64,
    /// u'.
    pub du: f64,
    /// n, whose azimuth is psi.
    pub n: DVec3,
    /// n'.
    pub dn: DVec3,
    /// chi: Kerr's ingoing azimuth is psi + chi.
    pub chi: f64,
    /// Proper time, in r_s.
    pub proper_time: f64,
    /// Ingoing time v, in r_s.
    pub ingoing_time: f64,
}

impl ParticleConstants {
    /// K' = Q + (L - a E)^2.
    pub(super) fn k_prime(&self) -> f64 {
        let ae = self.a * self.energy;
        self.k + ae * (ae - 2.0 * self.angular_momentum)
    }

    /// B = a (a E - L).
    pub(super) fn b(&self) -> f64 {
        self.a * (self.a * self.energy - self.angular_momentum)
    }

    pub(super) fn kappa(&self) -> f64 {
        kappa(self.a, self.energy)
    }
}

pub(super) fn kappa(a: f64, energy: f64) -> f64 {
    a * a * (1.0 - energy) * (1.0 + energy)
}
