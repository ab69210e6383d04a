//! Pictures of the sky in EXR.

use super::error::SkyPictureFault;
use super::panorama::{Panorama, check_size};
use exr::prelude::{MetaData, ReadChannels, ReadLayers, Vec2, read};
use std::io::Cursor;

/// A picture while it is read.
struct Pixels {
    width: usize,
    light: Vec<[f32; 3]>,
}

/// The picture of an EXR: the channels R, G and B of its first layer that has them, in linear light
/// of Rec. 709's primaries. Its alpha is in these channels already.
pub(super) fn decoded(bytes: &[u8]) -> Result<Panorama, SkyPictureFault> {
    let meta =
        MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(SkyPictureFault::broken)?;
    // Before memory is taken for pixels. All layers of a panorama have its size.
    for header in &meta.headers {
        let Vec2(width, height) = header.layer_size;
        let [width, height] = [width, height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        check_size(width, height)?;
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size: Vec2<usize>, _| Pixels {
                width: size.width(),
                light: vec![[0.0; 3]; size.area()],
            },
            |pixels: &mut Pixels, at: Vec2<usize>, (r, g, b, _): (f32, f32, f32, f32)| {
                pixels.light[at.y() * pixels.width + at.x()] = [r, g, b];
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(SkyPictureFault::broken)?;
    let Vec2(width, height) = image.layer_data.size;
    let pixels = image.layer_data.channel_data.pixels;
    Panorama::new([width as u32, height as u32], pixels.light)
}
