//! What moves along the jets: strands of the sheath and knots of the spine, as waves that travel with the
//! matter.
//!
//! A wave has the phase w (t - T(r)) + m (phi - Phi(r)) + b ln r + c x + a random phase, where T and Phi
//! are the time and the turn about the axis in which a pattern comes from the base. The waves of strands
//! have many crests across the jet, few about it and few oscillations in time: they are shells within
//! each other, wound like the field lines that trail the rotation, and are seen as fine strands where a
//! line of sight touches them. Those of knots have many oscillations in time and move outward.
//! Frequencies are fixed, so nothing winds up.
//!
//! Which waves there are is a choice for a picture: no result of gas dynamics.

use super::Jet;
use crate::shift::RestFrame;
use crate::structure::Field;
use lightfall_model::geometry::quadrature::integral;
use lightfall_model::random::Random;
use lightfall_model::scene::Scene;
use std::f64::consts::TAU;

/// Number of waves of each kind, multiples of four: those of strands, and of knots.
pub const KINDS: [usize; 2] = [16, 8];
/// Number of all waves.
pub const WAVES: usize = KINDS[0] + KINDS[1];
/// Entries of the table of travel times.
pub const TRAVEL: usize = 64;
/// The place across the jet of the streamline along which patterns travel.
const TRAVEL_PLACE: f64 = 0.65;
/// The least velocity of a pattern. Next to the base, where the matter begins at rest, shocks are
/// faster than it is.
const PATTERN_SPEED: f64 = 0.25;
/// The square of the place across the jet within which waves about the axis vanish.
pub const AXIS: f64 = 0.01;
/// For each unit of `jet.knots`, the standard deviations of the logarithm of the emission: by strands, by
/// knots in the spine, and by knots in the sheath.
pub const STRANDS: f64 = 1.2;
/// As [`STRANDS`] says.
pub const KNOTS: f64 = 0.6;
/// As [`STRANDS`] says.
pub const SHEATH_KNOTS: f64 = 0.2;
/// How far strands are wound about the axis against the rotation, in radians for each unit of ln r.
const WINDING: f64 = 3.0;
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
    /// `jet.knots`: the scale of the deviations.
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
        let mut fields = [Field::default(); 2];
        for (i, wave) in self.waves.iter().enumerate() {
            let phase = wave.frequency * (place.time - time)
                + wave.about * (place.phi - turn)
                + wave.along * place.r.ln()
                + wave.across * x
                + wave.phases[side];
            let amplitude = wave.amplitude * off_axis.powf(0.5 * wave.about.abs());
            let field = &mut fields[usize::from(i >= KINDS[0])];
            field.value += amplitude * phase.cos();
            field.squares += amplitude.powi(2);
            field.fourth_powers += amplitude.powi(4);
        }
        let [strands, knots] = fields;
        let in_sheath =
            strands.factor(STRANDS * self.spread) * knots.factor(SHEATH_KNOTS * self.spread);
        let in_spine = knots.factor(KNOTS * self.spread);
        let [sheath, spine] = self.jet.across_profile(x);
        (sheath * in_sheath + spine * in_spine) / (sheath + spine)
    }
}

impl Travel {
    /// The way along a streamline in the sheath.
    pub fn of(jet: &Jet) -> Self {
        let shape = jet.shape;
        let start = shape.base.ln();
        let spacing = (shape.length.ln() - start) / (TRAVEL - 1) as f64;
        // dt/dr and dphi/dr.
        let rates = |ln_r: f64| {
            let r = ln_r.exp();
            let psi = shape.width * TRAVEL_PLACE.powi(2) * r.powf(-shape.kappa);
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
    let mut waves: [Wave; WAVES] = std::array::from_fn(|i| {
        let is_strand = i < KINDS[0];
        let (number, count) = if is_strand {
            (i, KINDS[0])
        } else {
            (i - KINDS[0], KINDS[1])
        };
        // From the first of two numbers to the second one, evenly in their logarithms.
        let share = (number as f64 + random.unit()) / count as f64;
        let spread = |from: f64, to: f64| from * f64::powf(to / from, share);
        let sign = if random.one_in(2) { 1.0 } else { -1.0 };
        let mut normal = || (0..3).map(|_| random.between(-1.0, 1.0)).sum::<f64>();
        let (period, about, along, across, amplitude) = if is_strand {
            // Neighbouring numbers of crests across have different ones about, so that strands cross.
            let about = (3 * number % 5) as f64;
            let across = spread(4.0, 50.0);
            let along = WINDING * about + 0.6 * normal();
            // Fine strands are fainter than broad ones, and change faster.
            (
                spread(400.0, 60.0),
                about,
                along,
                sign * across,
                across.powf(-0.15),
            )
        } else {
            let about = sign * [0.0, 1.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1.0][number];
            (spread(40.0, 8.0), about, 0.5 * normal(), 0.0, 1.0)
        };
        Wave {
            frequency: whole(TAU / period),
            about,
            along: round(along),
            across: round(across),
            phases: [0, 1].map(|_| random.between(0.0, TAU)),
            amplitude,
        }
    });
    // The field of each kind has the variance one.
    let (strands, knots) = waves.split_at_mut(KINDS[0]);
    for kind in [strands, knots] {
        let squares: f64 = kind.iter().map(|wave| wave.amplitude.powi(2)).sum();
        for wave in kind {
            wave.amplitude = round(wave.amplitude * (2.0 / squares).sqrt());
        }
    }
    waves
}
