//! The model of the galaxy as the asset that [`lightfall_optics::milky_way`] reads.

use crate::{light_from, nebulae};
use lightfall_optics::cube_map::{FACES, face_column_row, place};
use lightfall_optics::milky_way::MilkyWay;
use lightfall_optics::milky_way::asset::{
    B_V, DARKEST, DARKEST_NEBULA, NEBULA_STEP, NUMBERS, STEP,
};
use lightfall_optics::stars::galactic_from_celestial;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};

/// Texels along one side of a face.
const SIZE: usize = MilkyWay::SIZE;

/// Lines of sight along a side of a texel.
const LINES: usize = 2;

/// The PNG of texels that [`texel`] has made, all in order.
///
/// # Errors
/// The encoder's.
///
/// # Panics
/// These are not all texels.
pub fn write(texels: &[[u8; NUMBERS]]) -> Result<Vec<u8>, EncodingError> {
    let mut picture = Vec::new();
    for row in texels.chunks_exact(SIZE) {
        for number in 0..NUMBERS {
            picture.extend(row.iter().map(|texel| texel[number]));
        }
    }
    let mut png = Vec::new();
    let mut encoder = Encoder::new(&mut png, (NUMBERS * SIZE) as u32, (FACES * SIZE) as u32);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.write_header()?.write_image_data(&picture)?;
    Ok(png)
}

/// The bytes of a texel, by its number, of the mean light over the texel: the logarithm of the
/// starlight's brightness, the share of the bluer light, and the logarithm of the nebulae's
/// brightness.
pub fn texel(number: usize) -> [u8; NUMBERS] {
    let turn = galactic_from_celestial();
    let (face, column, row) = face_column_row(SIZE, number);
    let (mut v, mut b, mut nebular) = (0.0, 0.0, 0.0);
    for line in 0..LINES * LINES {
        let within = |index: usize, line: usize| {
            (index as f64 + (line as f64 + 0.5) / LINES as f64) / SIZE as f64
        };
        let to = place(
            face,
            within(column, line % LINES),
            within(row, line / LINES),
        );
        let direction = to.normalize();
        let [more_v, more_b] = light_from(turn * direction);
        (v, b) = (v + more_v, b + more_b);
        nebular += nebulae::light_from(direction);
    }
    let lines = (LINES * LINES) as f64;
    let [blue, red] = B_V.map(|b_v| 10_f64.powf(-0.4 * b_v));
    let share = (b / v - red) / (blue - red);
    let byte = |x: f64| x.round().clamp(0.0, 255.0) as u8;
    [
        byte((v / lines / DARKEST).ln() / STEP),
        byte(255.0 * share),
        byte(1.0 + (nebular / lines / DARKEST_NEBULA).ln() / NEBULA_STEP),
    ]
}
