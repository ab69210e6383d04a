//! The Milky Way's texture, and what stands in for the sky's resources where a scene has none.

use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use lightfall_core::gpu::{GpuStarlight, SkyTexture};

/// The Milky Way as the shaders read it, or one texel a face in its place.
pub(super) fn sky_texture(device: &RenderDevice, queue: &RenderQueue, shown: bool) -> TextureView {
    let texture = device.create_texture_with_data(
        queue,
        &SkyTexture::descriptor(shown),
        TextureDataOrder::LayerMajor,
        &SkyTexture::bytes(shown),
    );
    texture.create_view(&SkyTexture::view())
}

/// What scenes without stars bind in place of theirs.
pub(super) struct NoStars {
    pub(super) starlight: UniformBuffer<GpuStarlight>,
    pub(super) milky_way: TextureView,
    pub(super) sums: Buffer,
}

impl NoStars {
    pub(super) fn new(device: &RenderDevice, queue: &RenderQueue) -> Self {
        let mut starlight = UniformBuffer::from(GpuStarlight::default());
        starlight.write_buffer(device, queue);
        Self {
            starlight,
            milky_way: sky_texture(device, queue, false),
            sums: device.create_buffer(&BufferDescriptor {
                label: Some("no light of stars"),
                size: size_of::<[u32; 4]>() as u64,
                usage: BufferUsages::STORAGE,
                mapped_at_creation: false,
            }),
        }
    }
}
