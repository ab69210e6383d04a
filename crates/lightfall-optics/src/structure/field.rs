//! The field of the structure at a place and a time, in f64. The twins in WGSL are
//! shaders/disk/structure/waves.wgsl and shaders/medium/structure/waves.wgsl.

use super::draw::Ring;
use super::model::OCTAVES;
use super::rings::Rings;
use super::{MAX_CHANGE, Structure};
use glam::{DMat3, DVec3};
use lightfall_model::geometry::kerr::{Kerr, MASS};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A place in the disk's matter, and a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Event {
    /// Radius, in r_s.
    pub r: f64,
    /// Boyer-Lindquist azimuth, in radians.
    pub phi: f64,
    /// n_z, the cosine of the angle from the normal.
    pub cos_theta: f64,
    /// Boyer-Lindquist time, in r_s/c.
    pub time: f64,
}

/// Covariance of the places that a pixel sees, in (ln r, phi, n_z).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Covariance(pub DMat3);

impl Covariance {
    /// That of a point.
    pub const POINT: Self = Self(DMat3::ZERO);

    /// The covariance of places that differ by these vectors, over each of which they are spread
    /// evenly: the sum of v v^T/12, as a line of length one has the variance 1/12.
    pub fn of_sides(sides: impl IntoIterator<Item = DVec3>) -> Self {
        let square = |side: DVec3| {
            let columns = [side.x, side.y, side.z].map(|x| side * x / 12.0);
            DMat3::from_cols(columns[0], columns[1], columns[2])
        };
        Self(sides.into_iter().map(square).sum())
    }

    /// The covariance of a square pixel of a disk without thickness whose place in (ln r, phi) changes
    /// by `right` and by `down` from one pixel to the next. A neighbour farther away than
    /// [`MAX_CHANGE`] shows another image of the disk, and is ignored.
    pub fn of_pixel(right: [f64; 2], down: [f64; 2]) -> Self {
        let near = |[dx, dphi]: &[f64; 2]| dx.abs() < MAX_CHANGE[0] && dphi.abs() < MAX_CHANGE[1];
        let sides = [right, down].into_iter().filter(near);
        Self::of_sides(sides.map(|[dx, dphi]| DVec3::new(dx, dphi, 0.0)))
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
    /// exp(sigma f) over its mean. For independent phases that mean is the product of I_0(sigma A),
    /// and ln I_0(z) = z^2/4 - z^4/64 + z^6/576 - ... (Abramowitz & Stegun 1964 9.6.12). The filter
    /// changes A, so the mean stays one.
    pub fn factor(&self, sigma: f64) -> f64 {
        let sigma2 = sigma * sigma;
        let mean = sigma2 / 4.0 * (self.squares - sigma2 / 16.0 * self.fourth_powers);
        (sigma * self.value - mean).exp()
    }
}

impl Structure {
    /// The field of a place and a time, averaged over a footprint.
    pub fn field(&self, event: &Event, footprint: Covariance) -> Field {
        let mut field = Field::default();
        for Term { amplitude, phase } in self.terms(event, footprint) {
            field.value += amplitude * phase.cos();
            field.squares += amplitude.powi(2);
            field.fourth_powers += amplitude.powi(4);
        }
        field
    }

    /// The waves there, one by one.
    ///
    /// At the age t a wave has the phase m (phi - Omega(r) t) + k (x - x_ring) + kappa n_z + a random
    /// phase, and therefore the radial wave number k - m Omega'(x) t. Its window sqrt(8/3) cos^2(pi
    /// t/life) has the mean square one. A Gaussian footprint multiplies it by exp(-q.P.q/2).
    pub fn terms(&self, event: &Event, footprint: Covariance) -> Vec<Term> {
        let x = event.r.ln();
        let (omega, shear) = angular_velocity(self.kerr, event.r);
        let amplitudes = self.model.amplitudes();
        let mut terms = Vec::new();
        for (i, ring) in self.rings.iter().enumerate() {
            let weight = ring_weight(&self.places, i, x);
            if weight <= 0.0 {
                continue;
            }
            for (g, group) in ring.groups.iter().enumerate() {
                for octave in 0..OCTAVES {
                    let (wave, age) = (group[octave], age_of(ring, event.time, g, octave));
                    let (m, t) = (f64::from(wave.m), age.share * ring.life);
                    let q = DVec3::new(wave.k + m * shear * t, m, wave.kappa);
                    let filter = (-0.5 * q.dot(footprint.0 * q)).exp();
                    let window = (8.0_f64 / 3.0).sqrt() * (PI * age.share).cos().powi(2);
                    let place = wave.k * (x - ring.centre) + wave.kappa * event.cos_theta;
                    terms.push(Term {
                        amplitude: amplitudes[octave] * weight * window * filter,
                        phase: m * (event.phi - omega * t) + place + TAU * age.phase,
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
/// as draw.rs has the first.
fn angular_velocity(kerr: Kerr, r: f64) -> (f64, f64) {
    let y3 = (MASS / r).powf(1.5);
    let stretch = 1.0 + kerr.spin * y3;
    let omega = y3 / (MASS * stretch);
    (omega, 1.5 * omega / stretch)
}
