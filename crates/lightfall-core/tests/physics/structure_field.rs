//! The field of the disk's structure at a place and a time, in f64, and the factor by which it changes
//! the flux. The twin in WGSL is shaders/disk/structure/waves.wgsl.

use lightfall_core::geometry::kerr::{Kerr, MASS};
use lightfall_core::optics::structure::{MAX_CHANGE, OCTAVES, Ring, Rings, Structure};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Covariance of the places within a pixel's footprint, in (ln r, phi): their variances, and the
/// covariance proper between them. All zero for a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Covariance {
    /// Variance of ln r.
    pub(crate) xx: f64,
    /// Covariance of ln r and phi.
    pub(crate) xp: f64,
    /// Variance of phi.
    pub(crate) pp: f64,
}

impl Covariance {
    /// The covariance of a square pixel whose place in (ln r, phi) changes by `right` and by `down`
    /// from one pixel to the next: J J^T/12, as a square has the variance 1/12 in either direction.
    /// A neighbour farther away than [`MAX_CHANGE`] shows another image of the disk, and is
    /// ignored.
    pub(crate) fn of_pixel(right: [f64; 2], down: [f64; 2]) -> Self {
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
pub(crate) struct Term {
    /// Amplitude, after the weight of its ring, the window of its life and the footprint's filter.
    pub(crate) amplitude: f64,
    /// Phase, in radians.
    pub(crate) phase: f64,
}

/// The field at a place and a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Field {
    /// f: the sum of A cos(phase).
    pub(crate) value: f64,
    /// The sum of A^2.
    pub(crate) squares: f64,
    /// The sum of A^4.
    pub(crate) fourth_powers: f64,
}

impl Field {
    /// The factor of the flux for the contrast sigma: exp(sigma f) over its mean. For independent
    /// phases that mean is the product of I_0(sigma A), and ln I_0(z) = z^2/4 - z^4/64 + z^6/576 -
    /// ... (Abramowitz & Stegun 1964 9.6.12). The filter changes A, so the mean stays one.
    pub(crate) fn factor(&self, sigma: f64) -> f64 {
        let sigma2 = sigma * sigma;
        let mean = sigma2 / 4.0 * (self.squares - sigma2 / 16.0 * self.fourth_powers);
        (sigma * self.value - mean).exp()
    }
}

/// The field of a [`Structure`].
pub(crate) trait StructureField {
    /// The factor by which the structure multiplies the flux at the radius `r` and the azimuth
    /// `phi` for light that leaves at `time`, averaged over a footprint.
    fn factor(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> f64;

    /// The field there.
    fn field(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Field;

    /// The waves there, one by one.
    ///
    /// At the age t a wave has the phase m (phi - Omega(r) t) + k (x - x_ring) + a random phase,
    /// and therefore the radial wave number k - m Omega'(x) t. Its window sqrt(8/3) cos^2(pi
    /// t/life) has the mean square one. A Gaussian footprint multiplies it by exp(-q.P.q/2).
    fn terms(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Vec<Term>;
}

impl StructureField for Structure {
    fn factor(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> f64 {
        self.field(r, phi, time, footprint)
            .factor(self.model.contrast)
    }

    fn field(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Field {
        let mut field = Field::default();
        for Term { amplitude, phase } in self.terms(r, phi, time, footprint) {
            field.value += amplitude * phase.cos();
            field.squares += amplitude.powi(2);
            field.fourth_powers += amplitude.powi(4);
        }
        field
    }

    fn terms(&self, r: f64, phi: f64, time: f64, footprint: Covariance) -> Vec<Term> {
        let x = r.ln();
        let (omega, shear) = angular_velocity(self.kerr, r);
        let amplitudes = self.model.amplitudes();
        let mut terms = Vec::new();
        for (i, ring) in self.rings.iter().enumerate() {
            let weight = ring_weight(&self.places, i, x);
            if weight <= 0.0 {
                continue;
            }
            for (g, group) in ring.groups.iter().enumerate() {
                for octave in 0..OCTAVES {
                    let (wave, age) = (group[octave], age_of(ring, time, g, octave));
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

/// Where a wave is in its lives.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Age {
    /// Age as a share of a life, from -1/2 to 1/2; 0 in the middle.
    share: f64,
    /// Random phase of this life, in turns.
    phase: f64,
}

/// The age of a wave at a time. The births of an octave's waves are evenly spaced, so that the
/// sum of their windows' squares does not depend on time.
fn age_of(ring: &Ring, time: f64, group: usize, octave: usize) -> Age {
    let (life, rest) = ring.lives(time);
    let later = (group as f64 + octave as f64 / OCTAVES as f64) / ring.groups.len() as f64;
    let lives = rest + later;
    let number = ring.number_in_cycle(life + lives.floor() as i64);
    let place = ring.phase_places(number)[octave];
    Age {
        share: lives - lives.floor() - 0.5,
        phase: phase(place.wrapping_add(GROUP_STRIDE.wrapping_mul(group as u32))),
    }
}

/// The weight of a ring at ln r = x. The squares of all weights add up to one everywhere, so
/// that independent rings of variance one give the variance one.
fn ring_weight(rings: &Rings, ring: usize, x: f64) -> f64 {
    let place = ((x - rings.start) / rings.width - 0.5).clamp(0.0, (rings.count - 1) as f64);
    let share = (2.0 * (place - ring as f64).abs() - 0.5).clamp(0.0, 1.0);
    (FRAC_PI_2 * share * share * (3.0 - 2.0 * share)).cos()
}

/// Distance between the places of an octave's neighbouring waves in the list of phases: 2^32 over
/// the golden ratio, so that the places of two waves are far apart.
const GROUP_STRIDE: u32 = 0x9e37_79b9;

/// The phase, in turns from -1/2 to 1/2, of the place `at` in the list of phases: the integer hash
/// that Wellons found by search (lowbias32, 2018). Both languages compute it in 32 bits and keep the
/// upper 23, so a wave has the same phase in both, however many lives it has lived.
fn phase(at: u32) -> f64 {
    let mut z = at;
    z = (z ^ (z >> 16)).wrapping_mul(0x7feb_352d);
    z = (z ^ (z >> 15)).wrapping_mul(0x846c_a68b);
    z ^= z >> 16;
    f64::from(z.cast_signed() >> 9) / 8_388_608.0
}

/// Omega and the shear -dOmega/dln r of the circular orbit at the radius r, inside the photon orbit too,
/// as optics/structure/draw.rs has the first.
fn angular_velocity(kerr: Kerr, r: f64) -> (f64, f64) {
    let y3 = (MASS / r).powf(1.5);
    let stretch = 1.0 + kerr.spin * y3;
    let omega = y3 / (MASS * stretch);
    (omega, 1.5 * omega / stretch)
}
