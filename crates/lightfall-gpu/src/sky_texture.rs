//! The Milky Way's light as a texture.

use lightfall_optics::milky_way::MilkyWay;
use std::f64::consts::FRAC_PI_2;
use wgpu::{
    Extent3d, FilterMode, MipmapFilterMode, SamplerDescriptor, TextureDescriptor, TextureDimension,
    TextureFormat, TextureUsages, TextureViewDescriptor, TextureViewDimension,
};

/// Width of a texel of the finest level, in radians: a quarter turn over the texels of a face.
pub(super) const TEXEL: f64 = FRAC_PI_2 / MilkyWay::SIZE as f64;

/// The cube map of the Milky Way: its texture, its view, its sampler and its bytes, layer by layer
/// and each layer level by level.
#[derive(Debug)]
pub struct SkyTexture;

impl SkyTexture {
    /// The texture. Where no scene shows the Milky Way, a texture of one texel a face takes its
    /// place.
    pub fn descriptor(shown: bool) -> TextureDescriptor<'static> {
        let side = if shown { MilkyWay::SIZE as u32 } else { 1 };
        TextureDescriptor {
            label: Some("Milky Way"),
            size: Extent3d {
                width: side,
                height: side,
                depth_or_array_layers: 6,
            },
            mip_level_count: if shown { MilkyWay::LEVELS as u32 } else { 1 },
            sample_count: 1,
            dimension: TextureDimension::D2,
            format: TextureFormat::Rgba16Float,
            usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
            view_formats: &[],
        }
    }

    /// The view of the texture as a cube.
    pub fn view() -> TextureViewDescriptor<'static> {
        TextureViewDescriptor {
            label: Some("Milky Way"),
            dimension: Some(TextureViewDimension::Cube),
            ..Default::default()
        }
    }

    /// The sampler, linear between texels and between levels.
    pub fn sampler() -> SamplerDescriptor<'static> {
        SamplerDescriptor {
            label: Some("Milky Way"),
            mag_filter: FilterMode::Linear,
            min_filter: FilterMode::Linear,
            mipmap_filter: MipmapFilterMode::Linear,
            ..Default::default()
        }
    }

    /// The texture's bytes, as its descriptor for the same `shown` asks for them.
    pub fn bytes(shown: bool) -> Vec<u8> {
        if !shown {
            return vec![0; 6 * 8];
        }
        let texels = MilkyWay::photograph().half_floats();
        texels
            .into_iter()
            .flatten()
            .flat_map(u16::to_le_bytes)
            .collect()
    }
}
