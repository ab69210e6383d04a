//! The constants and the state of a null geodesic.

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::Photon;
use glam::DVec3;

/// Backward rays that start outward within this distance of the horizon, as a share of its radius,
/// use the ingoing azimuth.
const HORIZON_PROXIMITY: f64 = 1e-9;

/// A ray's constants of the motion, per unit frequency for the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotonConstants {
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

/// Position and velocity of a backward ray. Derivatives are with respect to Mino time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotonState {
    /// u = 1/r.
    pub u: f64,
    /// u'.
    pub du: f64,
    /// n, whose azimuth is psi.
    pub n: DVec3,
    /// n'.
    pub dn: DVec3,
    /// chi: the ray's azimuth is psi + chi.
    pub chi: f64,
}

impl PhotonConstants {
    /// The constants, and the start of the backward ray, of a photon at a camera with radius `r`
    /// (r_s) and place `n` on the celestial sphere.
    ///
    /// L = r (n x w)_z and K = r^2 |w|^2 - a^2 E^2 n_z^2. Going backward, n' = -r w and u' =
    /// -(1/r)' = Sigma p^r / r^2.
    pub fn of_photon(kerr: Kerr, photon: &Photon, r: f64, n: DVec3) -> (Self, PhotonState) {
        let (a, energy) = (kerr.a(), photon.energy);
        let w = r * photon.w;
        let (inside, near) = (
            r <= kerr.horizon(),
            r <= kerr.horizon() * (1.0 + HORIZON_PROXIMITY),
        );
        let ingoing = inside || near && photon.radial < 0.0;
        let constants = Self {
            a,
            energy,
            angular_momentum: n.x * w.y - n.y * w.x,
            k: w.length_squared() - (a * energy * n.z).powi(2),
            ingoing,
        };
        let chi = if ingoing {
            kerr.camera_azimuth_lead(r)
        } else {
            0.0
        };
        (
            constants,
            PhotonState {
                u: 1.0 / r,
                du: photon.radial,
                n,
                dn: -w,
                chi,
            },
        )
    }

    /// Carter's Q = K - L^2, in r_s^2.
    pub fn carter_q(&self) -> f64 {
        self.k - self.angular_momentum.powi(2)
    }

    /// K' = Q + (L - a E)^2, in r_s^2.
    pub fn k_prime(&self) -> f64 {
        let ae = self.a * self.energy;
        self.k + ae * (ae - 2.0 * self.angular_momentum)
    }

    /// The coefficients of U, from u^0 to u^4.
    pub fn potential_coefficients(&self) -> [f64; 5] {
        let ae = self.a * self.energy;
        [
            self.energy.powi(2),
            0.0,
            ae * ae - self.k,
            self.k_prime(),
            -self.a.powi(2) * self.carter_q(),
        ]
    }

    /// U(u) = u'^2.
    pub fn potential(&self, u: f64) -> f64 {
        self.potential_coefficients()
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * u + c)
    }

    /// Whether U is certainly positive throughout `[from, to]`, so that no ray turns there. The
    /// test is sufficient, not necessary: a polynomial is nowhere less than its smallest Bernstein
    /// coefficient (Farouki & Rajan 1987).
    pub fn cannot_turn_within(&self, from: f64, to: f64) -> bool {
        let mut c = self.potential_coefficients();
        // The coefficients about `from`, by Horner's shift, then in units of the interval's width.
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

    /// (E (r^2 + a^2) - a L) / r^2 at u = 1/r. At the outer horizon it is positive for every photon
    /// that crosses the horizon inward from the outside.
    pub fn ingoing_energy(&self, u: f64) -> f64 {
        self.energy + self.a * (self.a * self.energy - self.angular_momentum) * u * u
    }

    /// Whether a backward ray at a place inside the horizon stays inside. Light inside comes from
    /// the outside only if it fell in through the outer horizon.
    pub fn stays_inside(&self, state: &PhotonState, u_horizon: f64) -> bool {
        state.u >= u_horizon && (state.du >= 0.0 || self.ingoing_energy(u_horizon) <= 0.0)
    }

    /// The largest relative violation of the constraints on u'^2, |n'|^2, (n x n')_z and |n|.
    pub fn residual(&self, s: &PhotonState) -> f64 {
        let terms: f64 = self
            .potential_coefficients()
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * s.u.abs() + c.abs());
        // All terms vanish for light that stays on the horizon with infinite redshift.
        let radial = if terms > 0.0 {
            (s.du * s.du - self.potential(s.u)).abs() / terms
        } else {
            0.0
        };
        let a2e2 = (self.a * self.energy).powi(2);
        let scale = self.k.abs() + a2e2;
        if scale == 0.0 {
            return radial;
        }
        let angular = (s.dn.length_squared() - self.k - a2e2 * s.n.z.powi(2)).abs() / scale;
        let axial = (s.n.x * s.dn.y - s.n.y * s.dn.x + self.angular_momentum).abs() / scale.sqrt();
        radial
            .max(angular)
            .max(axial)
            .max((s.n.length_squared() - 1.0).abs())
    }
}
