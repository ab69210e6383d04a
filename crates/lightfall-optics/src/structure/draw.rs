//! The draw of the waves.

use super::model::{Model, OCTAVES, wave_number};
use lightfall_model::geometry::kerr::{Kerr, MASS};
use lightfall_model::random::Random;
use std::f64::consts::{PI, TAU};

/// A shearing wave with the phase m phi + k (x - centre) + kappa n_z in the middle of its life.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Number of crests around the disk, at least one: a wave with none would change the mean flux
    /// of a circle.
    pub m: u32,
    /// Radians per unit of ln r, rounded to `f32`, so that the GPU has the same wave.
    pub k: f64,
    /// Radians per unit of n_z, the cosine of the angle from the normal, rounded in the same way. A
    /// disk without thickness is not affected.
    pub kappa: f64,
}

/// The part of a wave vector along the normal, over that of an isotropic one: less, because layers
/// would look like the decks of a ship.
const VERTICAL_SHARE: f64 = 0.5;

/// A ring and its waves.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// ln r of its centre.
    pub centre: f64,
    /// Life of its waves, in r_s/c.
    pub life: f64,
    /// Number of lives after which the phases repeat; `None` if they never do.
    pub cycle: Option<u32>,
    /// Share of a life by which its clock is ahead.
    offset: f64,
    /// The start of each octave's phases in the list of phases.
    keys: [u32; OCTAVES],
    /// The waves, in groups of one wave of each octave.
    pub groups: Vec<[Wave; OCTAVES]>,
}

impl Ring {
    /// Draws the waves of the ring with this number and centre.
    ///
    /// In each octave, sizes and directions of the wave vectors q are spread over equal parts of
    /// their ranges in random order (Latin hypercube sampling, McKay, Beckman & Conover 1979),
    /// which leaves no direction or size out. q is stretched by the two correlation lengths and
    /// turned by the pitch.
    pub(super) fn new(model: &Model, ring: usize, centre: f64, kerr: Kerr) -> Self {
        let (sin, cos) = model.pitch.sin_cos();
        let across = model.scale;
        let along = model.scale * model.aspect;
        let octaves: [Vec<Wave>; OCTAVES] = std::array::from_fn(|octave| {
            let mut random = random(model.seed, ring, octave);
            let sizes = spread(&mut random, model.octave);
            let directions = spread(&mut random, model.octave);
            // Random numbers of their own, so that a disk with thickness has the waves of one without.
            let heights = spread(
                &mut self::random(model.seed, ring, HEIGHTS + octave),
                model.octave,
            );
            let wave = |((size, direction), height): ((f64, f64), f64)| {
                let q = wave_number(octave as f64 + size);
                let (q_across, q_along) = (PI * direction).sin_cos();
                // Finer filaments are longer for their width, as in magnetised turbulence: the
                // length goes with the width to the power 2/3 (Goldreich & Sridhar 1995).
                let drawn_out = q.max(1.0).cbrt();
                let (q_across, q_along) =
                    (q * q_across / across, q * q_along / (along * drawn_out));
                let m = q_across * sin - q_along * cos;
                let k = q_across * cos + q_along * sin;
                Wave {
                    m: m.abs().round().max(1.0) as u32,
                    k: f64::from(k.copysign(k * m) as f32),
                    kappa: f64::from((VERTICAL_SHARE * q * (2.0 * height - 1.0) / across) as f32),
                }
            };
            let planes = sizes.into_iter().zip(directions);
            planes.zip(heights).map(wave).collect()
        });
        let mut random = random(model.seed, ring, OCTAVES);
        let orbit = TAU / angular_velocity(kerr, centre.exp());
        let life = model.lifetime * orbit;
        // A period consists of whole lives.
        let cycle = model.period.map(|period| (period / life).round().max(1.0));
        Self {
            centre,
            life: model
                .period
                .zip(cycle)
                .map_or(life, |(period, lives)| period / lives),
            cycle: cycle.map(|lives| lives as u32),
            offset: random.unit(),
            keys: std::array::from_fn(|_| random.bits() as u32),
            groups: (0..model.octave)
                .map(|group| std::array::from_fn(|octave| octaves[octave][group]))
                .collect(),
        }
    }

    /// The lives on the ring's clock at a time: their whole number and the rest.
    pub fn lives(&self, time: f64) -> (i64, f64) {
        let lives = time / self.life + self.offset;
        (lives.floor() as i64, lives - lives.floor())
    }

    /// The number of a life within its period.
    pub fn number_in_cycle(&self, life: i64) -> i64 {
        self.cycle
            .map_or(life, |lives| life.rem_euclid(i64::from(lives)))
    }

    /// The places of the octaves' phases in the list of phases, in the ring's life of this number.
    pub fn phase_places(&self, life: i64) -> [u32; OCTAVES] {
        self.keys.map(|key| key.wrapping_add(life as u32))
    }
}

/// Omega = y^3/(M (1 + chi y^3)) of the circular orbit at the radius r, with y = sqrt(M/r)
/// (Bardeen, Press & Teukolsky 1972 eq. 2.16), inside the photon orbit too.
fn angular_velocity(kerr: Kerr, r: f64) -> f64 {
    let y3 = (MASS / r).powf(1.5);
    y3 / (MASS * (1.0 + kerr.spin * y3))
}

/// The number of the first octave's random heights, after those of the octaves and the ring's own.
const HEIGHTS: usize = 8;

/// The random numbers of a seed for one octave of a ring.
fn random(seed: u32, ring: usize, octave: usize) -> Random {
    Random::of_purpose(u64::from(seed) << 16 | (ring * 16 + octave) as u64)
}

/// One number from each of `count` equal parts of [0, 1], in random order.
fn spread(random: &mut Random, count: usize) -> Vec<f64> {
    let mut parts: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        let other = (random.unit() * (last + 1) as f64) as usize;
        parts.swap(last, other.min(last));
    }
    parts
        .into_iter()
        .map(|part| (part as f64 + random.unit()) / count as f64)
        .collect()
}
