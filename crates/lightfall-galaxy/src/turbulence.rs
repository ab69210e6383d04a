//! Turbulence: random fields with structure on all scales, for clouds of dust and of stars.

use glam::{DVec3, FloatExt};
use lightfall_model::random::bits;

/// A random field of mean zero: a sum of octaves of gradient noise (Perlin 2002, "Improving
/// Noise").
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turbulence {
    /// Which field it is.
    pub seed: u64,
    /// Length of the largest octave's cells, in kpc.
    pub scale: f64,
    /// Number of octaves; each has cells half as long.
    pub octaves: u32,
    /// Amplitude of an octave over that of the one before.
    pub persistence: f64,
}

impl Turbulence {
    /// The field at a point in kpc, without what is smaller than `finest`: an octave fades as its
    /// cells become as short.
    pub(crate) fn at(&self, point: DVec3, finest: f64) -> f64 {
        self.sum(point, finest, |noise| noise)
    }

    /// A field that is largest on thin sheets.
    pub(crate) fn ridges(&self, point: DVec3, finest: f64) -> f64 {
        self.sum(point, finest, |noise| MEAN_SIZE - noise.abs())
    }

    /// Three fields as a vector.
    pub(crate) fn vector_at(&self, point: DVec3, finest: f64) -> DVec3 {
        DVec3::from([0, 1, 2].map(|component| {
            let seed = self.seed + component;
            Self { seed, ..*self }.at(point, finest)
        }))
    }

    fn sum(&self, point: DVec3, finest: f64, shape: impl Fn(f64) -> f64) -> f64 {
        let (mut sum, mut cell, mut amplitude) = (0.0, self.scale, 1.0);
        for octave in 0..self.octaves {
            let kept = (cell / finest - 1.0).clamp(0.0, 1.0);
            if kept == 0.0 {
                break;
            }
            // The lattices of octaves are shifted against each other.
            let place = point / cell + DVec3::new(0.37, 0.71, 0.13) * f64::from(octave + 1);
            sum += kept * amplitude * shape(gradient_noise(place, self.seed + u64::from(octave)));
            cell *= 0.5;
            amplitude *= self.persistence;
        }
        sum
    }
}

/// Mean of the absolute value of [`gradient_noise`].
const MEAN_SIZE: f64 = 0.153;

/// Gradient noise: zero at whole numbers, with a random slope there; between -1 and 1, and of
/// standard deviation 0.19.
fn gradient_noise(point: DVec3, seed: u64) -> f64 {
    let base = point.floor();
    let offset = point - base;
    // Each axis blends with Perlin's polynomial of degree five.
    let blend = offset * offset * offset * (offset * (offset * 6.0 - 15.0) + 10.0);
    let corner = |x: f64, y: f64, z: f64| {
        let step = DVec3::new(x, y, z);
        slope(base + step, seed).dot(offset - step)
    };
    let along_x = |y, z| corner(0.0, y, z).lerp(corner(1.0, y, z), blend.x);
    let along_y = |z| along_x(0.0, z).lerp(along_x(1.0, z), blend.y);
    along_y(0.0).lerp(along_y(1.0), blend.z)
}

/// The random slope at a place of the lattice: each component from -1 to 1.
fn slope(place: DVec3, seed: u64) -> DVec3 {
    let [x, y, z] = place
        .to_array()
        .map(|index| (index as i64).cast_unsigned() & 0xffff);
    let random = bits(seed << 48 | x << 32 | y << 16 | z);
    let component = |shift: u32| (random >> shift & 0xffff) as f64 / 32_767.5 - 1.0;
    DVec3::new(component(0), component(16), component(32))
}
