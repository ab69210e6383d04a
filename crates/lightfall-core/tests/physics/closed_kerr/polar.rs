//! The motion in latitude, in closed form, and the azimuth that belongs to it.
//!
//! With n = n_z, K_0 = K - a^2 E^2 and the roots m and -K_+/(a^2 E^2) of its right-hand side,
//!
//! n'^2 = Q - K_0 n^2 - a^2 E^2 n^4 = (m - n^2)(K_+ + a^2 E^2 n^2),   K_+ = K_0 + a^2 E^2 m,
//!
//! n = sqrt(m) sin(psi) gives psi' = rho = sqrt(K_+ + a^2 E^2 n^2). So the ray moves along a great
//! circle of inclination arcsin(sqrt(m)), by psi, and the circle turns about the axis. On the circle
//! the azimuth changes by -(L/rho_1)/(1 - n^2) per psi, with rho_1^2 = K_+ + a^2 E^2, because
//! L^2 = (1 - m) rho_1^2. The ray's azimuth changes by -(L/rho)/(1 - n^2). Since rho_1^2 - rho^2 =
//! a^2 E^2 (1 - n^2), the difference has no pole at the axis: the circle turns by
//!
//! -(L a^2 E^2/rho_1) integral of dtau/(rho + rho_1).
//!
//! psi is Jacobi's amplitude, whose series in the nome converges within a few terms, because the
//! modulus is small for all light that does not run next to the axis. Derived.

use glam::{DMat3, DVec3};
use lightfall_core::geometry::elliptic::carlson_rf_pair;
use lightfall_core::geometry::mino::{PhotonConstants, PhotonState};
use lightfall_core::geometry::quadrature::integral;

/// Rays with a larger a^2 E^2 m/K_+ run next to the axis: their impact parameter is at most about
/// a.
const MAX_MODULUS: f64 = 0.25;
/// Terms of the series. Their ratio is at most 0.056.
const TERMS: usize = 14;
/// Longest step, in radians, of rays next to the axis.
const AXIAL_STEP: f64 = 0.002;

/// The motion in latitude of one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Polar {
    n: DVec3,
    dn: DVec3,
    /// K, a^2 E^2 and L.
    k: f64,
    axial: f64,
    angular_momentum: f64,
    /// K_+ and m.
    k_plus: f64,
    m: f64,
    circle: Option<Circle>,
}

/// What rays away from the axis have: the great circle.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Circle {
    /// The circle's direction at the camera.
    tangent: DVec3,
    /// rho_1.
    rho_axis: f64,
    /// psi and the phase at the camera, and the phase's rate.
    psi: f64,
    phase: f64,
    rate: f64,
    /// psi = phase + sum of amplitudes_n sin(2 n phase).
    amplitudes: [f64; TERMS],
}

impl Polar {
    /// The motion of a ray from its start.
    pub(super) fn new(c: &PhotonConstants, start: &PhotonState) -> Self {
        let axial = (c.a * c.energy).powi(2);
        let (n, dn) = (start.n, start.dn);
        let z2 = n.z * n.z;
        let k_0 = c.k - axial;
        // Q, without a difference of large numbers next to the plane.
        let q = if z2 < 0.5 {
            (dn.z * dn.z + c.angular_momentum.powi(2) * z2) / (1.0 - z2) - axial * z2
        } else {
            c.carter_q()
        };
        let root = (k_0 * k_0 + 4.0 * axial * q).max(0.0).sqrt();
        let k_plus = if k_0 > 0.0 {
            0.5 * (k_0 + root)
        } else {
            2.0 * axial * q / (root - k_0)
        };
        let tilt = k_plus - k_0;
        let m = if axial > 0.0 { tilt / axial } else { q / k_0 };
        let mut polar = Self {
            n,
            dn,
            k: c.k,
            axial,
            angular_momentum: c.angular_momentum,
            k_plus,
            m,
            circle: None,
        };
        if k_plus > 0.0 && tilt <= MAX_MODULUS * k_plus {
            polar.circle = Some(polar.circle_of(tilt.max(0.0)));
        }
        polar
    }

    fn circle_of(&self, tilt: f64) -> Circle {
        let rho = (self.k_plus + self.axial * self.n.z.powi(2)).sqrt();
        let rho_axis = (self.k_plus + self.axial).sqrt();
        let turned = self.angular_momentum * self.axial / (rho * rho_axis * (rho + rho_axis));
        let tangent = self.dn / rho + turned * DVec3::new(-self.n.y, self.n.x, 0.0);
        let psi = (self.n.z * rho).atan2(self.dn.z);

        let (slow, fast) = (self.k_plus.sqrt(), (self.k_plus + tilt).sqrt());
        let r = (tilt / (slow + fast)) / (slow + fast);
        // 1/rho = 2/(slow + fast) (c_0 + 2 sum of c_n cos(2 n psi)): the generating function of
        // Legendre's polynomials, squared.
        let mut half = [1.0; 2 * TERMS];
        for k in 1..2 * TERMS {
            half[k] = half[k - 1] * (2.0 * k as f64 - 1.0) / (2.0 * k as f64);
        }
        let c = |n: usize| -> f64 {
            (0..TERMS)
                .map(|k| half[k] * half[k + n] * r.powi((2 * k + n) as i32))
                .sum()
        };
        let phase = psi
            + (1..=TERMS)
                .map(|n| c(n) / (n as f64 * c(0)) * (2.0 * n as f64 * psi).sin())
                .sum::<f64>();
        // q^2 is the nome of the modulus r.
        let s = r * r / 16.0;
        let nome = (s * (1.0 + s * (8.0 + s * (84.0 + s * (992.0 + 12514.0 * s))))).sqrt();
        let amplitudes = std::array::from_fn(|i| {
            let n = i as i32 + 1;
            2.0 * (-nome).powi(n) / (f64::from(n) * (1.0 + nome.powi(2 * n)))
        });
        Circle {
            tangent,
            rho_axis,
            psi,
            phase,
            rate: (slow + fast) / (2.0 * c(0)),
            amplitudes,
        }
    }

    /// The Mino times of the first crossing of the plane and from each crossing to the next; `None`
    /// for a ray that never crosses it.
    pub(super) fn crossing_times(&self) -> Option<[f64; 2]> {
        let (z, dz) = (self.n.z.abs(), self.dn.z);
        if self.k_plus <= 0.0 || z == 0.0 && dz == 0.0 {
            return None;
        }
        let toward = self.n.z * dz < 0.0;
        if let Some(circle) = self.circle {
            let phase = circle.phase.rem_euclid(std::f64::consts::PI);
            let period = std::f64::consts::PI / circle.rate;
            return Some([period - phase / circle.rate, period]);
        }
        let rho2 = self.k_plus + self.axial * z * z;
        // R_F of x and two values that differ by `gap`, the smaller one of which is k_plus.
        let rf = |x, gap: f64| carlson_rf_pair(x, self.k_plus + 0.5 * gap, (0.5 * gap).powi(2));
        let quarter = rf(0.0, self.axial * self.m);
        let climb = (dz * dz / rho2) * self.k_plus / self.m;
        let to_plane = z / self.m.sqrt() * rf(climb, self.axial * z * z);
        let first = if toward {
            to_plane
        } else {
            2.0 * quarter - to_plane
        };
        Some([first, 2.0 * quarter])
    }

    /// The place on the celestial sphere after the Mino time `t`, but for the dragging of the radial
    /// motion.
    pub(super) fn at(&self, t: f64) -> DVec3 {
        let Some(circle) = self.circle else {
            return self.step_to(t);
        };
        let end = circle.phase + circle.rate * t;
        let swept = circle.psi_at(end) - circle.psi;
        let place = swept.cos() * self.n + swept.sin() * circle.tangent;
        let slowing =
            |t: f64| 1.0 / (circle.rho_axis + circle.speed_at(circle.phase + circle.rate * t));
        let turn =
            -self.angular_momentum * self.axial / circle.rho_axis * integral(0.0, t, &slowing);
        DMat3::from_rotation_z(turn) * place
    }

    /// Next to the axis the motion is short; it is stepped by Nystroem's rule of fifth order.
    fn step_to(&self, t: f64) -> DVec3 {
        let steps = (t * (self.k.abs() + 2.0 * self.axial).sqrt() / AXIAL_STEP)
            .ceil()
            .max(1.0);
        let h = t / steps;
        let acceleration =
            |n: DVec3| self.axial * n.z * DVec3::Z - (self.k + 2.0 * self.axial * n.z * n.z) * n;
        let (mut n, mut dn) = (self.n, h * self.dn);
        for _ in 0..steps as u32 {
            let k1 = h * h * acceleration(n);
            let k2 = h * h * acceleration(n + 0.2 * dn + 0.02 * k1);
            let k3 = h * h * acceleration(n + 2.0 / 3.0 * dn + (7.0 * k2 - k1) / 27.0);
            let k4 = h * h * acceleration(n + dn + 0.3 * k1 + (9.0 * k3 - 2.0 * k2) / 35.0);
            n += dn + (14.0 * k1 + 100.0 * k2 + 54.0 * k3) / 336.0;
            dn += (14.0 * k1 + 125.0 * k2 + 162.0 * k3 + 35.0 * k4) / 336.0;
        }
        n
    }
}

impl Circle {
    fn psi_at(&self, phase: f64) -> f64 {
        let terms = self.amplitudes.iter().zip(1..);
        phase
            + terms
                .map(|(d, n)| d * (2.0 * f64::from(n) * phase).sin())
                .sum::<f64>()
    }

    fn speed_at(&self, phase: f64) -> f64 {
        let terms = self.amplitudes.iter().zip(1..);
        let sum: f64 = terms
            .map(|(d, n)| 2.0 * f64::from(n) * d * (2.0 * f64::from(n) * phase).cos())
            .sum();
        self.rate * (1.0 + sum)
    }
}
