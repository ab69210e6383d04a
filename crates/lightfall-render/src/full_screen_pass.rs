//! Passes that draw one full-screen triangle, without depth.

use crate::graphics::{Graphics, linear_sampler, run_render_pass};
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::render_resource::binding_types::{sampler, texture_2d, uniform_buffer};
use bevy::render::render_resource::encase::internal::WriteInto;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice};

/// A pass with one shader. Its binding 0 is the uniform `U`, and its other bindings are textures, which
/// it reads texel by texel or with a sampler that comes last, in the order of its list in
/// `gpu/bindings.rs`. Each stage of the pass is an entry point of the shader.
pub(super) struct FullScreenPass<U: ShaderType> {
    shader: Handle<Shader>,
    layout: BindGroupLayoutDescriptor,
    sampler: Option<Sampler>,
    uniform: UniformBuffer<U>,
    /// Those queued so far.
    pipelines: HashMap<Stage, CachedRenderPipelineId>,
}

/// An entry point of a shader, and the formats of the one or two textures that it draws to.
pub(super) type Stage = (&'static str, [Option<TextureFormat>; 2]);

impl<U: ShaderType + WriteInto + Default> FullScreenPass<U> {
    /// A pass that reads this number of textures.
    pub(super) fn new(name: &'static str, shader: Handle<Shader>, textures: u32) -> Self {
        let visibility = ShaderStages::FRAGMENT;
        let texture = texture_2d(TextureSampleType::Float { filterable: false });
        let mut entries = vec![uniform_buffer::<U>(false).build(0, visibility)];
        entries.extend((1..=textures).map(|binding| texture.build(binding, visibility)));
        Self {
            shader,
            layout: BindGroupLayoutDescriptor::new(name, &entries),
            sampler: None,
            uniform: UniformBuffer::from(U::default()),
            pipelines: HashMap::default(),
        }
    }

    /// The pass with a sampler that interpolates linearly between texels.
    pub(super) fn with_sampler(mut self, device: &RenderDevice) -> Self {
        let entries = &mut self.layout.entries;
        for entry in entries.iter_mut() {
            if let BindingType::Texture { sample_type, .. } = &mut entry.ty {
                *sample_type = TextureSampleType::Float { filterable: true };
            }
        }
        let binding = entries.len() as u32;
        let kind = sampler(SamplerBindingType::Filtering);
        entries.push(kind.build(binding, ShaderStages::FRAGMENT));
        self.sampler = Some(linear_sampler(device, false));
        self
    }

    /// Reads its textures with another sampler from now on.
    pub(super) fn set_sampler(&mut self, sampler: &Sampler) {
        self.sampler = Some(sampler.clone());
    }

    /// Writes the uniform.
    pub(super) fn write(&mut self, uniform: U, graphics: &Graphics) {
        self.uniform.set(uniform);
        self.uniform.write_buffer(&graphics.device, &graphics.queue);
    }

    /// Queues the pipeline of a stage, unless it has been queued before.
    pub(super) fn queue(&mut self, stage: Stage, cache: &PipelineCache) {
        let (layout, shader) = (&self.layout, &self.shader);
        self.pipelines.entry(stage).or_insert_with(|| {
            let (entry_point, formats) = stage;
            let target = |format| {
                Some(ColorTargetState {
                    format,
                    blend: None,
                    write_mask: ColorWrites::ALL,
                })
            };
            cache.queue_render_pipeline(RenderPipelineDescriptor {
                label: Some(entry_point.into()),
                layout: vec![layout.clone()],
                vertex: VertexState {
                    shader: shader.clone(),
                    entry_point: Some("vertex".into()),
                    ..default()
                },
                fragment: Some(FragmentState {
                    shader: shader.clone(),
                    entry_point: Some(entry_point.into()),
                    targets: formats.into_iter().flatten().map(target).collect(),
                    ..default()
                }),
                ..default()
            })
        });
    }

    /// The pipeline of a stage, once it exists.
    pub(super) fn pipeline<'a>(
        &self,
        stage: Stage,
        cache: &'a PipelineCache,
    ) -> Option<&'a RenderPipeline> {
        cache.get_render_pipeline(*self.pipelines.get(&stage)?)
    }

    /// Draws a stage from `sources` to `targets`, measured under the name of its entry point.
    /// Returns whether it is drawn: its pipeline may still be compiling.
    pub(super) fn draw(
        &self,
        context: &mut RenderContext,
        cache: &PipelineCache,
        stage: Stage,
        sources: &[&TextureView],
        targets: &[Option<RenderPassColorAttachment>],
    ) -> bool {
        let (name, _) = stage;
        let (Some(pipeline), Some(uniform)) = (self.pipeline(stage, cache), self.uniform.binding())
        else {
            return false;
        };
        let textures = sources.iter().map(|source| source.into_binding());
        let sampler = self.sampler.iter().map(|sampler| sampler.into_binding());
        let resources = std::iter::once(uniform).chain(textures).chain(sampler);
        let entries: Vec<_> = (0..)
            .zip(resources)
            .map(|(binding, resource)| BindGroupEntry { binding, resource })
            .collect();
        let layout = cache.get_bind_group_layout(&self.layout);
        let device = context.render_device();
        let bind_group = device.create_bind_group(name, &layout, &entries);
        run_render_pass(context, name, targets, None, |render_pass| {
            render_pass.set_render_pipeline(pipeline);
            render_pass.set_bind_group(0, &bind_group, &[]);
            render_pass.draw(0..3, 0..1);
        });
        true
    }
}

/// What a pass draws to, whatever was there before.
pub(super) fn attachment(view: &TextureView) -> Option<RenderPassColorAttachment<'_>> {
    Some(RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: default(),
    })
}
