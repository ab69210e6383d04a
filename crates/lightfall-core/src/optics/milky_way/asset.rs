//! The asset that keeps the finest level of the map: a grey picture of 8 bits in PNG. The six faces
//! lie below each other. Left of the middle is the logarithm of the brightness, and right of it the
//! share of the bluer light.

use super::sight::light_from;
use crate::optics::cube_map::{FACES, face_column_row, place};
use crate::optics::stars::{galactic_from_celestial, temperature_from_b_v};
use png::{BitDepth, ColorType, Compression, Decoder, DecodingError, Encoder, EncodingError};
use std::io::Cursor;

/// Texels along one side of a face.
pub(super) const SIZE: usize = 256;

/// A texel's brightness in V: the darkest in stars of V = 0 per steradian, and the step in its
/// logarithm. They reach from 24.6 to 19.1 magnitudes per square second of arc.
const DARKEST: f64 = 6.0;
const STEP: f64 = 0.02;

/// B-V of the two lights that a texel is mixed of. The share of the bluer one is that of the
/// brightness in V, in 255ths.
const B_V: [f64; 2] = [0.2, 1.6];

/// Lines of sight along a side of a texel.
const LINES: usize = 2;

/// The temperatures of the two lights in kelvin, the bluer one first.
pub(super) fn temperatures() -> [f64; 2] {
    B_V.map(temperature_from_b_v)
}

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

/// The PNG of texels that [`texel`] has made, all in order.
///
/// # Errors
/// The encoder's.
///
/// # Panics
/// These are not all texels.
pub fn write(texels: &[[u8; 2]]) -> Result<Vec<u8>, EncodingError> {
    let mut picture = Vec::new();
    for row in texels.chunks_exact(SIZE) {
        picture.extend(row.iter().map(|[brightness, _]| *brightness));
        picture.extend(row.iter().map(|[_, share]| *share));
    }
    let mut png = Vec::new();
    let mut encoder = Encoder::new(&mut png, 2 * SIZE as u32, (FACES * SIZE) as u32);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.write_header()?.write_image_data(&picture)?;
    Ok(png)
}

/// The two bytes of a texel, by its number: the logarithm of the brightness, and the share of the
/// bluer light, of the mean light over the texel.
#[must_use]
pub fn texel(number: usize) -> [u8; 2] {
    let turn = galactic_from_celestial();
    let (face, column, row) = face_column_row(SIZE, number);
    let (mut v, mut b) = (0.0, 0.0);
    for line in 0..LINES * LINES {
        let within = |index: usize, line: usize| {
            (index as f64 + (line as f64 + 0.5) / LINES as f64) / SIZE as f64
        };
        let to = place(
            face,
            within(column, line % LINES),
            within(row, line / LINES),
        );
        let [more_v, more_b] = light_from(turn * to.normalize());
        (v, b) = (v + more_v, b + more_b);
    }
    let mean = v / (LINES * LINES) as f64;
    let [blue, red] = B_V.map(|b_v| 10_f64.powf(-0.4 * b_v));
    let share = (b / v - red) / (blue - red);
    let byte = |x: f64| x.round().clamp(0.0, 255.0) as u8;
    [byte((mean / DARKEST).ln() / STEP), byte(255.0 * share)]
}
