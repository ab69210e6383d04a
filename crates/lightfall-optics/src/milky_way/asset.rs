//! The asset that keeps the finest level of the map: a grey picture of 8 bits in PNG. The six faces
//! lie below each other. Left of the middle is the logarithm of the brightness, and right of it the
//! share of the bluer light.

use crate::cube_map::FACES;
use png::{Decoder, DecodingError};
use std::io::Cursor;

/// Texels along one side of a face.
pub(super) const SIZE: usize = 256;

/// The brightness in V of a texel of byte 0, in stars of V = 0 per steradian. With [`STEP`] the
/// bytes reach from 24.6 to 19.1 magnitudes per square second of arc.
pub const DARKEST: f64 = 6.0;
/// The step in the logarithm of the brightness from one byte to the next.
pub const STEP: f64 = 0.02;

/// B-V of the two lights that a texel is mixed of. The share of the bluer one is that of the
/// brightness in V, in 255ths.
pub const B_V: [f64; 2] = [0.2, 1.6];

/// The brightness in V of the two lights of each texel, in stars of V = 0 per steradian.
///
/// # Errors
/// The bytes are not a PNG.
///
/// # Panics
/// The picture does not have the size of the map.
pub(super) fn read(png: &[u8]) -> Result<Vec<[f64; 2]>, DecodingError> {
    let mut reader = Decoder::new(Cursor::new(png)).read_info()?;
    let mut picture = vec![0; 2 * FACES * SIZE * SIZE];
    reader.next_frame(&mut picture)?;
    let brightness: Vec<f64> = (0..256)
        .map(|byte| DARKEST * (STEP * f64::from(byte)).exp())
        .collect();
    let rows = picture.chunks_exact(2 * SIZE);
    let texels = rows.flat_map(|row| {
        let (left, right) = row.split_at(SIZE);
        left.iter().zip(right).map(|(left, right)| {
            let all = brightness[usize::from(*left)];
            let blue = all * f64::from(*right) / 255.0;
            [blue, all - blue]
        })
    });
    Ok(texels.collect())
}
