//! The pipelines that are timed: a compute entry, or a fragment entry with a texture to draw into.

use crate::buffer::compute_pipeline;
use crate::device::Gpu;
use glam::UVec2;

/// A pipeline that is timed.
pub(super) enum Work {
    Compute(wgpu::ComputePipeline),
    Fragment(wgpu::RenderPipeline, wgpu::TextureView),
}

/// Format of the texture that the fragment entry writes: that of the picture.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// The pipeline of the compute entry, with the layout of its bind group.
pub(super) fn compute(gpu: &Gpu, module: &wgpu::ShaderModule) -> (Work, wgpu::BindGroupLayout) {
    let pipeline = compute_pipeline(gpu, module, "timed");
    let layout = pipeline.get_bind_group_layout(0);
    (Work::Compute(pipeline), layout)
}

/// The pipeline of the fragment entry with a texture of `size` pixels, and the layout of its bind
/// group.
pub(super) fn fragment(
    gpu: &Gpu,
    module: &wgpu::ShaderModule,
    size: UVec2,
) -> (Work, wgpu::BindGroupLayout) {
    let pipeline = gpu
        .device
        .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("timed"),
            layout: None,
            vertex: wgpu::VertexState {
                module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: &[],
            },
            primitive: Default::default(),
            depth_stencil: None,
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(FORMAT.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
    let layout = pipeline.get_bind_group_layout(0);
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("timed"),
        size: wgpu::Extent3d {
            width: size.x,
            height: size.y,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    (
        Work::Fragment(pipeline, texture.create_view(&Default::default())),
        layout,
    )
}
