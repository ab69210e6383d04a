//! Random numbers by their place in a list: the same on every machine, for any time.

use lightfall_model::random::Random;

/// Distance between the places of an octave's neighbouring waves in the list of phases: 2^32 over
/// the golden ratio, so that the places of two waves are far apart.
pub const GROUP_STRIDE: u32 = 0x9e37_79b9;

/// The phase, in turns from -1/2 to 1/2, of the place `at` in the list of phases: the integer hash
/// that Wellons found by search (lowbias32, 2018). Both languages compute it in 32 bits and keep the
/// upper 23, so a wave has the same phase in both, however many lives it has lived.
pub fn phase(at: u32) -> f64 {
    let mut z = at;
    z = (z ^ (z >> 16)).wrapping_mul(0x7feb_352d);
    z = (z ^ (z >> 15)).wrapping_mul(0x846c_a68b);
    z ^= z >> 16;
    f64::from(z.cast_signed() >> 9) / 8_388_608.0
}

/// The random numbers of a seed for one octave of a ring.
pub(super) fn random(seed: u32, ring: usize, octave: usize) -> Random {
    Random::of_purpose(u64::from(seed) << 16 | (ring * 16 + octave) as u64)
}

/// One number from each of `count` equal parts of [0, 1], in random order.
pub(super) fn spread(random: &mut Random, count: usize) -> Vec<f64> {
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
