//! The sums of the light of stars, and the squares of the picture that have one each.

use glam::UVec2;

/// Maximum size of `STAR_SUMS` in bytes: what WebGPU lets every device bind.
const MAX_SUMS_SIZE: u64 = 128 << 20;

/// The side in pixels of the squares in which light is summed, for a picture of `size` pixels: one,
/// or more where the sums of single pixels do not fit into a binding. In pictures of that size an
/// image of a star is wider than such a square.
pub fn sums_side(size: UVec2) -> u32 {
    let fits = |side: &u32| squares_size(size, *side) <= MAX_SUMS_SIZE;
    (1..).find(fits).unwrap_or(u32::MAX)
}

/// The size of `STAR_SUMS` in bytes, for a picture of `size` pixels: twelve bytes a square.
pub fn sums_size(size: UVec2) -> u64 {
    squares_size(size, sums_side(size))
}

fn squares_size(size: UVec2, side: u32) -> u64 {
    let [columns, rows] = size
        .to_array()
        .map(|length| u64::from(length.div_ceil(side)));
    12 * columns * rows
}
