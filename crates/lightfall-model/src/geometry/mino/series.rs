//! The motion of a null geodesic as power series in Mino time.

use super::motion::{PhotonConstants, PhotonState};
use crate::geometry::taylor::{ORDER, Taylor, product_coefficient, reach_of_term};
use glam::DVec3;

/// The motion as power series in the Mino time after a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotonSeries {
    /// u.
    pub u: Taylor,
    /// The components of n.
    pub n: [Taylor; 3],
    /// chi.
    pub chi: Taylor,
}

impl PhotonConstants {
    /// The power series of the motion from `start` on.
    pub fn expand(&self, start: &PhotonState) -> PhotonSeries {
        let [_, _, quadratic, cubic, quartic] = self.potential_coefficients();
        let (ae2, al) = (
            (self.a * self.energy).powi(2),
            self.a * self.angular_momentum,
        );
        let ae = self.a * self.energy;
        let k_prime = cubic;
        let (mut u, mut n, mut chi) = ([0.0; ORDER + 1], [[0.0; ORDER + 1]; 3], [0.0; ORDER + 1]);
        (u[0], u[1], chi[0]) = (start.u, start.du, start.chi);
        for (axis, series) in n.iter_mut().enumerate() {
            (series[0], series[1]) = (start.n[axis], start.dn[axis]);
        }
        // The series of u^2, of u''/u = U'(u)/(2u), of the stiffness K + 2 a^2 E^2 n_z^2, and of
        // the denominator and the value of chi'.
        let (mut u2, mut u_ratio, mut stiffness) =
            ([0.0; ORDER + 1], [0.0; ORDER + 1], [0.0; ORDER + 1]);
        let (mut denominator, mut dchi) = ([0.0; ORDER + 1], [0.0; ORDER + 1]);
        for (k, order) in (0..ORDER - 1).zip(0_u32..) {
            let one = f64::from(u8::from(k == 0));
            let second_derivative = f64::from((order + 1) * (order + 2));
            u2[k] = product_coefficient(&u, &u, k);
            u_ratio[k] = one * quadratic + 1.5 * cubic * u[k] + 2.0 * quartic * u2[k];
            u[k + 2] = product_coefficient(&u, &u_ratio, k) / second_derivative;
            stiffness[k] = one * self.k;
            if ae2 > 0.0 {
                stiffness[k] += 2.0 * ae2 * product_coefficient(&n[2], &n[2], k);
            }
            for axis in 0..3 {
                let axial_term = if axis == 2 { ae2 * n[2][k] } else { 0.0 };
                n[axis][k + 2] =
                    (axial_term - product_coefficient(&stiffness, &n[axis], k)) / second_derivative;
            }
            if self.a != 0.0 {
                let numerator = if self.ingoing {
                    let du = f64::from(order + 1) * u[k + 1];
                    denominator[k] = one * self.energy + (self.a * ae - al) * u2[k] - du;
                    ae * denominator[k] - self.a * k_prime * u2[k]
                } else {
                    denominator[k] = one - u[k] + self.a.powi(2) * u2[k];
                    self.a * al * u2[k] - ae * u[k]
                };
                // dchi[k] is still zero here, so the product contains only known terms.
                dchi[k] =
                    (numerator - product_coefficient(&denominator, &dchi, k)) / denominator[0];
                chi[k + 1] = dchi[k] / f64::from(order + 1);
            }
        }
        PhotonSeries {
            u: Taylor(u),
            n: n.map(Taylor),
            chi: Taylor(chi),
        }
    }

    /// The length of a step in Mino time, over which the series is accurate.
    ///
    /// The bound 1/sqrt(K + (1 + a^2) E^2) keeps a step below one radian. Since n_z'' = -q n_z with
    /// q <= K + a^2 E^2, Sturm's comparison theorem implies that n_z vanishes at most once in a
    /// step.
    pub fn reach(&self, expansion: &PhotonSeries) -> f64 {
        let mut reach = 1.0 / (self.k + (1.0 + self.a.powi(2)) * self.energy.powi(2)).sqrt();
        let PhotonSeries {
            u: Taylor(u),
            n,
            chi: Taylor(chi),
        } = expansion;
        // The squares of high terms would overflow where K is 1e16: for fast observers far away.
        let n_term = |k: usize| n[0].0[k].hypot(n[1].0[k]).hypot(n[2].0[k]);
        // Two terms of each series, since one may vanish by symmetry. The series of chi is one term
        // shorter.
        for k in [ORDER - 1, ORDER] {
            let u_reach = reach_of_term(u[k], u[0], k).max(reach_of_term(u[k], u[1], k - 1));
            let n_reach = reach_of_term(n_term(k), 1.0, k);
            let chi_reach = reach_of_term(chi[k - 1], 1.0, k - 1);
            reach = reach.min(u_reach).min(n_reach).min(chi_reach);
        }
        reach
    }
}

impl PhotonSeries {
    /// The state after the Mino time `t`.
    pub fn at(&self, t: f64) -> PhotonState {
        let (u, du) = self.u.at(t);
        let [(x, dx), (y, dy), (z, dz)] = [self.n[0].at(t), self.n[1].at(t), self.n[2].at(t)];
        PhotonState {
            u,
            du,
            n: DVec3::new(x, y, z),
            dn: DVec3::new(dx, dy, dz),
            chi: self.chi.at(t).0,
        }
    }
}
