//! Null geodesics of Kerr in Mino time, on the celestial sphere.
//!
//! With Mino time tau (Mino 2003: dtau = d(affine)/Sigma) the radial and angular motions separate,
//! and in u = 1/r and the unit vector n = (sin theta cos psi, sin theta sin psi, cos theta) their
//! equations are polynomial: no pole, no horizon and no infinity is a special place. With K = Q +
//! L^2 and K' = Q + (L - a E)^2 = K - 2 a E L + a^2 E^2, tau growing along the *backward* ray, and
//! 2 M = 1:
//!
//! * u'^2 = U(u) = E^2 + (a^2 E^2 - K) u^2 + K' u^3 - a^2 Q u^4, and u'' = U'(u)/2;
//! * n'' = a^2 E^2 n_z e_z - (K + 2 a^2 E^2 n_z^2) n, with |n'|^2 = K + a^2 E^2 n_z^2 and (n x
//!   n')_z = -L;
//! * phi = psi + chi, with chi' = -a u (E - a L u) / (1 - u + a^2 u^2).
//!
//! Derived from Carter's separated equations (1968; Bardeen, Press & Teukolsky 1972 eqs. 2.9-2.10)
//! by u = 1/r and by writing theta's and L/sin^2(theta)'s part of phi's equation as one vector:
//! Neumann's problem on the sphere. The constants are not divided by E, which may vanish or be
//! negative in the ergosphere.
//!
//! A camera at or inside the horizon has no Boyer-Lindquist azimuth. It uses Kerr's ingoing one,
//! phi + integral of a dr / Delta, for which chi' = a E - a K' u^2 / (E + (a^2 E - a L) u^2 - u'):
//! regular for light that falls in, and the same at infinity. So does light that leaves from a
//! hair's breadth outside, where the pole of Boyer-Lindquist's chi' would leave a series nothing to
//! go by.
//!
//! The method is a Taylor series of high order about every step's start, by recurrences on these
//! right-hand sides: the equations are so short that a step costs little, the steps are long (about
//! one radian), the series itself is the dense output on which events are found to full precision,
//! and there is no error estimate to tune. (DOP853's dense output is of seventh order, below that
//! of its steps.)

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::Photon;
use crate::geometry::sphere::{celestial_frame, polar_sin_cos};
use crate::geometry::taylor::{ORDER, Taylor, product_coefficient};
use glam::DVec3;

/// Largest term left out of a series, relative to what it adds to; well below rounding.
const TRUNCATION: f64 = 1e-18;

/// Outgoing rays that start within this share of the horizon's radius from it have the ingoing
/// azimuth.
const HAIR: f64 = 1e-9;

/// A ray's constants of motion, per unit frequency for the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// a, in r_s.
    pub a: f64,
    /// E = -p_t.
    pub energy: f64,
    /// L = p_phi, in r_s.
    pub angular_momentum: f64,
    /// K = Q + L^2, in r_s^2.
    pub k: f64,
    /// Whether azimuths are Kerr's ingoing ones rather than Boyer-Lindquist's.
    pub ingoing: bool,
}

/// Where a backward ray is, and how it goes on; derivatives are with respect to Mino time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// u = 1/r.
    pub u: f64,
    /// u'.
    pub du: f64,
    /// n; its azimuth is psi.
    pub n: DVec3,
    /// n'.
    pub dn: DVec3,
    /// The azimuth is psi + chi.
    pub chi: f64,
}

/// The motion as power series in the Mino time since the state that it was made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expansion {
    /// u.
    pub u: Taylor,
    /// The components of n.
    pub n: [Taylor; 3],
    /// chi.
    pub chi: Taylor,
}

impl Constants {
    /// The constants and the backward start of the photon that meets a camera at radius `r` (r_s)
    /// in the direction `n`.
    ///
    /// L = r (n x w)_z, K = r^2 |w|^2 - a^2 E^2 n_z^2; going backward n' = -r w and u' = -(1/r)' =
    /// Sigma p^r / r^2.
    #[must_use]
    pub fn of_photon(kerr: Kerr, photon: &Photon, r: f64, n: DVec3) -> (Self, State) {
        let (a, energy) = (kerr.a(), photon.energy);
        let w = r * photon.w;
        let (inside, close) = (r <= kerr.horizon(), r <= kerr.horizon() * (1.0 + HAIR));
        let ingoing = inside || close && photon.radial < 0.0;
        let constants = Self {
            a,
            energy,
            angular_momentum: n.x * w.y - n.y * w.x,
            k: w.length_squared() - (a * energy * n.z).powi(2),
            ingoing,
        };
        // Outside, the camera's own azimuth is Boyer-Lindquist's.
        let chi = if ingoing && !inside {
            kerr.ingoing_azimuth_lead(r)
        } else {
            0.0
        };
        (
            constants,
            State {
                u: 1.0 / r,
                du: photon.radial,
                n,
                dn: -w,
                chi,
            },
        )
    }

    /// The constants and the backward start of the photon with E = 1 and Bardeen's screen
    /// coordinates alpha, beta (r_s; growing phi to the right, decreasing theta up) at u = 1/r and
    /// (`theta`, `phi`); infinity is u = 0. It starts toward the hole if `inward`. Outside the
    /// horizon only. Where U(u) is negative there is no such photon; u' is then zero.
    ///
    /// p_phi / sin(theta) = -alpha and p_theta = beta, so lambda = -alpha sin(theta) and
    /// eta = (alpha^2 - a^2) cos^2(theta) + beta^2 (Bardeen 1973). Giving alpha and beta,
    /// not lambda and eta, leaves no square root of a difference in theta's velocity.
    #[must_use]
    pub fn of_screen(
        kerr: Kerr,
        [alpha, beta]: [f64; 2],
        u: f64,
        [theta, phi]: [f64; 2],
        inward: bool,
    ) -> (Self, State) {
        let [n, theta_hat, phi_hat] = celestial_frame(theta, phi);
        let (a, sin) = (kerr.a(), polar_sin_cos(theta).0);
        let k = alpha * alpha + beta * beta - (a * n.z).powi(2);
        let constants = Self {
            a,
            energy: 1.0,
            angular_momentum: -alpha * sin,
            k,
            ingoing: false,
        };
        let speed = constants.potential(u).max(0.0).sqrt();
        let du = if inward { speed } else { -speed };
        (
            constants,
            State {
                u,
                du,
                n,
                dn: alpha * phi_hat - beta * theta_hat,
                chi: 0.0,
            },
        )
    }

    /// Carter's Q = K - L^2, in r_s^2.
    #[must_use]
    pub fn carter_q(&self) -> f64 {
        self.k - self.angular_momentum.powi(2)
    }

    /// U's coefficients, from u^0 to u^4.
    #[must_use]
    pub fn potential_coefficients(&self) -> [f64; 5] {
        let ae = self.a * self.energy;
        let k_prime = self.k + ae * (ae - 2.0 * self.angular_momentum);
        [
            self.energy.powi(2),
            0.0,
            ae * ae - self.k,
            k_prime,
            -self.a.powi(2) * self.carter_q(),
        ]
    }

    /// U(u) = u'^2.
    #[must_use]
    pub fn potential(&self, u: f64) -> f64 {
        self.potential_coefficients()
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * u + c)
    }

    /// Whether U is positive throughout `[from, to]`, so that no ray turns there. May answer no
    /// where it is yes, never the other way: a polynomial lies above the least of its Bernstein
    /// coefficients (Farouki & Rajan 1987).
    #[must_use]
    pub fn cannot_turn_within(&self, from: f64, to: f64) -> bool {
        let mut c = self.potential_coefficients();
        // Expand about `from`, in units of the interval: Horner's shift, then powers of the width.
        for low in 0..4 {
            for i in (low..4).rev() {
                c[i] += c[i + 1] * from;
            }
        }
        let width = to - from;
        let [c0, c1, c2, c3, c4] = [
            c[0],
            c[1] * width,
            c[2] * width.powi(2),
            c[3] * width.powi(3),
            c[4] * width.powi(4),
        ];
        [
            c0,
            c0 + c1 / 4.0,
            c0 + c1 / 2.0 + c2 / 6.0,
            c0 + 0.75 * c1 + c2 / 2.0 + c3 / 4.0,
            c0 + c1 + c2 + c3 + c4,
        ]
        .into_iter()
        .all(|b| b > 0.0)
    }

    /// E (r^2 + a^2) - a L over r^2 at u = 1/r. It is positive at the outer horizon for every
    /// photon that crosses it inward from the outside.
    #[must_use]
    pub fn ingoing_energy(&self, u: f64) -> f64 {
        self.energy + self.a * (self.a * self.energy - self.angular_momentum) * u * u
    }

    /// Whether a backward ray at a place inside never leads out: from there, only light that fell
    /// in through the outer horizon can come from the outside.
    #[must_use]
    pub fn kept_inside(&self, state: &State, u_horizon: f64) -> bool {
        state.u >= u_horizon && (state.du >= 0.0 || self.ingoing_energy(u_horizon) <= 0.0)
    }

    /// The largest relative violation of the three constraints: on u'^2, on |n'|^2 and on (n x
    /// n')_z, with |n| = 1.
    #[must_use]
    pub fn residual(&self, s: &State) -> f64 {
        let terms: f64 = self
            .potential_coefficients()
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * s.u.abs() + c.abs());
        // All terms vanish for light that stays on the horizon and is shifted to nothing.
        let radial = if terms > 0.0 {
            (s.du * s.du - self.potential(s.u)).abs() / terms
        } else {
            0.0
        };
        let turning = (self.a * self.energy).powi(2);
        let scale = self.k.abs() + turning;
        if scale == 0.0 {
            return radial;
        }
        let angular = (s.dn.length_squared() - self.k - turning * s.n.z.powi(2)).abs() / scale;
        let axial = (s.n.x * s.dn.y - s.n.y * s.dn.x + self.angular_momentum).abs() / scale.sqrt();
        radial
            .max(angular)
            .max(axial)
            .max((s.n.length_squared() - 1.0).abs())
    }

    /// The power series of the motion from `start` on.
    #[must_use]
    pub fn expand(&self, start: &State) -> Expansion {
        let [_, _, quadratic, cubic, quartic] = self.potential_coefficients();
        let (ae2, al) = (
            (self.a * self.energy).powi(2),
            self.a * self.angular_momentum,
        );
        let swirl = self.a * self.energy;
        let k_prime = cubic;
        let (mut u, mut n, mut chi) = ([0.0; ORDER + 1], [[0.0; ORDER + 1]; 3], [0.0; ORDER + 1]);
        (u[0], u[1], chi[0]) = (start.u, start.du, start.chi);
        for (axis, series) in n.iter_mut().enumerate() {
            (series[0], series[1]) = (start.n[axis], start.dn[axis]);
        }
        // u^2; U'(u)/(2u); K + 2 a^2 E^2 n_z^2; denominator and value of chi'.
        let (mut square, mut pull, mut stiffness) =
            ([0.0; ORDER + 1], [0.0; ORDER + 1], [0.0; ORDER + 1]);
        let (mut denominator, mut dchi) = ([0.0; ORDER + 1], [0.0; ORDER + 1]);
        for (k, order) in (0..ORDER - 1).zip(0_u32..) {
            let constant = f64::from(u8::from(k == 0));
            let both = f64::from((order + 1) * (order + 2));
            square[k] = product_coefficient(&u, &u, k);
            pull[k] = constant * quadratic + 1.5 * cubic * u[k] + 2.0 * quartic * square[k];
            u[k + 2] = product_coefficient(&u, &pull, k) / both;
            stiffness[k] = constant * self.k;
            if ae2 > 0.0 {
                stiffness[k] += 2.0 * ae2 * product_coefficient(&n[2], &n[2], k);
            }
            for axis in 0..3 {
                let along_axis = if axis == 2 { ae2 * n[2][k] } else { 0.0 };
                n[axis][k + 2] = (along_axis - product_coefficient(&stiffness, &n[axis], k)) / both;
            }
            if self.a != 0.0 {
                let numerator = if self.ingoing {
                    let growth = f64::from(order + 1) * u[k + 1];
                    denominator[k] =
                        constant * self.energy + (self.a * swirl - al) * square[k] - growth;
                    swirl * denominator[k] - self.a * k_prime * square[k]
                } else {
                    denominator[k] = constant - u[k] + self.a.powi(2) * square[k];
                    self.a * al * square[k] - swirl * u[k]
                };
                // dchi[k] is still zero here, so the product holds only the terms already known.
                dchi[k] =
                    (numerator - product_coefficient(&denominator, &dchi, k)) / denominator[0];
                chi[k + 1] = dchi[k] / f64::from(order + 1);
            }
        }
        Expansion {
            u: Taylor(u),
            n: n.map(Taylor),
            chi: Taylor(chi),
        }
    }

    /// How far in Mino time an expansion may be trusted and a step may go.
    ///
    /// The bound 1/sqrt(K + (1 + a^2) E^2) keeps a step below one radian. Since n_z'' = -q n_z with
    /// q <= K + a^2 E^2, by Sturm's comparison n_z vanishes at most once a step.
    #[must_use]
    pub fn reach(&self, expansion: &Expansion) -> f64 {
        let mut reach = 1.0 / (self.k + (1.0 + self.a.powi(2)) * self.energy.powi(2)).sqrt();
        let Expansion {
            u: Taylor(u),
            n,
            chi: Taylor(chi),
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
        // Two terms of each, for one may vanish by symmetry. chi's series is one term shorter.
        for k in [ORDER - 1, ORDER] {
            let u_reach = share(u[k], u[0], k).max(share(u[k], u[1], k - 1));
            let n_reach = share(n_term(k), 1.0, k);
            let chi_reach = share(chi[k - 1], 1.0, k - 1);
            reach = reach.min(u_reach).min(n_reach).min(chi_reach);
        }
        reach
    }
}

impl Expansion {
    /// The state after the Mino time `t`.
    #[must_use]
    pub fn at(&self, t: f64) -> State {
        let (u, du) = self.u.at(t);
        let [(x, dx), (y, dy), (z, dz)] = [self.n[0].at(t), self.n[1].at(t), self.n[2].at(t)];
        State {
            u,
            du,
            n: DVec3::new(x, y, z),
            dn: DVec3::new(dx, dy, dz),
            chi: self.chi.at(t).0,
        }
    }
}
