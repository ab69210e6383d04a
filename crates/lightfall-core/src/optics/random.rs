//! Random numbers that are the same on every machine: SplitMix64 (Steele, Lea & Flood 2014).

/// Random bits of a place: the output function of SplitMix64.
pub(super) fn bits(place: u64) -> u64 {
    let mut z = place.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A number from 0 to 1, without 1, from 64 random bits.
pub(super) fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// A sequence of random numbers.
pub(super) struct Sequence(u64);

impl Sequence {
    /// The sequence of a seed and a number that says what it is for.
    pub(super) fn new(seed: u32, purpose: u32) -> Self {
        Self(bits(u64::from(seed) << 32 | u64::from(purpose)))
    }

    /// The next number from 0 to 1, without 1.
    pub(super) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(1);
        unit(bits(self.0))
    }
}
