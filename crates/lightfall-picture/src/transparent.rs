//! Pictures as a window would show them, with transparent parts.

use super::channels::Channels;
use super::file::PictureError;
use super::layers::coverage;
use super::{Captured, Studio};
use exr::prelude::f16;
use glam::UVec2;
use lightfall_core::scene::Scene;
use lightfall_platform::storage::{PictureRecord, set_up_png, write_atomically};
use std::path::Path;

/// A finished picture with transparent parts.
#[derive(Clone, Debug)]
pub struct TransparentStill {
    /// Width and height, in pixels.
    pub size: UVec2,
    /// 8-bit sRGB and opacity, rows from the top, four bytes per pixel. Colours are not multiplied by the
    /// opacity.
    pub rgba: Vec<u8>,
}

/// The colour and the opacity of a pixel whose premultiplied levels are `rgb` and whose opaque share is
/// `share`. What glows without hiding anything gets as much opacity as its light needs, so over black each
/// pixel has its levels.
#[must_use]
pub fn straight([r, g, b]: [u8; 3], share: f32) -> [u8; 4] {
    let alpha = ((255.0 * share).round() as u8).max(r).max(g).max(b);
    let colour = |level: u8| {
        let (level, whole) = (u32::from(level), u32::from(alpha).max(1));
        ((255 * level + whole / 2) / whole) as u8
    };
    [colour(r), colour(g), colour(b), alpha]
}

impl Studio {
    /// The picture of the layers that are shown, with their share of each pixel as its opacity. The view
    /// must be `colour`, without cells, and the studio must keep light.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn transparent_picture(&mut self) -> Result<TransparentStill, PictureError> {
        let (shown, scene) = (self.shown_layers(), self.scene().clone());
        let mut light = self.light()?;
        let shares = opaque_shares(&light, &scene);
        // Bloom must add nothing in the hole, and may add light to everything else, whether it is
        // transparent or not.
        let holes = self.layers(&Channels::of_hole())?;
        for (pixel, hole) in light.rgba.iter_mut().zip(holes.iter().flatten()) {
            pixel[3] = f16::from_f32(1.0 - hole).to_bits();
        }
        let still = self.developed(&scene, &light);
        self.show_layers(shown);
        let still = still?;
        let levels = still.rgb.chunks_exact(3).zip(shares);
        let pixels = levels.map(|(rgb, share)| straight([rgb[0], rgb[1], rgb[2]], share));
        Ok(TransparentStill {
            size: still.size,
            rgba: pixels.flatten().collect(),
        })
    }
}

/// The opaque share of each pixel of the layers whose light this is.
fn opaque_shares(light: &Captured, scene: &Scene) -> Vec<f32> {
    let rows = (UVec2::ZERO, light.size.x);
    let share = |(at, pixel): (usize, &[u16; 4])| {
        coverage(scene, rows, at) as f32 * f16::from_bits(pixel[3]).to_f32()
    };
    light.rgba.iter().enumerate().map(share).collect()
}

/// Writes a picture with transparent parts as a PNG that holds its record. The file appears under its name
/// only when it is complete.
///
/// # Errors
/// The encoding failed, or the file cannot be written.
pub fn write_transparent_png(
    path: &Path,
    still: &TransparentStill,
    record: &PictureRecord,
) -> Result<(), PictureError> {
    let fault = |error: png::EncodingError| PictureError::encode(path, &error);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, still.size.x, still.size.y);
    set_up_png(&mut encoder, png::BitDepth::Eight, record).map_err(fault)?;
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().map_err(fault)?;
    writer.write_image_data(&still.rgba).map_err(fault)?;
    writer.finish().map_err(fault)?;
    Ok(write_atomically(path, &bytes)?)
}
