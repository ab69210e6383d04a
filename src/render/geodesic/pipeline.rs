//! The render pipeline of the geodesic pass.

use bevy::core_pipeline::core_3d::CORE_3D_DEPTH_FORMAT;
use bevy::prelude::*;
use bevy::render::render_resource::*;

/// With several samples the shader still runs once per pixel; only the foreground's edges are
/// finer.
pub(super) fn pipeline_descriptor(
    layout: BindGroupLayoutDescriptor,
    shader: Handle<Shader>,
    samples: u32,
) -> RenderPipelineDescriptor {
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
        // Reverse depth: zero is the far plane and the cleared value, so the triangle at depth zero
        // passes only where nothing has been drawn.
        depth_stencil: Some(DepthStencilState {
            format: CORE_3D_DEPTH_FORMAT,
            depth_write_enabled: Some(false),
            depth_compare: Some(CompareFunction::GreaterEqual),
            stencil: default(),
            bias: default(),
        }),
        multisample: MultisampleState {
            count: samples,
            ..default()
        },
        ..default()
    }
}
