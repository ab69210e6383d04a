//! What moves along the jets: filaments and knots, as waves that travel with the matter.
//!
//! A wave has the phase w (t - T(r)) + m (phi - Phi(r)) + b ln r + c x + a random phase, where T and Phi
//! are the time and the turn about the axis in which a pattern comes from the base. So a wave with few
//! oscillations in time draws filaments along the streamlines, and one with many of them knots that move
//! outward. Frequencies are fixed, so nothing winds up. A third kind moves the sheath to and fro.
//!
//! Which waves there are is a choice for a picture: no result of gas dynamics.

use super::Jet;
use crate::shift::RestFrame;
use crate::structure::Field;
use lightfall_model::geometry::quadrature::integral;
use lightfall_model::random::Random;
use lightfall_model::scene::Scene;
use std::f64::consts::TAU;

/// Number of waves of each kind, multiples of four: those of filaments, of knots, and of the sheath's
/// ripples.
pub const KINDS: [usize; 3] = [16, 8, 4];
/// Number of all waves.
pub const WAVES: usize = KINDS[0] + KINDS[1] + KINDS[2];
/// Entries of the table of travel times.
pub const TRAVEL: usize = 64;
/// The least velocity of a pattern. Next to the base, where the matter begins at rest, shocks are
/// faster than it is.
const PATTERN_SPEED: f64 = 0.25;
/// The square of the place across the jet within which waves about the axis vanish.
pub const AXIS: f64 = 0.01;
/// For each unit of `jet.knots`: how sharp filaments are, the standard deviation of the logarithm of the
/// knots' emission, and that of the place of the sheath across the jet.
pub const FILAMENTS: f64 = 30.0;
/// As [`FILAMENTS`] says.
pub const KNOTS: f64 = 0.65;
/// As [`FILAMENTS`] says.
pub const RIPPLES: f64 = 0.06;
/// The purpose of the random numbers.
const PURPOSE: u64 = 0x6a65_7473;

/// A wave along the jets. Its numbers are rounded to `f32`, so that the GPU has the same wave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wave {
    /// w, in radians for each r_s/c.
    pub frequency: f64,
    /// m: crests about the axis, with the sign of their turn.
    pub about: f64,
    /// b, in radians for each unit of ln r.
    pub along: f64,
    /// c, in radians from the axis to the edge.
    pub across: f64,
    /// The phases of the jet above the disk and of the one below, in radians.
    pub phases: [f64; 2],
    /// Amplitude.
    pub amplitude: f64,
}

/// A place in the jets, and a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldPlace {
    /// Radius, in r_s.
    pub r: f64,
    /// n_z.
    pub cos_theta: f64,
    /// Boyer-Lindquist azimuth, in radians.
    pub phi: f64,
    /// Boyer-Lindquist time, in r_s/c.
    pub time: f64,
}

/// The way of a pattern from the base: its time and its turn about the axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Travel {
    /// ln r of the first entry, and between two of them.
    pub start: f64,
    /// As `start` says.
    pub spacing: f64,
    /// (T, Phi), in r_s/c and radians.
    pub entries: [[f64; 2]; TRAVEL],
}

/// The waves of a scene's jets.
#[derive(Clone, Debug, PartialEq)]
pub struct Knots {
    /// The waves.
    pub waves: [Wave; WAVES],
    /// Their way.
    pub travel: Travel,
    /// Standard deviation of the logarithm of the emission.
    pub spread: f64,
    jet: Jet,
}

impl Knots {
    /// The waves of the scene's jets; `None` for smooth ones.
    pub fn of(scene: &Scene) -> Option<Self> {
        let jet = Jet::of(scene).filter(|_| scene.jet.knots > 0.0)?;
        Some(Self {
            waves: waves(scene.disk.period),
            travel: Travel::of(&jet),
            spread: scene.jet.knots,
            jet,
        })
    }

    /// The factor by which the patterns multiply the emission of the smooth jets at a place and a time.
    pub fn factor(&self, place: &FieldPlace) -> f64 {
        let x = self.jet.across(place.r, place.cos_theta);
        let off_axis = x * x / (x * x + AXIS);
        let [time, turn] = self.travel.at(place.r);
        let side = usize::from(place.cos_theta < 0.0);
        let mut fields = [Field::default(); 3];
        for (i, wave) in self.waves.iter().enumerate() {
            let phase = wave.frequency * (place.time - time)
                + wave.about * (place.phi - turn)
                + wave.along * place.r.ln()
                + wave.across * x
                + wave.phases[side];
            let amplitude = wave.amplitude * off_axis.powf(0.5 * wave.about.abs());
            let field = &mut fields[kind_of(i)];
            field.value += amplitude * phase.cos();
            field.squares += amplitude.powi(2);
            field.fourth_powers += amplitude.powi(4);
        }
        let [filaments, knots, ripples] = fields;
        let moved = RIPPLES * self.spread * ripples.value;
        let across = self.jet.across_profile(x - moved, x) / self.jet.across_profile(x, x);
        self.filaments(&filaments) * knots.factor(KNOTS * self.spread) * across
    }

    /// exp(-q f^2) over its mean: bright where the field changes its sign, which is in sheets that are
    /// seen as filaments. A part of the field that a footprint or the axis has taken is spread about its
    /// rest as a normal distribution, over which this is the mean.
    fn filaments(&self, field: &Field) -> f64 {
        let q = FILAMENTS * self.spread;
        let lost = (1.0 - 0.5 * field.squares).max(0.0);
        let width = 1.0 + 2.0 * q * lost;
        ((1.0 + 2.0 * q) / width).sqrt() * (-q * field.value.powi(2) / width).exp()
    }
}

/// The kind of the wave with this number.
fn kind_of(wave: usize) -> usize {
    usize::from(wave >= KINDS[0]) + usize::from(wave >= KINDS[0] + KINDS[1])
}

impl Travel {
    /// The way along the middle of the sheath.
    pub fn of(jet: &Jet) -> Self {
        let shape = jet.shape;
        let start = shape.base.ln();
        let spacing = (shape.length.ln() - start) / (TRAVEL - 1) as f64;
        // dt/dr and dphi/dr.
        let rates = |ln_r: f64| {
            let r = ln_r.exp();
            let psi = shape.width * shape.sheath[0].powi(2) * r.powf(-shape.kappa);
            let cos = (1.0 - psi).max(0.0);
            let frame = RestFrame::at(jet.kerr, r, cos.acos());
            let (_, [outward, _, about]) = jet.velocity(r, cos);
            let pattern = outward.hypot(PATTERN_SPEED);
            let sin = (1.0 - cos * cos).sqrt();
            // dr/dt for the observer with zero angular momentum, and dphi/dt.
            let metric = (jet.kerr.delta(r).max(0.0) / jet.kerr.sigma(r, cos)).sqrt();
            let speed = frame.lapse * metric * pattern;
            let turning = frame.lapse * about / (frame.width * sin);
            [r / speed, r * turning / speed]
        };
        let mut entries = [[0.0; 2]; TRAVEL];
        for i in 1..TRAVEL {
            let ends = [i - 1, i].map(|i| start + spacing * i as f64);
            let gain = |part: usize| integral(ends[0], ends[1], &|x| rates(x)[part]);
            entries[i] = [0, 1].map(|part| entries[i - 1][part] + gain(part));
        }
        Self {
            start,
            spacing,
            entries,
        }
    }

    /// The time and the turn up to the radius `r`, linear between the entries.
    pub fn at(&self, r: f64) -> [f64; 2] {
        let place = ((r.ln() - self.start) / self.spacing).clamp(0.0, (TRAVEL - 1) as f64);
        let low = (place as usize).min(TRAVEL - 2);
        let share = place - low as f64;
        let [from, to] = [self.entries[low], self.entries[low + 1]];
        [0, 1].map(|part| from[part] + share * (to[part] - from[part]))
    }
}

/// The waves of all jets. Where the disk's structure repeats after a period, they repeat, too.
fn waves(period: f64) -> [Wave; WAVES] {
    let mut random = Random::of_purpose(PURPOSE);
    let whole = |frequency: f64| {
        if period > 0.0 {
            TAU / period * (frequency * period / TAU).round().max(1.0)
        } else {
            frequency
        }
    };
    let round = |x: f64| f64::from(x as f32);
    std::array::from_fn(|i| {
        let kind = kind_of(i);
        let first = [0, KINDS[0], KINDS[0] + KINDS[1]][kind];
        let share = ((i - first) as f64 + random.unit()) / KINDS[kind] as f64;
        let sign = if random.one_in(2) { 1.0 } else { -1.0 };
        let mut normal = || (0..3).map(|_| random.between(-1.0, 1.0)).sum::<f64>();
        // From the first of two numbers to the second one, evenly in their logarithms.
        let spread = |from: f64, to: f64| from * (to / from).powf(share);
        let (period, about, along, across) = match kind {
            // Fine filaments change four times as fast as broad ones. They are wound more than the
            // streamlines, at two slightly different pitches, so that they merge and part.
            0 => {
                let about = spread(4.0, 30.0).round();
                let wound = if i % 3 == 2 { 1.0 } else { 1.3 };
                let along = about * (wound + 0.06 * normal());
                (spread(400.0, 100.0), about, along, normal())
            }
            1 => {
                let about = sign * [0.0, 1.0, 2.0][i % 3];
                (spread(6.0, 40.0), about, 0.5 * normal(), 2.0 * normal())
            }
            _ => {
                let about = sign * [1.0, 2.0, 3.0, 1.0][i % 4];
                (spread(10.0, 40.0), about, normal(), 0.0)
            }
        };
        Wave {
            frequency: whole(TAU / period),
            about,
            along: round(along),
            across: round(across),
            phases: [0, 1].map(|_| random.between(0.0, TAU)),
            amplitude: round((2.0 / KINDS[kind] as f64).sqrt()),
        }
    })
}
