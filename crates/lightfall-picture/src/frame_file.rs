//! Pictures of a film that are read from files.

use super::PngBits;
use exr::prelude::{ReadChannels, ReadLayers, read};
use glam::UVec2;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Most bytes that a decoder of PNG may take: those of the largest picture with 16 bits and alpha.
const MAX_PNG_BYTES: usize = 1 << 31;

/// A picture of a .png, or its size alone.
pub struct PngFrame {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Bits of a channel.
    pub bits: PngBits,
    /// The levels of red, green and blue of each pixel, rows from the top.
    pub levels: Vec<u16>,
}

/// Size and bits of the picture of a .png, without its levels.
///
/// # Errors
/// The file cannot be read, or is no picture in red, green and blue. The message continues a sentence that
/// begins with the file's name.
pub fn png_form(path: &Path) -> Result<PngFrame, String> {
    opened_png(path).map(|(frame, _)| frame)
}

/// The picture of a .png.
///
/// # Errors
/// As [`png_form`].
pub fn read_png_frame(path: &Path) -> Result<PngFrame, String> {
    let (mut frame, mut reader) = opened_png(path)?;
    let size = reader.output_buffer_size().ok_or("it is too large")?;
    let mut bytes = vec![0; size];
    let info = reader
        .next_frame(&mut bytes)
        .map_err(|error| format!("cannot be read: {error}"))?;
    bytes.truncate(info.buffer_size());
    let levels: Vec<u16> = match frame.bits {
        PngBits::Eight => bytes.into_iter().map(u16::from).collect(),
        PngBits::Sixteen => bytes
            .chunks_exact(2)
            .map(|pair| u16::from_be_bytes([pair[0], pair[1]]))
            .collect(),
    };
    frame.levels = match info.color_type {
        png::ColorType::Rgba => levels
            .chunks_exact(4)
            .flat_map(|rgba| [rgba[0], rgba[1], rgba[2]])
            .collect(),
        _ => levels,
    };
    Ok(frame)
}

fn opened_png(path: &Path) -> Result<(PngFrame, png::Reader<BufReader<File>>), String> {
    let file = File::open(path)
        .map_err(|error| format!("cannot be read: {}", lightfall_core::reason::reason(&error)))?;
    let limits = png::Limits {
        bytes: MAX_PNG_BYTES,
    };
    let decoder = png::Decoder::new_with_limits(BufReader::new(file), limits);
    let reader = decoder
        .read_info()
        .map_err(|error| format!("cannot be read: {error}"))?;
    let info = reader.info();
    let bits = match (info.color_type, info.bit_depth) {
        (png::ColorType::Rgb | png::ColorType::Rgba, png::BitDepth::Eight) => PngBits::Eight,
        (png::ColorType::Rgb | png::ColorType::Rgba, png::BitDepth::Sixteen) => PngBits::Sixteen,
        _ => return Err("has no red, green and blue of 8 or 16 bits".into()),
    };
    let frame = PngFrame {
        size: UVec2::new(info.width, info.height),
        bits,
        levels: Vec::new(),
    };
    Ok((frame, reader))
}

/// The light of an .exr.
pub struct LightFrame {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// Linear red, green and blue of each pixel, rows from the top.
    pub rgb: Vec<[f32; 3]>,
}

/// The size of the picture of an .exr.
///
/// # Errors
/// As [`read_light_frame`].
pub fn exr_size(path: &Path) -> Result<UVec2, String> {
    let meta = exr::meta::MetaData::read_from_file(path, false)
        .map_err(|error| format!("cannot be read: {error}"))?;
    let size = meta.headers.first().ok_or("has no picture")?.layer_size;
    Ok(UVec2::new(size.0 as u32, size.1 as u32))
}

/// The channels R, G and B of an .exr.
///
/// # Errors
/// The file cannot be read, or has no such channels. The message continues a sentence that begins with the
/// file's name.
pub fn read_light_frame(path: &Path) -> Result<LightFrame, String> {
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| LightFrame {
                size: UVec2::new(size.0 as u32, size.1 as u32),
                rgb: vec![[0.0; 3]; size.0 * size.1],
            },
            |frame: &mut LightFrame, place, (r, g, b): (f32, f32, f32)| {
                let pixel = place.1 * frame.size.x as usize + place.0;
                frame.rgb[pixel] = [r, g, b];
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_file(path)
        .map_err(|error| format!("cannot be read: {error}"))?;
    Ok(image.layer_data.channel_data.pixels)
}
