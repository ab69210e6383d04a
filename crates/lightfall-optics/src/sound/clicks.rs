//! Clicks, as a Geiger counter's: the more light, the more often.

use lightfall_model::random::{Random, bits};
use std::f64::consts::TAU;

/// The lowest and the highest mean rate of the clicks, per second.
pub const CLICK_RATES: [f64; 2] = [0.5, 64.0];

/// The mean rate for the flux 1, per second.
const UNIT_RATE: f64 = 4.0;
/// Amplitude of a click.
const AMPLITUDE: f64 = 0.3;
/// A click is a tone of this many hertz that dies away, for a whole number of its periods.
const TONE_HZ: f64 = 2000.0;
/// Seconds that a click lasts, and in which the next one cannot begin: the counter's dead time.
const DEAD_SECONDS: f64 = 0.003;
/// Seconds in which a click falls to 1/e.
const DECAY_SECONDS: f64 = 0.000_6;

/// Mean rate of the clicks, per second, for a flux of the light meter: 4 times the cube root of the
/// flux, from 0.5 to 64. So it grows as brightness does for an eye (Stevens 1957, "On the
/// psychophysical law"), and the fluxes at which the light meter chooses an exposure, from 1/128 to
/// 4096, give 0.8 to 64. No clicks where the flux is no positive number.
pub fn click_rate(flux: f64) -> f64 {
    let [low, high] = CLICK_RATES;
    if flux > 0.0 && flux.is_finite() {
        (UNIT_RATE * flux.cbrt()).clamp(low, high)
    } else {
        0.0
    }
}

/// The clicks.
pub(super) struct Clicks {
    random: Random,
    /// Probability that one begins at a sample outside the dead time.
    chance: f64,
    /// Samples since the last one began, up to those of the dead time.
    age: u32,
    /// Samples of the dead time.
    dead: u32,
    /// Seconds of a sample.
    step: f64,
}

impl Clicks {
    pub(super) fn new(rate: f64, seed: u64) -> Self {
        let dead = (DEAD_SECONDS * rate).round() as u32;
        Self {
            random: Random::new(bits(seed)),
            chance: 0.0,
            age: dead,
            dead,
            step: 1.0 / rate,
        }
    }

    /// Follows a flux. Outside the dead time d, clicks have the rate m/(1 - m d), so that the mean
    /// rate with the dead time is m (Knoll 2010, "Radiation Detection and Measurement", eq. 4.23).
    pub(super) fn count(&mut self, flux: f64) {
        let mean = click_rate(flux);
        let outside = mean / (1.0 - mean * DEAD_SECONDS);
        self.chance = -(-outside * self.step).exp_m1();
    }

    pub(super) fn sample(&mut self) -> f64 {
        if self.age >= self.dead {
            if self.random.unit() >= self.chance {
                return 0.0;
            }
            self.age = 0;
        }
        let time = f64::from(self.age) * self.step;
        self.age += 1;
        AMPLITUDE * (-time / DECAY_SECONDS).exp() * (TAU * TONE_HZ * time).sin()
    }
}
