//! The numbers of the model, from the fields of a scene's disk.

use lightfall_model::scene::{Disk, DiskStructure};

/// Octaves of the wave numbers.
pub const OCTAVES: usize = 4;

/// Maximum number of waves in a ring.
pub const MAX_WAVES: usize = 48;

/// Minimum number of waves in an octave: with fewer, the variance would change with time.
const MIN_OCTAVE: u32 = 3;

/// The smallest wave number, in units of one over a correlation length.
const SMALLEST: f64 = 0.5;

/// The wave number `octaves` above the smallest one.
pub(super) fn wave_number(octaves: f64) -> f64 {
    SMALLEST * octaves.exp2()
}

/// The numbers of the structure's model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model {
    /// Standard deviation sigma of the logarithm of the flux.
    pub contrast: f64,
    /// Correlation length across the filaments, in ln r.
    pub scale: f64,
    /// Correlation length along the filaments over the one across.
    pub aspect: f64,
    /// Angle from the orbit to the filaments of a wave in the middle of its life, in radians.
    pub pitch: f64,
    /// Life of a wave, in orbits of its ring's centre.
    pub lifetime: f64,
    /// Period of the structure, in r_s/c; `None` if it does not repeat.
    pub period: Option<f64>,
    /// Number of waves in each octave of a ring.
    pub octave: usize,
    /// Seed of the random pattern.
    pub seed: u32,
}

impl Model {
    /// The model that the disk's fields describe, with at most `limit` waves in a ring; `None` for
    /// a smooth disk. `streaks` changes the numbers within the limits of their fields. The number
    /// of waves is rounded down to a multiple of the octaves' number.
    pub fn new(disk: &Disk, limit: Option<u32>) -> Option<Self> {
        let waves = disk.waves.min(limit.unwrap_or(disk.waves));
        let octave = (waves / OCTAVES as u32).clamp(MIN_OCTAVE, (MAX_WAVES / OCTAVES) as u32);
        let turbulent = Self {
            contrast: disk.contrast,
            scale: disk.scale,
            aspect: disk.aspect,
            pitch: disk.pitch_deg.to_radians(),
            lifetime: disk.lifetime,
            period: Some(disk.period).filter(|period| *period > 0.0),
            octave: octave as usize,
            seed: disk.seed,
        };
        match disk.structure {
            DiskStructure::None => None,
            DiskStructure::Turbulent => Some(turbulent),
            DiskStructure::Streaks => Some(Self {
                contrast: (disk.contrast * 5.0 / 3.0).min(1.5),
                scale: (disk.scale * 5.0 / 7.0).max(0.02),
                aspect: (disk.aspect * 2.4).min(20.0),
                pitch: turbulent.pitch * 8.0 / 15.0,
                lifetime: (disk.lifetime * 1.5).min(4.0),
                ..turbulent
            }),
        }
    }

    /// Amplitude of the waves of each octave. The spectrum is that of an exponential covariance
    /// (Matern's with nu = 1/2 in two dimensions): the share of an octave at the wave number q is
    /// q^2 (1 + q^2)^(-3/2). The mean squares of all waves add up to one.
    pub fn amplitudes(&self) -> [f64; OCTAVES] {
        let shares: [f64; OCTAVES] = std::array::from_fn(|octave| {
            let q2 = wave_number(octave as f64 + 0.5).powi(2);
            q2 * (1.0 + q2).powf(-1.5)
        });
        let sum = shares.iter().sum::<f64>() * self.octave as f64;
        shares.map(|share| (2.0 * share / sum).sqrt())
    }
}
