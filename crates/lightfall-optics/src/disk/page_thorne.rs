//! The flux of a relativistic thin disk: steady accretion around Kerr, without torque at the inner
//! edge. The twin in WGSL is shaders/disk/page_thorne.wgsl, which samples the table made here.

use super::newtonian::{NEWTONIAN_PEAK, newtonian_flux};
use super::returning_table::ReturningLight;
use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::kerr::MASS;

/// Entries of the shader's table.
pub const TABLE_LEN: usize = 64;

/// The flux of Page & Thorne 1974 eqs. 11b and 15n, for one spin and inner edge. With x =
/// sqrt(r/M), x_0 at the inner edge, chi the spin, q = x^3 - 3x + 2 chi and x_i its roots,
///
/// 4 pi F / Mdot = 3 / (2 M^2 x^4 q) [x - x_0 - (3/2) chi ln(x/x_0) - sum_i (x_i - chi)/2 ln((x -
/// x_i)/(x_0 - x_i))].
///
/// Their factor 3 (x_i - chi)^2 / (x_i (x_i - x_j)(x_i - x_k)) equals (x_i - chi)/2, because the
/// two differences multiply to q'(x_i) = 3 (x_i^2 - 1), and from q(x_i) = 0 follows x_i (x_i^2 - 1)
/// = 2 (x_i - chi). So spin zero, where one root is zero, is not a special case.
///
/// The flux is the Newtonian profile with the same inner edge times one slowly varying factor, the
/// correction C:
///
/// F = constant (r_in/r)^3 (1 - sqrt(r_in/r)) C,   C = x^3/q [...] / (x - x_0),   C -> 1 far out.
///
/// Light that [returns](super::returning) to the disk adds R, so that the flux is constant (r_in/r)^3
/// ((1 - sqrt(r_in/r)) C + R).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PageThorne {
    spin: f64,
    inner: f64,
    x0: f64,
    roots: [f64; 3],
    scale: f64,
    returning: Option<ReturningLight>,
}

impl PageThorne {
    /// The disk around a hole of spin `spin`, in (-1, 1), with its inner edge at `inner` r_s, at
    /// the innermost stable circular orbit or beyond. The torque vanishes at the edge. Outside it
    /// the flux is positive: it is an integral of (E - Omega L) dL/dr from the edge outward, and
    /// both factors are positive beyond the innermost stable orbit.
    pub fn new(spin: f64, inner: f64) -> Self {
        let third = spin.acos() / 3.0;
        let sixty = std::f64::consts::FRAC_PI_3;
        // The middle root is 2 cos((arccos chi + pi)/3), in a form without cancellation at small
        // spin.
        let roots = [
            2.0 * (third - sixty).cos(),
            2.0 * (spin.asin() / 3.0).sin(),
            -2.0 * third.cos(),
        ];
        let mut disk = Self {
            spin,
            inner,
            x0: (inner / MASS).sqrt(),
            roots,
            scale: 1.0,
            returning: None,
        };
        disk.scale = NEWTONIAN_PEAK / disk.flux(disk.peak());
        disk
    }

    /// The same disk with light that returns to it, which belongs to its spin and begins at the
    /// innermost stable orbit. The scale stays, so the disk becomes brighter.
    #[must_use]
    pub fn with_returning(self, light: ReturningLight) -> Self {
        Self {
            returning: Some(light),
            ..self
        }
    }

    /// Relative flux at radius `r`, without unit; zero inside the edge. Without returning light its
    /// peak is scaled to that of the Newtonian profile, (36/49)^3 / 7, so that the disk's temperature
    /// and brightness have the same meaning in both models.
    pub fn flux(&self, r: f64) -> f64 {
        let depth = (r - self.inner) / (r * (1.0 + (self.inner / r).sqrt()));
        if depth > 0.0 {
            let own = self.scale * self.correction(depth) * newtonian_flux(r, self.inner);
            let returning = self.returning.map_or(0.0, |light| light.at(depth));
            own + self.scale * (self.inner / r).powi(3) * returning
        } else {
            0.0
        }
    }

    /// The hole's spin.
    pub fn spin(&self) -> f64 {
        self.spin
    }

    /// The inner edge, in r_s.
    pub fn inner(&self) -> f64 {
        self.inner
    }

    /// The factor that gives the flux the Newtonian peak.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Radius of the largest flux, in r_s: the root of d ln F/dx = B'/B - 4/x - q'/q. B is the
    /// bracket, and the derivatives of its terms add up to x q B' = x^4 - 6 x^2 + 8 chi x - 3
    /// chi^2, which vanishes at the innermost stable orbit.
    pub fn peak(&self) -> f64 {
        let rises = |x: f64| {
            let bracket = (x - self.x0) * self.mean_slope(x - self.x0);
            let slope = x * (x * (x * x - 6.0) + 8.0 * self.spin) - 3.0 * self.spin.powi(2);
            slope > bracket * (x * (7.0 * x * x - 15.0) + 8.0 * self.spin)
        };
        // The Newtonian profile peaks at (7/6) x_0, the relativistic one at 1.28 x_0 or less
        // (spin -1).
        let [x, _] = bisection([self.x0, 2.0 * self.x0], f64::MANTISSA_DIGITS, rises);
        MASS * x * x
    }

    /// C at the depth y = 1 - sqrt(r_in/r), from 0 at the edge to 1 at infinity.
    fn correction(&self, depth: f64) -> f64 {
        let w = 1.0 - depth;
        let q: f64 = self
            .roots
            .iter()
            .map(|root| 1.0 - root * w / self.x0)
            .product();
        // Near the edge the terms cancel: at the innermost stable orbit the bracket is of second
        // order in the distance. Rounding may leave a negative value.
        self.mean_slope(self.x0 * depth / w).max(0.0) / q
    }

    /// The bracket divided by the `distance` x - x_0, which is not negative.
    fn mean_slope(&self, distance: f64) -> f64 {
        let share = |weight: f64, root: f64| {
            let z = distance / (self.x0 - root);
            let mean = if z == 0.0 { 1.0 } else { z.ln_1p() / z };
            if z.is_finite() {
                weight * mean / (self.x0 - root)
            } else {
                0.0
            }
        };
        1.0 - share(1.5 * self.spin, 0.0)
            - self
                .roots
                .map(|root| share((root - self.spin) / 2.0, root))
                .iter()
                .sum::<f64>()
    }

    /// The table that the shader samples. Entry i holds the coefficients, in ascending order, of
    /// the cubic in t = 64 p - i through the correction (times the scale) at t = 0, 1/3, 2/3 and 1.
    /// The variable p = sqrt(1 - sqrt(r_in/r)) stretches the edge, where the flux around a fast
    /// hole rises steeply. The error is at most 2e-7 of the peak up to spin 0.998, 1e-6 up to
    /// 0.9999 and 2e-5 up to 1 - 1e-6.
    ///
    /// Returning light does not vanish at the edge, so its correction is R/p^2, which no cubic holds
    /// at p = 0. In the first entry it is the series of 1/t^2 about t = 1, so that the light rises
    /// smoothly from 0 at the edge. As a share of the returning light at the edge the error is at most
    /// 4 % from 1.00025 r_in on, 0.25 % from 1.002 r_in, and 0.06 % from 1.005 r_in.
    pub fn table(&self) -> [[f32; 4]; TABLE_LEN] {
        let returning = |light: &ReturningLight, p: f64| self.scale * light.at(p * p) / (p * p);
        std::array::from_fn(|i| {
            let value = |third: usize| {
                let p = (3 * i + third) as f64 / (3 * TABLE_LEN) as f64;
                let own = self.scale * self.correction(p * p);
                match &self.returning {
                    Some(light) if i > 0 => own + returning(light, p),
                    _ => own,
                }
            };
            let [a, b, c, d] = [0, 1, 2, 3].map(value);
            let cubic = [
                a,
                (-11.0 * a + 18.0 * b - 9.0 * c + 2.0 * d) / 2.0,
                9.0 * (2.0 * a - 5.0 * b + 4.0 * c - d) / 2.0,
                9.0 * (d - a + 3.0 * (b - c)) / 2.0,
            ];
            let rise = match &self.returning {
                Some(light) if i == 0 => {
                    let end = returning(light, 1.0 / TABLE_LEN as f64);
                    [10.0, -20.0, 15.0, -4.0].map(|coefficient| coefficient * end)
                }
                _ => [0.0; 4],
            };
            std::array::from_fn(|k| (cubic[k] + rise[k]) as f32)
        })
    }
}
