//! The draw of the waves.

use super::model::{Model, OCTAVES, wave_number};
use super::random::{GROUP_STRIDE, phase, random, spread};
use lightfall_model::geometry::kerr::{Kerr, MASS};
use std::f64::consts::{PI, TAU};

/// A shearing wave with the phase m phi + k (x - centre) in the middle of its life.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wave {
    /// Number of crests around the disk, at least one: a wave with none would change the mean flux
    /// of a circle.
    pub m: u32,
    /// Radians per unit of ln r, rounded to `f32`, so that the GPU has the same wave.
    pub k: f64,
}

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

/// Where a wave is in its lives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Age {
    /// Age as a share of a life, from -1/2 to 1/2; 0 in the middle.
    pub share: f64,
    /// Random phase of this life, in turns.
    pub phase: f64,
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
            let wave = |(size, direction): (f64, f64)| {
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
                }
            };
            sizes.into_iter().zip(directions).map(wave).collect()
        });
        let mut random = random(model.seed, ring, OCTAVES);
        let orbit = TAU / angular_velocity(kerr, centre.exp()).0;
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

    /// The age of a wave at a time. The births of an octave's waves are evenly spaced, so that the
    /// sum of their windows' squares does not depend on time.
    pub(super) fn age(&self, time: f64, group: usize, octave: usize) -> Age {
        let (life, rest) = self.lives(time);
        let later = (group as f64 + octave as f64 / OCTAVES as f64) / self.groups.len() as f64;
        let lives = rest + later;
        let number = self.number_in_cycle(life + lives.floor() as i64);
        let place = self.phase_places(number)[octave];
        Age {
            share: lives - lives.floor() - 0.5,
            phase: phase(place.wrapping_add(GROUP_STRIDE.wrapping_mul(group as u32))),
        }
    }
}

/// Omega = y^3/(M (1 + chi y^3)) of the circular orbit at the radius r, with y = sqrt(M/r)
/// (Bardeen, Press & Teukolsky 1972 eq. 2.16), and the shear -dOmega/dln r = (3/2) Omega/(1 + chi
/// y^3).
pub(super) fn angular_velocity(kerr: Kerr, r: f64) -> (f64, f64) {
    let y3 = (MASS / r).powf(1.5);
    let stretch = 1.0 + kerr.spin * y3;
    let omega = y3 / (MASS * stretch);
    (omega, 1.5 * omega / stretch)
}
