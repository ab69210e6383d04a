//! The Milky Way's texture.

use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use lightfall_core::gpu::SkyTexture;

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
