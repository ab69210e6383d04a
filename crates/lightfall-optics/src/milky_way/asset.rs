//! The asset that keeps the finest level of the map: a grey picture of 8 bits in PNG. The six faces
//! lie below each other. The first third of a row is the logarithm of the starlight's brightness,
//! the second the share of the bluer light, and the last the logarithm of the nebulae's brightness.

use crate::cube_map::FACES;
use png::{Decoder, DecodingError};
use std::io::Cursor;

/// Texels along one side of a face.
pub(super) const SIZE: usize = 256;

/// Numbers of a texel.
pub const NUMBERS: usize = 3;

/// The brightness in V of a texel of byte 0, in stars of V = 0 per steradian. With [`STEP`] the
/// bytes reach from 24.6 to 19.1 magnitudes per square second of arc.
pub const DARKEST: f64 = 6.0;
/// The step in the logarithm of the brightness from one byte to the next.
pub const STEP: f64 = 0.02;

/// The same for nebulae: their byte 0 is no light, and the others reach from 26.6 magnitudes per
/// square second of arc, a hundredth of the night sky, to 18.4.
pub const DARKEST_NEBULA: f64 = 1.0;
/// See [`DARKEST_NEBULA`].
pub const NEBULA_STEP: f64 = 0.03;

/// B-V of the two lights that a texel is mixed of. The share of the bluer one is that of the
/// brightness in V, in 255ths.
pub const B_V: [f64; 2] = [0.2, 1.6];

/// The lights of each texel: the brightness in V of bluer and redder stars, and the luminance of
/// nebulae, in stars of V = 0 per steradian.
///
/// # Errors
/// The bytes are not a PNG.
///
/// # Panics
/// The picture does not have the size of the map.
pub(super) fn read(png: &[u8]) -> Result<Vec<[f64; NUMBERS]>, DecodingError> {
    let mut reader = Decoder::new(Cursor::new(png)).read_info()?;
    let mut picture = vec![0; NUMBERS * FACES * SIZE * SIZE];
    reader.next_frame(&mut picture)?;
    let rows = picture.chunks_exact(NUMBERS * SIZE);
    Ok(rows.flat_map(row_of_lights).collect())
}

fn row_of_lights(row: &[u8]) -> impl Iterator<Item = [f64; NUMBERS]> {
    (0..SIZE).map(|column| {
        let [stars, share, nebula] = [0, 1, 2].map(|third| f64::from(row[third * SIZE + column]));
        let all = DARKEST * (STEP * stars).exp();
        let blue = all * share / 255.0;
        let nebula = if nebula == 0.0 {
            0.0
        } else {
            DARKEST_NEBULA * (NEBULA_STEP * (nebula - 1.0)).exp()
        };
        [blue, all - blue, nebula]
    })
}
