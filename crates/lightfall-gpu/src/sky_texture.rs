//! The light of the Milky Way, or of a picture of the sky, as a texture.

use lightfall_optics::milky_way::MilkyWay;
use lightfall_optics::sky_picture::SkyPicture;
use std::f64::consts::FRAC_PI_2;
use wgpu::{
    Extent3d, FilterMode, MipmapFilterMode, SamplerDescriptor, TextureDescriptor, TextureDimension,
    TextureFormat, TextureUsages, TextureViewDescriptor, TextureViewDimension,
};

/// Width of a texel of the finest level, in radians: a quarter turn over the texels of a face.
pub(super) const TEXEL: f64 = FRAC_PI_2 / MilkyWay::SIZE as f64;

/// The cube map of the Milky Way, or of a picture of the sky: its texture, its view, its sampler and
/// its bytes, layer by layer and each layer level by level.
#[derive(Debug)]
pub struct SkyTexture;

impl SkyTexture {
    /// The texture. Where no scene shows the Milky Way, a texture of one texel a face takes its
    /// place.
    pub fn descriptor(shown: bool) -> TextureDescriptor<'static> {
        if shown {
            cube_map(MilkyWay::SIZE as u32, MilkyWay::LEVELS as u32)
        } else {
            cube_map(1, 1)
        }
    }

    /// The texture of a picture of the sky.
    pub fn descriptor_of_picture(picture: &SkyPicture) -> TextureDescriptor<'static> {
        cube_map(picture.side() as u32, picture.level_count() as u32)
    }

    /// The view of the texture as a cube.
    pub fn view() -> TextureViewDescriptor<'static> {
        TextureViewDescriptor {
            label: Some("map of the sky"),
            dimension: Some(TextureViewDimension::Cube),
            ..Default::default()
        }
    }

    /// The sampler, linear between texels and between levels.
    pub fn sampler() -> SamplerDescriptor<'static> {
        SamplerDescriptor {
            label: Some("map of the sky"),
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
        bytes_of(MilkyWay::photograph().half_floats())
    }

    /// The bytes of the texture of a picture of the sky.
    pub fn bytes_of_picture(picture: &SkyPicture) -> Vec<u8> {
        bytes_of(picture.half_floats())
    }
}

fn bytes_of(texels: impl IntoIterator<Item = [u16; 4]>) -> Vec<u8> {
    texels
        .into_iter()
        .flatten()
        .flat_map(u16::to_le_bytes)
        .collect()
}

fn cube_map(side: u32, levels: u32) -> TextureDescriptor<'static> {
    TextureDescriptor {
        label: Some("map of the sky"),
        size: Extent3d {
            width: side,
            height: side,
            depth_or_array_layers: 6,
        },
        mip_level_count: levels,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::Rgba16Float,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    }
}
