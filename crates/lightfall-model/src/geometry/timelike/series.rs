//! The motion of a freely falling particle as power series in Mino time.

use super::motion::{ParticleConstants, ParticleState};
use crate::geometry::taylor::{ORDER, Taylor, product_coefficient, reach_of_term};
use glam::DVec3;

/// The motion as power series in the Mino time after a state.
pub(super) struct ParticleSeries {
    pub(super) u: Taylor,
    n: [Taylor; 3],
    chi: Taylor,
    pub(super) proper_time: Taylor,
    ingoing_time: Taylor,
}

impl ParticleConstants {
    pub(super) fn expand(&self, start: &ParticleState) -> ParticleSeries {
        const ZERO: [f64; ORDER + 1] = [0.0; ORDER + 1];
        let ParticleState {
            u: u0,
            du,
            n: n0,
            dn,
            chi: chi0,
            proper_time,
            ingoing_time,
        } = *start;
        let (a, a2, energy) = (self.a, self.a * self.a, self.energy);
        let (k_prime, drag, kappa) = (self.k_prime(), self.b(), self.kappa());
        // The coefficients of U'/2, from u^0 to u^3.
        let half_slope = [
            0.5,
            2.0 * energy * drag - a2 - k_prime,
            1.5 * k_prime,
            2.0 * (drag * drag - a2 * k_prime),
        ];
        let infalling = du >= 0.0;
        let (mut u, mut n) = (ZERO, [ZERO; 3]);
        (u[0], u[1]) = (u0, du);
        for (axis, series) in n.iter_mut().enumerate() {
            (series[0], series[1]) = (n0[axis], dn[axis]);
        }
        // The series of u^2, of U'/2 without its constant divided by u, of r, r^2, n_z^2, of the
        // stiffness K - 2 kappa n_z^2, and of F and its denominator; then of tau, chi and v.
        let (mut u2, mut u_ratio, mut r, mut r2) = (ZERO, ZERO, ZERO, ZERO);
        let (mut n_z2, mut stiffness, mut f, mut denominator) = (ZERO, ZERO, ZERO, ZERO);
        let (mut tau, mut chi, mut v) = (ZERO, ZERO, ZERO);
        (tau[0], chi[0], v[0]) = (proper_time, chi0, ingoing_time);
        for (k, order) in (0..ORDER - 1).zip(0_u32..) {
            let one = f64::from(u8::from(k == 0));
            let (derivative, second_derivative) =
                (f64::from(order + 1), f64::from((order + 1) * (order + 2)));
            u2[k] = product_coefficient(&u, &u, k);
            u_ratio[k] = one * half_slope[1] + half_slope[2] * u[k] + half_slope[3] * u2[k];
            u[k + 2] =
                (one * half_slope[0] + product_coefficient(&u, &u_ratio, k)) / second_derivative;
            n_z2[k] = product_coefficient(&n[2], &n[2], k);
            stiffness[k] = one * self.k - 2.0 * kappa * n_z2[k];
            for axis in 0..3 {
                let axial_term = if axis == 2 { kappa * n[2][k] } else { 0.0 };
                n[axis][k + 2] = -(axial_term + product_coefficient(&stiffness, &n[axis], k))
                    / second_derivative;
            }
            // r[k] and f[k] are still zero in these products, which therefore contain only known
            // terms.
            r[k] = (one - product_coefficient(&u, &r, k)) / u0;
            r2[k] = product_coefficient(&r, &r, k);
            let (w, du) = (one * energy + drag * u2[k], derivative * u[k + 1]);
            let numerator = if infalling {
                denominator[k] = w + du;
                one + k_prime * u2[k]
            } else {
                denominator[k] = one - u[k] + a2 * u2[k];
                w - du
            };
            f[k] = (numerator - product_coefficient(&denominator, &f, k)) / denominator[0];
            tau[k + 1] = (r2[k] + a2 * n_z2[k]) / derivative;
            chi[k + 1] = a * (f[k] - one * energy) / derivative;
            let axial_rate =
                a * (one * (self.angular_momentum - a * energy) + a * energy * n_z2[k]);
            v[k + 1] = (product_coefficient(&r2, &f, k) + a2 * f[k] + axial_rate) / derivative;
        }
        let [chi, proper_time, ingoing_time] = [chi, tau, v].map(Taylor);
        ParticleSeries {
            u: Taylor(u),
            n: n.map(Taylor),
            chi,
            proper_time,
            ingoing_time,
        }
    }

    /// The length of a step in Mino time, over which the series is accurate.
    pub(super) fn reach(&self, expansion: &ParticleSeries) -> f64 {
        // At most one radian on the sphere.
        let mut reach = 1.0 / (self.k.abs() + self.kappa().abs()).sqrt();
        let ParticleSeries {
            u: Taylor(u),
            n,
            chi: Taylor(chi),
            proper_time: Taylor(tau),
            ingoing_time: Taylor(v),
        } = expansion;
        let n_term = |k: usize| DVec3::new(n[0].0[k], n[1].0[k], n[2].0[k]).length();
        // Two terms of each series, since one may vanish by symmetry. The series of chi and of the
        // clocks are one term shorter.
        for k in [ORDER - 1, ORDER] {
            reach = reach
                .min(reach_of_term(u[k], u[0], k))
                .min(reach_of_term(n_term(k), 1.0, k));
            // The clocks' error is relative to the time that passes in the step.
            reach = reach
                .min(reach_of_term(tau[k - 1], tau[1], k - 2))
                .min(reach_of_term(v[k - 1], v[1], k - 2));
            reach = reach.min(reach_of_term(chi[k - 1], 1.0, k - 1));
        }
        reach
    }
}

impl ParticleSeries {
    /// The state after the Mino time `t`.
    pub(super) fn at(&self, t: f64) -> ParticleState {
        let (u, du) = self.u.at(t);
        let [(x, dx), (y, dy), (z, dz)] = [self.n[0].at(t), self.n[1].at(t), self.n[2].at(t)];
        let [chi, proper_time, ingoing_time] =
            [&self.chi, &self.proper_time, &self.ingoing_time].map(|series| series.at(t).0);
        ParticleState {
            u,
            du,
            n: DVec3::new(x, y, z),
            dn: DVec3::new(dx, dy, dz),
            chi,
            proper_time,
            ingoing_time,
        }
    }
}
