//! The stages of the presentation, their render pipelines, and the grid of cells.

use bevy::asset::uuid_handle;
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderDevice;

/// The shader of all stages.
pub(super) const SHADER: Handle<Shader> = uuid_handle!("6f0f7c0e-5b7d-4c0c-9a55-0f3f1c1d7a11");

/// Format of the cells: linear light encoded with the sRGB transfer function, so that 8 bits keep
/// every quantization level apart.
pub(super) const GRID_FORMAT: TextureFormat = TextureFormat::Rgba8UnormSrgb;

/// A stage of the presentation: one fragment entry point each.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Stage {
    /// Reduces the picture to cells.
    Pixelate,
    /// Expands the cells to the output.
    Expand,
    /// Scales the picture to the output, where the cells are bypassed.
    Fit,
}

impl Stage {
    pub(super) fn entry_point(self) -> &'static str {
        match self {
            Self::Pixelate => "pixelate",
            Self::Expand => "expand",
            Self::Fit => "fit",
        }
    }
}

/// The pipeline of a stage that writes to a texture of this format.
pub(super) fn pipeline_descriptor(
    layout: BindGroupLayoutDescriptor,
    stage: Stage,
    format: TextureFormat,
) -> RenderPipelineDescriptor {
    RenderPipelineDescriptor {
        label: Some(stage.entry_point().into()),
        layout: vec![layout],
        vertex: VertexState {
            shader: SHADER,
            entry_point: Some("vertex".into()),
            ..default()
        },
        fragment: Some(FragmentState {
            shader: SHADER,
            entry_point: Some(stage.entry_point().into()),
            targets: vec![Some(ColorTargetState {
                format,
                blend: None,
                write_mask: ColorWrites::ALL,
            })],
            ..default()
        }),
        ..default()
    }
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
