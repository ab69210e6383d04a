//! The engine: noise that its thrust makes.

use super::ramp::Ramp;
use lightfall_model::random::{Random, bits};

/// Amplitude of the noise with full thrust, before it is filtered.
const AMPLITUDE: f64 = 2.0;
/// Seconds in which the amplitude comes to within 1/e of what is wanted.
const SPOOL_SECONDS: f64 = 0.06;
/// Above this frequency, in hertz, the noise falls by 12 dB per octave: a rumble, not a hiss.
const CUTOFF_HZ: f64 = 350.0;

/// The noise. Its amplitude is in proportion to thrust, so its power is to the square of it.
pub(super) struct Engine {
    random: Random,
    amplitude: Ramp,
    /// Share of the way to the input that each of the two filters goes in a sample.
    share: f64,
    filters: [f64; 2],
    /// Makes the noise as loud for every sample rate.
    gain: f64,
}

impl Engine {
    pub(super) fn new(rate: f64, seed: u64) -> Self {
        let share = -(-std::f64::consts::TAU * CUTOFF_HZ / rate).exp_m1();
        Self {
            // Other numbers than those of the clicks.
            random: Random::of_purpose(bits(seed)),
            amplitude: Ramp::new(SPOOL_SECONDS, rate),
            share,
            filters: [0.0; 2],
            // The filters leave a band of white noise, whose power per hertz falls with the rate.
            gain: (rate / 48_000.0).sqrt(),
        }
    }

    pub(super) fn push(&mut self, thrust: f64) {
        self.amplitude.aim(AMPLITUDE * thrust);
    }

    pub(super) fn sample(&mut self) -> f64 {
        let mut input = self.random.between(-1.0, 1.0);
        for filter in &mut self.filters {
            *filter += self.share * (input - *filter);
            input = *filter;
        }
        self.amplitude.next() * self.gain * input
    }
}
