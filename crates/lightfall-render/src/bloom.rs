//! The bloom: light that spreads around what is bright, as in an eye or a lens. Its levels cover the
//! whole picture. Where the picture is drawn part by part, each part adds its squares to the base, and
//! the levels are made when the light of the parts is given back.

mod textures;

use crate::camera_markers::SceneCamera;
use crate::chain::Chain;
use crate::comparison::ComparedScene;
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::given_light::GivenLight;
use crate::graphics::{Graphics, create_target, linear_sampler};
use crate::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::render_resource::binding_types::{sampler, texture_2d, uniform_buffer};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::Bloom;
use textures::{BASE_FORMAT, BloomTextures, LEVEL_FORMAT};

const SHADER: Handle<Shader> = uuid_handle!("3b5f4c1a-9f0d-4f43-8a57-6f0c2b9e7d31");

/// The steps: their entry points, and what they draw to.
const AVERAGE: &str = "bloom_base";
const BEGIN: &str = "bloom_first";
const SHRINK: &str = "bloom_shrink";
const SPREAD: &str = "bloom_spread";
const STEPS: [(&str, TextureFormat); 4] = [
    (AVERAGE, BASE_FORMAT),
    (BEGIN, LEVEL_FORMAT),
    (SHRINK, LEVEL_FORMAT),
    (SPREAD, LEVEL_FORMAT),
];

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(super) struct BloomPass {
    layout: BindGroupLayoutDescriptor,
    /// For pictures with edges on all sides, and for those whose columns go around.
    samplers: [Sampler; 2],
    goes_around: bool,
    uniform: UniformBuffer<Bloom>,
    /// In the order of [`STEPS`], from the first scene with bloom on.
    pipelines: Option<[CachedRenderPipelineId; STEPS.len()]>,
    /// `None` without bloom.
    textures: Option<BloomTextures>,
    /// Share of the picture's light that spreads.
    share: f64,
    /// What takes the place of the largest level without bloom.
    nothing: TextureView,
}

impl BloomPass {
    /// The largest level, or a black texel without bloom.
    pub(super) fn largest_level(&self) -> &TextureView {
        let textures = self.textures.as_ref();
        textures.map_or(&self.nothing, |textures| &textures.levels[0])
    }

    /// The sampler of the levels, whose columns go around where those of the picture do.
    pub(super) fn sampler(&self) -> &Sampler {
        &self.samplers[usize::from(self.goes_around)]
    }

    /// Whether there is bloom.
    pub(super) fn is_on(&self) -> bool {
        self.textures.is_some()
    }

    fn queue_pipelines(&mut self, cache: &PipelineCache) {
        let layout = &self.layout;
        self.pipelines.get_or_insert_with(|| {
            STEPS.map(|(step, format)| {
                // A level is mixed into the one above by shares that the pass sets.
                let mixed = BlendState {
                    color: BlendComponent {
                        src_factor: BlendFactor::Constant,
                        dst_factor: BlendFactor::OneMinusConstant,
                        operation: BlendOperation::Add,
                    },
                    alpha: BlendComponent::REPLACE,
                };
                cache.queue_render_pipeline(RenderPipelineDescriptor {
                    label: Some(step.into()),
                    layout: vec![layout.clone()],
                    vertex: VertexState {
                        shader: SHADER,
                        entry_point: Some("over_all".into()),
                        ..default()
                    },
                    fragment: Some(FragmentState {
                        shader: SHADER,
                        entry_point: Some(step.into()),
                        targets: vec![Some(ColorTargetState {
                            format,
                            blend: (step == SPREAD).then_some(mixed),
                            write_mask: ColorWrites::ALL,
                        })],
                        ..default()
                    }),
                    ..default()
                })
            })
        });
    }

    /// The pipelines, once all of them exist.
    fn ready<'a>(&self, cache: &'a PipelineCache) -> Option<[&'a RenderPipeline; STEPS.len()]> {
        let [a, b, c, d] = self.pipelines?.map(|id| cache.get_render_pipeline(id));
        Some([a?, b?, c?, d?])
    }
}

pub(super) fn plugin(app: &mut App) {
    add_shader(app, &SHADER, Bloom::shader(), "lightfall/bloom.wgsl");
    app.sub_app_mut(RenderApp)
        .add_systems(RenderStartup, create_bloom_pass)
        .add_systems(
            Render,
            prepare_bloom.in_set(RenderSystems::PrepareResources),
        )
        .add_systems(Core3d, draw_bloom.in_set(Core3dSystems::PostProcess));
}

fn create_bloom_pass(mut commands: Commands, device: Res<RenderDevice>) {
    let visibility = ShaderStages::FRAGMENT;
    let entries = [
        uniform_buffer::<Bloom>(false).build(0, visibility),
        texture_2d(TextureSampleType::Float { filterable: true }).build(1, visibility),
        sampler(SamplerBindingType::Filtering).build(2, visibility),
    ];
    commands.insert_resource(BloomPass {
        layout: BindGroupLayoutDescriptor::new("bloom layout", &entries),
        samplers: [false, true].map(|around| linear_sampler(&device, around)),
        goes_around: false,
        uniform: UniformBuffer::from(Bloom::default()),
        pipelines: None,
        textures: None,
        share: 0.0,
        nothing: create_target(&device, "no bloom", UVec2::ONE, LEVEL_FORMAT, 1),
    });
}

/// Creates the textures of the scene's bloom and writes its numbers.
fn prepare_bloom(
    (scene, part, compared): (Res<DrawnScene>, Res<DrawnPart>, Res<ComparedScene>),
    If(mut pass): If<ResMut<BloomPass>>,
    graphics: Graphics,
) {
    let pass = &mut *pass;
    let Some(levels) = Chain::of(&scene).comparing(&compared).bloom else {
        pass.textures = None;
        return;
    };
    pass.queue_pipelines(&graphics.cache);
    pass.share = scene.picture.bloom;
    pass.goes_around = scene.camera.projection.goes_around() && !compared.is_two_pictures();
    let has_base = levels.square() > 1 || part.drawn().is_some();
    let fits = |textures: &BloomTextures| textures.fits(levels, has_base);
    if !pass.textures.as_ref().is_some_and(fits) {
        pass.textures = Some(BloomTextures::new(&graphics.device, levels, has_base));
    }
    let numbers = Bloom::new(levels, part.first_pixel());
    if *pass.uniform.get() != numbers || pass.uniform.binding().is_none() {
        pass.uniform.set(numbers);
        pass.uniform.write_buffer(&graphics.device, &graphics.queue);
    }
}

/// Blurs the light of the picture.
pub(super) fn draw_bloom(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    (part, given): (Res<DrawnPart>, Res<GivenLight>),
    If(pass): If<Res<BloomPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let (Some(textures), Some(pipelines), Some(uniform)) =
        (&pass.textures, pass.ready(&cache), pass.uniform.binding())
    else {
        return;
    };
    let [average, begin, shrink, spread] = pipelines;
    let picture = view.into_inner().main_texture_view();
    let layout = cache.get_bind_group_layout(&pass.layout);
    let device = context.render_device().clone();
    let bind = |source: &TextureView| {
        let entries = BindGroupEntries::sequential((uniform.clone(), source, pass.sampler()));
        device.create_bind_group("bloom bindings", &layout, &entries)
    };
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let encoder = context.command_encoder();
    let span = diagnostics.time_span(encoder, "bloom");
    let source = textures.base.as_ref().unwrap_or(picture);
    // The squares of parts whose light is given back are in the base already.
    if let Some(base) = &textures.base
        && (given.is_none() || part.drawn().is_none())
    {
        let mut step = begin_step(encoder, base, LoadOp::Load);
        let texels = textures.texels_of(part.wanted());
        step.set_scissor_rect(texels.min.x, texels.min.y, texels.width(), texels.height());
        step.set_pipeline(average);
        step.set_bind_group(0, &bind(picture), &[]);
        step.draw(0..3, 0..1);
    }
    // While parts of the picture are missing, the base is not complete.
    if part.drawn().is_none() || given.is_some() {
        let clear = || LoadOp::Clear(default());
        let sources = std::iter::once(source).chain(&textures.levels);
        for (i, (source, level)) in sources.zip(&textures.levels).enumerate() {
            let mut step = begin_step(encoder, level, clear());
            step.set_pipeline(if i == 0 { begin } else { shrink });
            step.set_bind_group(0, &bind(source), &[]);
            step.draw(0..3, 0..1);
        }
        let pairs = textures.levels.windows(2).enumerate().rev();
        for (i, pair) in pairs {
            let share = textures.layout.share(i as u32 + 1, pass.share);
            let mut step = begin_step(encoder, &pair[0], LoadOp::Load);
            step.set_pipeline(spread);
            step.set_bind_group(0, &bind(&pair[1]), &[]);
            step.set_blend_constant(LinearRgba::gray(share as f32).into());
            step.draw(0..3, 0..1);
        }
    }
    span.end(encoder);
}

/// Begins a step that draws to a texture.
fn begin_step<'a>(
    encoder: &'a mut CommandEncoder,
    target: &TextureView,
    load: LoadOp<wgpu::Color>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&RenderPassDescriptor {
        label: Some("bloom"),
        color_attachments: &[Some(RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: Operations {
                load,
                store: StoreOp::Store,
            },
        })],
        depth_stencil_attachment: None,
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    })
}
