//! Pictures of the sky in JPEG.

use super::error::SkyPictureFault;
use super::panorama::{Panorama, check_size, linear};
use jpeg_decoder::{Decoder, PixelFormat};

/// The picture of a JPEG, whose levels are those of sRGB.
pub(super) fn decoded(bytes: &[u8]) -> Result<Panorama, SkyPictureFault> {
    let mut decoder = Decoder::new(bytes);
    decoder.read_info().map_err(SkyPictureFault::broken)?;
    let Some(info) = decoder.info() else {
        return Err(SkyPictureFault::broken("it has no header"));
    };
    let size = [info.width, info.height].map(u32::from);
    check_size(size[0], size[1])?;
    let channels = match info.pixel_format {
        PixelFormat::L8 => 1,
        PixelFormat::RGB24 => 3,
        _ => {
            return Err(SkyPictureFault::broken(
                "its colours are not those of a screen",
            ));
        }
    };
    let levels = decoder.decode().map_err(SkyPictureFault::broken)?;
    let light_of: Vec<f32> = (0..=u8::MAX)
        .map(|level| linear(f32::from(level) / 255.0))
        .collect();
    let light: Vec<[f32; 3]> = levels
        .chunks_exact(channels)
        .map(|pixel| {
            let of = |channel: usize| light_of[usize::from(pixel[channel.min(channels - 1)])];
            [of(0), of(1), of(2)]
        })
        .collect();
    if light.len() != (size[0] * size[1]) as usize {
        return Err(SkyPictureFault::broken("it lacks rows"));
    }
    Panorama::new(size, light)
}
