//! The graphics device as the passes use it: what they create on it, and how a pass runs.

use bevy::ecs::system::SystemParam;
use bevy::image::ToExtents;
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::render_phase::TrackedRenderPass;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue};
use bevy::render::view::ViewTarget;

/// The device, its queue and its pipelines.
#[derive(SystemParam)]
pub(super) struct Graphics<'w> {
    pub(super) cache: Res<'w, PipelineCache>,
    pub(super) device: Res<'w, RenderDevice>,
    pub(super) queue: Res<'w, RenderQueue>,
}

/// Two textures of the same size and format that passes draw to and read.
pub(super) struct TexturePair {
    pub(super) size: UVec2,
    pub(super) views: [TextureView; 2],
}

impl TexturePair {
    /// Creates a pair, unless there is one of this size.
    pub(super) fn create_or_keep(
        pair: &mut Option<Self>,
        device: &RenderDevice,
        labels: [&'static str; 2],
        size: UVec2,
        format: TextureFormat,
    ) {
        if pair.as_ref().is_none_or(|pair| pair.size != size) {
            let views = labels.map(|label| create_target(device, label, size, format, 1));
            *pair = Some(Self { size, views });
        }
    }
}

/// A texture that passes draw to and read.
pub(super) fn create_target(
    device: &RenderDevice,
    label: &'static str,
    size: UVec2,
    format: TextureFormat,
    samples: u32,
) -> TextureView {
    let texture = device.create_texture(&TextureDescriptor {
        label: Some(label),
        size: size.to_extents(),
        mip_level_count: 1,
        sample_count: samples,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&default())
}

/// A sampler that interpolates linearly between texels. Where columns go around, the first one follows
/// the last.
pub(super) fn linear_sampler(device: &RenderDevice, goes_around: bool) -> Sampler {
    device.create_sampler(&SamplerDescriptor {
        label: Some("linear sampler"),
        address_mode_u: if goes_around {
            AddressMode::Repeat
        } else {
            AddressMode::ClampToEdge
        },
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..default()
    })
}

/// A buffer of this size in bytes.
pub(super) fn create_buffer(
    device: &RenderDevice,
    label: &'static str,
    size: u64,
    usage: BufferUsages,
) -> Buffer {
    device.create_buffer(&BufferDescriptor {
        label: Some(label),
        size,
        usage,
        mapped_at_creation: false,
    })
}

/// The size of the picture that a camera draws to, in pixels.
pub(super) fn picture_size(target: &ViewTarget) -> UVec2 {
    let texture = target.main_texture();
    UVec2::new(texture.width(), texture.height())
}

/// The compute pipelines queued so far, by entry point and shader.
#[derive(Resource, Default)]
pub(super) struct ComputePipelines(
    HashMap<(&'static str, AssetId<Shader>), CachedComputePipelineId>,
);

impl ComputePipelines {
    /// The pipeline of an entry point, whose name it has. It is queued unless it has been before.
    pub(super) fn queue(
        &mut self,
        cache: &PipelineCache,
        entry_point: &'static str,
        layouts: &[&BindGroupLayoutDescriptor],
        shader: &Handle<Shader>,
    ) -> CachedComputePipelineId {
        let id = self.0.entry((entry_point, shader.id()));
        *id.or_insert_with(|| {
            cache.queue_compute_pipeline(ComputePipelineDescriptor {
                label: Some(entry_point.into()),
                layout: layouts.iter().copied().cloned().collect(),
                shader: shader.clone(),
                entry_point: Some(entry_point.into()),
                ..default()
            })
        })
    }
}

/// Runs a compute pass, measured under its name.
pub(super) fn run_compute_pass(
    context: &mut RenderContext,
    name: &'static str,
    dispatch: impl FnOnce(&mut ComputePass),
) {
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let encoder = context.command_encoder();
    let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor {
        label: Some(name),
        timestamp_writes: None,
    });
    let span = diagnostics.pass_span(&mut pass, name);
    dispatch(&mut pass);
    span.end(&mut pass);
}

/// Runs a render pass, measured under its name.
pub(super) fn run_render_pass<'a>(
    context: &'a mut RenderContext,
    name: &'static str,
    color_attachments: &[Option<RenderPassColorAttachment>],
    depth_stencil_attachment: Option<RenderPassDepthStencilAttachment>,
    draw: impl FnOnce(&mut TrackedRenderPass<'a>),
) {
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let mut pass = context.begin_tracked_render_pass(RenderPassDescriptor {
        label: Some(name),
        color_attachments,
        depth_stencil_attachment,
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    let span = diagnostics.pass_span(&mut pass, name);
    draw(&mut pass);
    span.end(&mut pass);
}
