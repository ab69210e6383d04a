//! The field at a place and a time, and the factor by which it changes the flux.

use super::Structure;
use super::draw::angular_velocity;
use super::model::OCTAVES;
use std::f64::consts::{PI, TAU};

/// Covariance of the places within a pixel's footprint, in (ln r, phi): their variances, and the
/// covariance proper between them. All zero for a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Covariance {
    /// Variance of ln r.
    pub xx: f64,
    /// Covariance of ln r and phi.
    pub xp: f64,
    /// Variance of phi.
    pub pp: f64,
}

/// Largest change in (ln r, phi) from a pixel to its neighbour in the same image of the disk:
/// `MAX_DX` and `MAX_DPHI` in the shader.
pub const MAX_CHANGE: [f64; 2] = [0.9, 0.75];

impl Covariance {
    /// The covariance of a square pixel whose place in (ln r, phi) changes by `right` and by `down`
    /// from one pixel to the next: J J^T/12, as a square has the variance 1/12 in either direction.
    /// A neighbour farther away than [`MAX_CHANGE`] shows another image of the disk, and is
    /// ignored.
    pub fn of_pixel(right: [f64; 2], down: [f64; 2]) -> Self {
        let counted = |change: [f64; 2]| {
            let near = change[0].abs() < MAX_CHANGE[0] && change[1].abs() < MAX_CHANGE[1];
            if near { change } else { [0.0; 2] }
        };
        let (right, down) = (counted(right), counted(down));
        Self {
            xx: (right[0] * right[0] + down[0] * down[0]) / 12.0,
            xp: (right[0] * right[1] + down[0] * down[1]) / 12.0,
            pp: (right[1] * right[1] + down[1] * down[1]) / 12.0,
        }
    }
}

/// One wave at a place and a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Amplitude, after the weight of its ring, the window of its life and the footprint's filter.
    pub amplitude: f64,
    /// Phase, in radians.
    pub phase: f64,
}

/// The field at a place and a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Field {
    /// f: the sum of A cos(phase).
    pub value: f64,
    /// The sum of A^2.
    pub squares: f64,
    /// The sum of A^4.
    pub fourth_powers: f64,
}

impl Field {
    /// The factor of the flux for the contrast sigma: exp(sigma f) over its mean. For independent
    /// phases that mean is the product of I_0(sigma A), and ln I_0(z) = z^2/4 - z^4/64 + z^6/576 -
    /// ... (Abramowitz & Stegun 1964 9.6.12). The filter changes A, so the mean stays one.
    pub fn factor(&self, sigma: f64) -> f64 {
        let sigma2 = sigma * sigma;
        let mean = sigma2 / 4.0 * (self.squares - sigma2 / 16.0 * self.fourth_powers);
        (sigma * self.value - mean).exp()
    }
}

impl Structure {
    /// The factor by which the structure multiplies the flux at the radius `r` and the azimuth
    /// `phi` for light that leaves at `time`, averaged over a footprint.
    pub fn factor(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> f64 {
        self.field(r, phi, time, footprint)
            .factor(self.model.contrast)
    }

    /// The field there.
    pub fn field(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Field {
        let mut field = Field::default();
        for Term { amplitude, phase } in self.terms(r, phi, time, footprint) {
            field.value += amplitude * phase.cos();
            field.squares += amplitude.powi(2);
            field.fourth_powers += amplitude.powi(4);
        }
        field
    }

    /// The waves there, one by one.
    ///
    /// At the age t a wave has the phase m (phi - Omega(r) t) + k (x - x_ring) + a random phase,
    /// and therefore the radial wave number k - m Omega'(x) t. Its window sqrt(8/3) cos^2(pi
    /// t/life) has the mean square one. A Gaussian footprint multiplies it by exp(-q.P.q/2).
    pub fn terms(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Vec<Term> {
        let x = r.ln();
        let (omega, shear) = angular_velocity(self.kerr, r);
        let amplitudes = self.model.amplitudes();
        let mut terms = Vec::new();
        for (i, ring) in self.rings.iter().enumerate() {
            let weight = self.places.weight(i, x);
            if weight <= 0.0 {
                continue;
            }
            for (g, group) in ring.groups.iter().enumerate() {
                for octave in 0..OCTAVES {
                    let (wave, age) = (group[octave], ring.age(time, g, octave));
                    let (m, t) = (f64::from(wave.m), age.share * ring.life);
                    let k = wave.k + m * shear * t;
                    let Covariance { xx, xp, pp } = footprint;
                    let filter = (-0.5 * (xx * k * k + 2.0 * xp * k * m + pp * m * m)).exp();
                    let window = (8.0_f64 / 3.0).sqrt() * (PI * age.share).cos().powi(2);
                    terms.push(Term {
                        amplitude: amplitudes[octave] * weight * window * filter,
                        phase: m * (phi - omega * t) + wave.k * (x - ring.centre) + TAU * age.phase,
                    });
                }
            }
        }
        terms
    }
}
