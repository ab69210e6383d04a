//! The render pipeline of the geodesic pass.

use crate::antialias::TRAITS_FORMAT;
use bevy::core_pipeline::core_3d::CORE_3D_DEPTH_FORMAT;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use lightfall_core::gpu::Entry;

/// What a pipeline of the geodesic pass draws to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Destination {
    /// The scene camera's picture, behind the foreground. With several samples the shader still
    /// runs once per pixel; only the foreground's edges are finer.
    Picture {
        /// Samples per pixel.
        samples: u32,
        /// What is written to the pass's second target, which the search for edges compares.
        /// Nothing is written where the target is there for the other one of two compared scenes.
        /// None if there is no second target.
        traits: Option<ColorWrites>,
    },
    /// Buffers, or single pixels of the picture: a compute pass with this entry point.
    Compute(Entry),
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
    let (samples, depth_stencil, traits) = match destination {
        Destination::Picture { samples, traits } => (samples, Some(behind_foreground), traits),
        Destination::Light | Destination::Compute(_) => (1, None, None),
    };
    let target = |(format, write_mask)| ColorTargetState {
        format,
        blend: None,
        write_mask,
    };
    let light = (TextureFormat::Rgba16Float, ColorWrites::ALL);
    let traits = traits.map(|writes| (TRAITS_FORMAT, writes));
    let targets = [light].into_iter().chain(traits).map(target);
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
            targets: targets.map(Some).collect(),
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
