//! The places of the rays of averaged frames in their pixels: Sobol's sequence in two dimensions
//! (1967), scrambled after Owen (1995). Every run of 2^k places that begins at a multiple of 2^k
//! has one place in each of 2^k boxes of equal area, whatever their shape, so its mean is much more
//! accurate than that over random places.

use glam::DVec2;
use lightfall_model::random::bits;

/// The middle of a pixel, as a share of its side in units of 2^-32.
const MIDDLE: u32 = 1 << 31;

/// The place of the frame of this number within each pixel, from the pixel's middle, in pixels:
/// from -1/2 to 1/2. That of frame 0 is the middle.
pub fn pixel_offset(frame: u32) -> DVec2 {
    let along = |axis: u64, place: fn(u32) -> u32| {
        // Flipping the same digits of every place keeps one place in each box.
        let moved = scrambled(place(frame), axis) ^ scrambled(place(0), axis) ^ MIDDLE;
        f64::from(moved) / 2.0_f64.powi(32) - 0.5
    };
    // The first axis is the number's binary digits in reverse order (van der Corput 1935).
    DVec2::new(along(0, u32::reverse_bits), along(1, sobol))
}

/// The second axis: Sobol's sequence of the polynomial x + 1, whose direction numbers are the rows
/// of Pascal's triangle modulo 2.
fn sobol(number: u32) -> u32 {
    let mut direction = MIDDLE;
    let mut place = 0;
    for digit in 0..u32::BITS {
        if number >> digit & 1 == 1 {
            place ^= direction;
        }
        direction ^= direction >> 1;
    }
    place
}

/// Flips each binary digit or not, at random, as the digits before it decide.
fn scrambled(place: u32, axis: u64) -> u32 {
    (0..u32::BITS).fold(place, |scrambled, digit| {
        // The digits before this one, behind a one that tells how many they are.
        let before = (1_u64 << 32 | u64::from(place)) >> (u32::BITS - digit);
        let flip = bits(axis << 40 | before) >> 63;
        scrambled ^ (flip as u32) << (u32::BITS - 1 - digit)
    })
}
