//! Random numbers that are the same on every machine: SplitMix64 (Steele, Lea & Flood 2014).

/// By how much the generator's state grows with each number.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// Random bits of a place: those that the generator gives after this many steps from zero.
pub fn bits(place: u64) -> u64 {
    mixed(place.wrapping_mul(STEP))
}

/// What the generator makes of its state.
fn mixed(state: u64) -> u64 {
    let mut z = state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A sequence of random numbers.
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The sequence that serves one purpose, begun at a random place of the generator's period.
    pub fn of_purpose(purpose: u64) -> Self {
        Self(bits(purpose).wrapping_mul(STEP))
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(STEP);
        mixed(self.0)
    }

    /// The next number from 0 to 1, without 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The next number, uniform between two others.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// The next number whose logarithm is uniform between those of two others.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// True once in `n` times on average.
    pub fn one_in(&mut self, n: u32) -> bool {
        self.unit() * f64::from(n) < 1.0
    }
}
