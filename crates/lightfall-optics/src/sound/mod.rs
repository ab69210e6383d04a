//! What a ship's cockpit sounds like, as samples: home's beacon, the engine, and clicks for the light.
//!
//! No sound crosses vacuum: these are instruments, which let the pilot hear what the ship's receivers
//! and its light meter measure. The samples depend on nothing but the readings and a seed. They need
//! no device, and [`Cockpit::sample`] neither waits nor allocates.

mod beacon;
mod clicks;
mod engine;
mod limiter;
mod ramp;

pub use beacon::{AUDIBLE, BEACON_HZ, beacon_frequency};
pub use clicks::{CLICK_RATES, click_rate};
pub use limiter::{CEILING, limited};

use beacon::Beacon;
use clicks::Clicks;
use engine::Engine;
use ramp::Ramp;

/// The sample rates of a cockpit, in samples per second.
pub const SAMPLE_RATES: [u32; 2] = [8_000, 384_000];

/// Seconds in which the loudness comes to within 1/e of what is wanted.
const FADE_SECONDS: f64 = 0.05;

/// What the ship's instruments read now. Every number is allowed: one that no instrument can show,
/// as infinity or not a number, is not heard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readings {
    /// Observed over emitted frequency of home's light on the ship, g:
    /// [`Clocks::home_light`](crate::ship::Clocks).
    pub home_light: f64,
    /// Proper acceleration as a share of the engine's largest, from 0 to 1.
    pub thrust: f64,
    /// Flux of the light meter, as a multiple of the one that suits the exposure 0.
    pub flux: f64,
    /// Loudness of all voices together, from 0 for silence to 1.
    pub volume: f64,
}

impl Readings {
    /// What is read while nobody listens.
    pub const SILENCE: Self = Self {
        home_light: 0.0,
        thrust: 0.0,
        flux: 0.0,
        volume: 0.0,
    };
}

/// The flux at which the light meter chooses this exposure, in powers of two: the exposure that
/// suits a picture is the shorter, the more light there is.
pub fn flux_of_exposure(exposure_ev: f64) -> f64 {
    (-exposure_ev).exp2()
}

/// The voices of a cockpit, which follow its readings without jumps.
pub struct Cockpit {
    beacon: Beacon,
    engine: Engine,
    clicks: Clicks,
    volume: Ramp,
}

impl Cockpit {
    /// A cockpit in silence, with this many samples per second (within [`SAMPLE_RATES`], else the
    /// nearest of them). The seed chooses the noise of the engine and the moments of the clicks.
    pub fn new(sample_rate: u32, seed: u64) -> Self {
        let [low, high] = SAMPLE_RATES;
        let rate = f64::from(sample_rate.clamp(low, high));
        Self {
            beacon: Beacon::new(rate),
            engine: Engine::new(rate, seed),
            clicks: Clicks::new(rate, seed),
            volume: Ramp::new(FADE_SECONDS, rate),
        }
    }

    /// Takes new readings. The voices come to them within some hundredths of a second.
    pub fn read(&mut self, readings: Readings) {
        self.beacon.receive(readings.home_light);
        self.engine.push(share(readings.thrust));
        self.clicks.count(readings.flux);
        // Loudness as it is heard is nearer to the square of the amplitude's factor.
        self.volume.aim(share(readings.volume).powi(2));
    }

    /// Whether all further samples are zero until other readings come.
    pub fn is_silent(&self) -> bool {
        self.volume.is_at(0.0)
    }

    /// The next sample, from -1 to 1.
    pub fn sample(&mut self) -> f32 {
        if self.is_silent() {
            return 0.0;
        }
        let voices = self.beacon.sample() + self.engine.sample() + self.clicks.sample();
        (self.volume.next() * limited(voices)) as f32
    }
}

/// A share, with 0 in place of what is none.
fn share(value: f64) -> f64 {
    if value.is_finite() {
        value.clamp(0.0, 1.0)
    } else {
        0.0
    }
}
