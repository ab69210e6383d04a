//! The textures of the bloom: the base and the levels.

use bevy::image::ToExtents;
use bevy::math::{URect, UVec2};
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderDevice;
use lightfall_core::gpu::BloomLevels;
use lightfall_core::scene::Part;

/// Format of the base: that of the picture.
pub(super) const BASE_FORMAT: TextureFormat = TextureFormat::Rgba16Float;

/// Format of the levels, which needs half of the memory.
pub(super) const LEVEL_FORMAT: TextureFormat = TextureFormat::Rg11b10Ufloat;

/// The textures of the bloom of one picture.
pub(super) struct BloomTextures {
    /// Their sizes.
    pub(super) layout: BloomLevels,
    /// The picture in at most as many rows as the levels can be made from; `None` where that is the
    /// picture itself.
    pub(super) base: Option<TextureView>,
    /// The levels, the largest first. There are two at least.
    pub(super) levels: Vec<TextureView>,
}

impl BloomTextures {
    pub(super) fn new(device: &RenderDevice, layout: BloomLevels, has_base: bool) -> Self {
        let create = |label, size: UVec2, levels, format| {
            device.create_texture(&TextureDescriptor {
                label: Some(label),
                size: size.to_extents(),
                mip_level_count: levels,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format,
                usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            })
        };
        let base = has_base.then(|| create("base of the bloom", layout.base(), 1, BASE_FORMAT));
        let levels = create("bloom", layout.size(), layout.count(), LEVEL_FORMAT);
        let level = |base_mip_level| {
            levels.create_view(&TextureViewDescriptor {
                base_mip_level,
                mip_level_count: Some(1),
                ..Default::default()
            })
        };
        Self {
            layout,
            base: base.map(|base| base.create_view(&Default::default())),
            levels: (0..layout.count()).map(level).collect(),
        }
    }

    /// Whether these are the textures of such a picture.
    pub(super) fn fits(&self, layout: BloomLevels, has_base: bool) -> bool {
        self.layout == layout && self.base.is_some() == has_base
    }

    /// The texels of the base that show a part of the picture, or all of it.
    pub(super) fn texels_of(&self, part: Option<Part>) -> URect {
        let square = self.layout.square();
        let base = self.layout.base();
        part.map_or(URect::from_corners(UVec2::ZERO, base), |part| {
            let end = part.origin + part.size + (square - 1);
            URect::from_corners(part.origin / square, (end / square).min(base))
        })
    }
}
