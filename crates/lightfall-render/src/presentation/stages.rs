//! The stages of the presentation, and the grid of cells between two of them.

use crate::full_screen_pass::Stage;
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderDevice;

/// Format of the cells: linear light encoded with the sRGB transfer function, so that 8 bits keep
/// every quantization level apart.
const GRID_FORMAT: TextureFormat = TextureFormat::Rgba8UnormSrgb;

/// Reduces the picture to cells.
pub(super) const PIXELATE: Stage = ("pixelate", [Some(GRID_FORMAT), None]);

/// Expands the cells to an output of this format.
pub(super) fn expand_to(output: TextureFormat) -> Stage {
    ("expand", [Some(output), None])
}

/// Scales the picture to an output of this format, where the cells are bypassed.
pub(super) fn fit_to(output: TextureFormat) -> Stage {
    ("fit", [Some(output), None])
}

/// A grid of cells of this size.
pub(super) fn create_grid(device: &RenderDevice, size: UVec2) -> TextureView {
    let texture = device.create_texture(&TextureDescriptor {
        label: Some("presentation grid"),
        size: size.to_extents(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: GRID_FORMAT,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&default())
}
