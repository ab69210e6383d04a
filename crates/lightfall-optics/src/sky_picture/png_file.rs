//! Pictures of the sky in PNG.

use super::error::SkyPictureFault;
use super::panorama::{Panorama, check_size, linear};
use png::{BitDepth, ColorType, Decoder, Transformations};
use std::io::Cursor;

/// The picture of a PNG, whose levels are those of sRGB. What is transparent is dark.
pub(super) fn decoded(bytes: &[u8]) -> Result<Panorama, SkyPictureFault> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(SkyPictureFault::broken)?;
    let (width, height) = reader.info().size();
    check_size(width, height)?;
    let (colour, depth) = reader.output_color_type();
    let length = reader.output_buffer_size().unwrap_or_default();
    let mut levels = vec![0; length];
    reader
        .next_frame(&mut levels)
        .map_err(SkyPictureFault::broken)?;
    let (channels, has_alpha) = match colour {
        ColorType::Grayscale => (1, false),
        ColorType::GrayscaleAlpha => (2, true),
        ColorType::Rgb => (3, false),
        ColorType::Rgba => (4, true),
        ColorType::Indexed => {
            return Err(SkyPictureFault::broken("its palette is missing"));
        }
    };
    let bytes_each = if depth == BitDepth::Sixteen { 2 } else { 1 };
    let level = |bytes: &[u8]| match bytes {
        [high, low] => f32::from(u16::from_be_bytes([*high, *low])) / 65_535.0,
        [byte, ..] => f32::from(*byte) / 255.0,
        [] => 0.0,
    };
    let light = levels.chunks_exact(channels * bytes_each).map(|pixel| {
        let at = |channel: usize| level(&pixel[channel * bytes_each..(channel + 1) * bytes_each]);
        let alpha = if has_alpha { at(channels - 1) } else { 1.0 };
        let colours = if channels < 3 { [0; 3] } else { [0, 1, 2] };
        colours.map(|channel| alpha * linear(at(channel)))
    });
    let light = light.collect();
    Panorama::new([width, height], light)
}
