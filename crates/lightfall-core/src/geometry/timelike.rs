//! One timelike geodesic of Kerr in Mino time, on the celestial sphere.
//!
//! As for light (`mino.rs`), but for unit rest mass and followed forward. With Mino time lambda
//! (dtau = Sigma dlambda), u = 1/r, n the place on the celestial sphere without the dragged part of
//! the azimuth, E, L and Carter's Q per unit mass, 2 M = 1, K = Q + L^2, K' = Q + (L - a E)^2, B =
//! a (a E - L), kappa = a^2 (1 - E^2):
//!
//! * u'^2 = U(u) = W^2 - D (1 + K' u^2), W = E + B u^2, D = 1 - u + a^2 u^2, and u'' = U'(u)/2;
//! * n'' = -kappa n_z e_z - (K - 2 kappa n_z^2) n, with |n'|^2 = K - kappa n_z^2 and (n x n')_z =
//!   L;
//! * tau' = r^2 + a^2 n_z^2;
//! * Kerr's ingoing azimuth grows by L/sin^2(theta), which n has, and by a (F - E);
//! * the ingoing (advanced) time by v' = (r^2 + a^2) F + a (L - a E sin^2(theta)),
//!
//! where F = (W - u')/D, which for what falls inward is (1 + K' u^2)/(W + u'): regular at the
//! horizon. Derived from Carter's separated equations (1968; Bardeen, Press & Teukolsky 1972 eqs.
//! 2.9-2.10; Misner, Thorne & Wheeler 1973 box 33.2 for the ingoing coordinates). The method is
//! that of the light: Taylor series of high order, whose roots are the events.

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::Photon;
use crate::geometry::taylor::{ORDER, Taylor, product_coefficient};
use glam::DVec3;

/// Largest term left out of a series, relative to what it adds to; well below rounding.
const TRUNCATION: f64 = 1e-18;
/// More steps than any interval of a flight needs. A step covers about a radian, or half of the way
/// to infinity.
const MAX_STEPS: u32 = 100_000;

/// A freely falling particle of unit mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geodesic {
    a: f64,
    /// E = -u_t.
    pub energy: f64,
    /// L = u_phi, in r_s.
    pub angular_momentum: f64,
    /// K = Q + L^2, in r_s^2.
    pub k: f64,
    /// Where it is.
    pub state: State,
}

/// Where a particle is, and how it goes on; derivatives are with respect to Mino time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// u = 1/r.
    pub u: f64,
    /// u'.
    pub du: f64,
    /// n, of azimuth psi.
    pub n: DVec3,
    /// n'.
    pub dn: DVec3,
    /// Kerr's ingoing azimuth is psi + chi.
    pub chi: f64,
    /// Proper time, in r_s.
    pub own_time: f64,
    /// Ingoing time v, in r_s.
    pub ingoing_time: f64,
}

/// Why an advance ended before its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// At the least radius it was given.
    Inner,
    /// At the largest.
    Outer,
    /// The series gave out; the particle stays at the last sure place.
    Lost,
}

struct Expansion {
    u: Taylor,
    n: [Taylor; 3],
    chi: Taylor,
    own_time: Taylor,
    ingoing_time: Taylor,
}

impl Geodesic {
    /// The particle with the four-velocity `velocity` (as an observer's matrix has it in its first
    /// column) at radius `r` and place `n` on the celestial sphere, with clocks at zero; `chi` is
    /// the part of its ingoing azimuth that `n` has not.
    ///
    /// L = r (n x w)_z, K = r^2 |w|^2 + kappa n_z^2; n' = r w and u' = -(Sigma u^r)/r^2.
    #[must_use]
    pub fn new(kerr: Kerr, velocity: &Photon, r: f64, n: DVec3, chi: f64) -> Self {
        let (a, energy, w) = (kerr.a(), velocity.energy, r * velocity.w);
        let k = w.length_squared() + oblateness(a, energy) * n.z * n.z;
        let (own_time, ingoing_time) = (0.0, 0.0);
        let state = State {
            u: 1.0 / r,
            du: -velocity.radial,
            n,
            dn: w,
            chi,
            own_time,
            ingoing_time,
        };
        Self {
            a,
            energy,
            angular_momentum: n.x * w.y - n.y * w.x,
            k,
            state,
        }
    }

    /// The four-velocity, as an observer's matrix has it in its first column, with n for the place.
    #[must_use]
    pub fn velocity(&self) -> Photon {
        let State { u, du, dn, .. } = self.state;
        Photon {
            energy: self.energy,
            radial: -du,
            w: u * dn,
        }
    }

    /// Lets the proper time `own_time` (r_s, not negative) pass, unless the particle meets one of
    /// the radii `[inner, outer]` (r_s) before: then it stays there.
    pub fn advance(&mut self, own_time: f64, [inner, outer]: [f64; 2]) -> Option<Limit> {
        let end_of_time = self.state.own_time + own_time;
        for _ in 0..MAX_STEPS {
            let State {
                u, du, own_time, ..
            } = self.state;
            if u >= 1.0 / inner && du >= 0.0 {
                return Some(Limit::Inner);
            }
            if u <= 1.0 / outer && du <= 0.0 {
                return Some(Limit::Outer);
            }
            if own_time >= end_of_time {
                return None;
            }
            let expansion = self.expand();
            let reach = self.reach(&expansion);
            if !(reach > 0.0 && reach.is_finite()) {
                return Some(Limit::Lost);
            }
            let mut step = reach;
            if expansion.own_time.at(step).0 >= end_of_time {
                step = lowered(expansion.own_time, end_of_time).root(step);
            }
            for (radius, sign) in [(inner, 1.0), (outer, -1.0)] {
                if sign * (expansion.u.at(step).0 - 1.0 / radius) >= 0.0 && sign * du > 0.0 {
                    step = lowered(expansion.u, 1.0 / radius).root(step);
                }
            }
            let mut end = expansion.at(step);
            if !(step > 0.0 && end.u.is_finite() && end.n.is_finite() && end.own_time.is_finite()) {
                return Some(Limit::Lost);
            }
            // What rounding left of these ends would otherwise ask for one more step, of no length.
            for radius in [inner, outer] {
                if (end.u * radius - 1.0).abs() < 4.0 * f64::EPSILON {
                    end.u = 1.0 / radius;
                }
            }
            if (end.own_time - end_of_time).abs() <= 4.0 * f64::EPSILON * end_of_time {
                end.own_time = end_of_time;
            }
            end.n = end.n.normalize();
            self.state = end;
        }
        Some(Limit::Lost)
    }

    /// The largest relative violation of the constraints on u'^2, |n'|^2 and (n x n')_z.
    #[must_use]
    pub fn residual(&self) -> f64 {
        let State { u, du, n, dn, .. } = self.state;
        let k_prime = self.k_prime();
        let (w, d) = (
            self.energy + self.drag() * u * u,
            1.0 - u + (self.a * u).powi(2),
        );
        let rest = d * (1.0 + k_prime * u * u);
        let radial = (du * du - w * w + rest).abs() / (w * w + rest.abs());
        let kappa = oblateness(self.a, self.energy);
        let scale = self.k.abs() + kappa.abs();
        if scale == 0.0 {
            return radial;
        }
        let angular = (dn.length_squared() - self.k + kappa * n.z * n.z).abs() / scale;
        let axial = (n.x * dn.y - n.y * dn.x - self.angular_momentum).abs() / scale.sqrt();
        radial.max(angular).max(axial)
    }

    /// K' = Q + (L - a E)^2.
    fn k_prime(&self) -> f64 {
        let ae = self.a * self.energy;
        self.k + ae * (ae - 2.0 * self.angular_momentum)
    }

    /// B = a (a E - L).
    fn drag(&self) -> f64 {
        self.a * (self.a * self.energy - self.angular_momentum)
    }

    fn expand(&self) -> Expansion {
        const NONE: [f64; ORDER + 1] = [0.0; ORDER + 1];
        let State {
            u: u0,
            du,
            n: n0,
            dn,
            chi,
            own_time,
            ingoing_time,
        } = self.state;
        let (a, a2, energy) = (self.a, self.a * self.a, self.energy);
        let (k_prime, drag, kappa) = (self.k_prime(), self.drag(), oblateness(a, energy));
        // U'/2 over the powers of u.
        let pull_of = [
            0.5,
            2.0 * energy * drag - a2 - k_prime,
            1.5 * k_prime,
            2.0 * (drag * drag - a2 * k_prime),
        ];
        let falling = du >= 0.0;
        let (mut u, mut n) = (NONE, [NONE; 3]);
        (u[0], u[1]) = (u0, du);
        for (axis, series) in n.iter_mut().enumerate() {
            (series[0], series[1]) = (n0[axis], dn[axis]);
        }
        // u^2, U'/2 less its constant over u, r, r^2, n_z^2, K - 2 kappa n_z^2, F and its
        // denominator; tau, chi, v.
        let (mut square, mut pull, mut r, mut r2) = (NONE, NONE, NONE, NONE);
        let (mut height2, mut stiffness, mut f, mut denominator) = (NONE, NONE, NONE, NONE);
        let (mut tau, mut turn, mut v) = (NONE, NONE, NONE);
        (tau[0], turn[0], v[0]) = (own_time, chi, ingoing_time);
        for (k, order) in (0..ORDER - 1).zip(0_u32..) {
            let one = f64::from(u8::from(k == 0));
            let (next, both) = (f64::from(order + 1), f64::from((order + 1) * (order + 2)));
            square[k] = product_coefficient(&u, &u, k);
            pull[k] = one * pull_of[1] + pull_of[2] * u[k] + pull_of[3] * square[k];
            u[k + 2] = (one * pull_of[0] + product_coefficient(&u, &pull, k)) / both;
            height2[k] = product_coefficient(&n[2], &n[2], k);
            stiffness[k] = one * self.k - 2.0 * kappa * height2[k];
            for axis in 0..3 {
                let along_axis = if axis == 2 { kappa * n[2][k] } else { 0.0 };
                n[axis][k + 2] =
                    -(along_axis + product_coefficient(&stiffness, &n[axis], k)) / both;
            }
            // r[k] and f[k] are still zero in these products, which so hold only the terms already
            // known.
            r[k] = (one - product_coefficient(&u, &r, k)) / u0;
            r2[k] = product_coefficient(&r, &r, k);
            let (w, growth) = (one * energy + drag * square[k], next * u[k + 1]);
            let numerator = if falling {
                denominator[k] = w + growth;
                one + k_prime * square[k]
            } else {
                denominator[k] = one - u[k] + a2 * square[k];
                w - growth
            };
            f[k] = (numerator - product_coefficient(&denominator, &f, k)) / denominator[0];
            tau[k + 1] = (r2[k] + a2 * height2[k]) / next;
            turn[k + 1] = a * (f[k] - one * energy) / next;
            let swirl = a * (one * (self.angular_momentum - a * energy) + a * energy * height2[k]);
            v[k + 1] = (product_coefficient(&r2, &f, k) + a2 * f[k] + swirl) / next;
        }
        let [chi, own_time, ingoing_time] = [turn, tau, v].map(Taylor);
        Expansion {
            u: Taylor(u),
            n: n.map(Taylor),
            chi,
            own_time,
            ingoing_time,
        }
    }

    /// How far in Mino time an expansion may be trusted.
    fn reach(&self, expansion: &Expansion) -> f64 {
        // A radian on the sphere.
        let mut reach = 1.0 / (self.k.abs() + oblateness(self.a, self.energy).abs()).sqrt();
        let Expansion {
            u: Taylor(u),
            n,
            chi: Taylor(chi),
            own_time: Taylor(tau),
            ingoing_time: Taylor(v),
        } = expansion;
        let n_term = |k: usize| DVec3::new(n[0].0[k], n[1].0[k], n[2].0[k]).length();
        // The t at which |c| t^power is small against `whole`.
        let share = |c: f64, whole: f64, power: usize| {
            if c == 0.0 {
                f64::INFINITY
            } else {
                (TRUNCATION * whole.abs() / c.abs()).powf(1.0 / power as f64)
            }
        };
        // Two terms of each, for one may vanish by symmetry. The quadratures' series are one term
        // shorter.
        for k in [ORDER - 1, ORDER] {
            reach = reach
                .min(share(u[k], u[0], k))
                .min(share(n_term(k), 1.0, k));
            // Clocks are right relative to what passes in the step.
            reach = reach
                .min(share(tau[k - 1], tau[1], k - 2))
                .min(share(v[k - 1], v[1], k - 2));
            reach = reach.min(share(chi[k - 1], 1.0, k - 1));
        }
        reach
    }
}

/// kappa = a^2 (1 - E^2).
fn oblateness(a: f64, energy: f64) -> f64 {
    a * a * (1.0 - energy) * (1.0 + energy)
}

/// The series less a constant.
fn lowered(mut series: Taylor, by: f64) -> Taylor {
    series.0[0] -= by;
    series
}

impl Expansion {
    fn at(&self, t: f64) -> State {
        let (u, du) = self.u.at(t);
        let [(x, dx), (y, dy), (z, dz)] = [self.n[0].at(t), self.n[1].at(t), self.n[2].at(t)];
        let [chi, own_time, ingoing_time] =
            [&self.chi, &self.own_time, &self.ingoing_time].map(|series| series.at(t).0);
        State {
            u,
            du,
            n: DVec3::new(x, y, z),
            dn: DVec3::new(dx, dy, dz),
            chi,
            own_time,
            ingoing_time,
        }
    }
}
