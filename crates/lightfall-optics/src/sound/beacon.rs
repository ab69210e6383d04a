//! Home's beacon: a tone that home sends, as high as it arrives.

use super::ramp::Ramp;
use std::f64::consts::TAU;

/// The frequency at which home's beacon sends, in hertz: the A below middle C.
pub const BEACON_HZ: f64 = 220.0;

/// The lowest and the highest frequency that the ship's receiver makes audible, in hertz: from the
/// lowest that people hear to five octaves above the beacon's own, so g from 1/11 to 32.
pub const AUDIBLE: [f64; 2] = [20.0, 7040.0];

/// Amplitude of the tone.
const AMPLITUDE: f64 = 0.16;
/// Seconds in which the frequency and the amplitude come to within 1/e of what is wanted. A frame of
/// the window is about as long, so frames are not heard as steps.
const GLIDE_SECONDS: f64 = 0.02;
/// Amplitude of the octave, as a share of the tone's: small loudspeakers are weak in low tones, and
/// the octave lets people hear them.
const OCTAVE: f64 = 0.25;

/// The frequency of the beacon on the ship in hertz, for g, the observed over the emitted frequency
/// of home's light: 220 Hz times g. `None` where the receiver makes nothing audible. Home's light
/// falls through the horizon too, so the tone goes on inside.
pub fn beacon_frequency(g: f64) -> Option<f64> {
    let frequency = BEACON_HZ * g;
    let [low, high] = AUDIBLE;
    (low..=high).contains(&frequency).then_some(frequency)
}

/// The tone. Its phase is continuous when the frequency changes.
pub(super) struct Beacon {
    /// Turns since the start, below one.
    phase: f64,
    /// Turns per sample.
    frequency: Ramp,
    amplitude: Ramp,
    rate: f64,
}

impl Beacon {
    pub(super) fn new(rate: f64) -> Self {
        Self {
            phase: 0.0,
            frequency: Ramp::new(GLIDE_SECONDS, rate),
            amplitude: Ramp::new(GLIDE_SECONDS, rate),
            rate,
        }
    }

    pub(super) fn receive(&mut self, g: f64) {
        let Some(hertz) = beacon_frequency(g) else {
            self.amplitude.aim(0.0);
            return;
        };
        // The octave stays below half the sample rate, where it would come back as another tone.
        let frequency = (hertz / self.rate).min(0.25);
        if self.amplitude.is_at(0.0) {
            self.frequency.jump(frequency);
        }
        self.frequency.aim(frequency);
        self.amplitude.aim(AMPLITUDE);
    }

    pub(super) fn sample(&mut self) -> f64 {
        self.phase = (self.phase + self.frequency.next()).fract();
        let (sin, cos) = (TAU * self.phase).sin_cos();
        // sin 2x = 2 sin x cos x.
        self.amplitude.next() * sin * (1.0 + 2.0 * OCTAVE * cos)
    }
}
