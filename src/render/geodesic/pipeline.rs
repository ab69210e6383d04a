//! The render pipeline of the geodesic pass.

use bevy::core_pipeline::core_3d::CORE_3D_DEPTH_FORMAT;
use bevy::prelude::*;
use bevy::render::render_resource::*;

/// What a pipeline of the geodesic pass draws to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Destination {
    /// The scene camera's picture, behind the foreground. With several samples the shader still
    /// runs once per pixel; only the foreground's edges are finer.
    Picture {
        /// Samples per pixel.
        samples: u32,
    },
    /// A texture of one scene's light, without a foreground, from which a difference is made.
    Light,
}

pub(super) fn pipeline_descriptor(
    layout: BindGroupLayoutDescriptor,
    shader: Handle<Shader>,
    destination: Destination,
) -> RenderPipelineDescriptor {
    // Reverse depth: zero is the far plane and the cleared value, so the triangle at depth zero
    // passes only where nothing has been drawn.
    let behind_foreground = DepthStencilState {
        format: CORE_3D_DEPTH_FORMAT,
        depth_write_enabled: Some(false),
        depth_compare: Some(CompareFunction::GreaterEqual),
        stencil: default(),
        bias: default(),
    };
    let (samples, depth_stencil) = match destination {
        Destination::Picture { samples } => (samples, Some(behind_foreground)),
        Destination::Light => (1, None),
    };
    RenderPipelineDescriptor {
        label: Some("geodesic".into()),
        layout: vec![layout],
        vertex: VertexState {
            shader: shader.clone(),
            entry_point: Some("vertex".into()),
            ..default()
        },
        fragment: Some(FragmentState {
            shader,
            entry_point: Some("fragment".into()),
            targets: vec![Some(ColorTargetState {
                format: TextureFormat::Rgba16Float,
                blend: None,
                write_mask: ColorWrites::ALL,
            })],
            ..default()
        }),
        depth_stencil,
        multisample: MultisampleState {
            count: samples,
            ..default()
        },
        ..default()
    }
}
