//! The presentation: the tone-mapped picture reduced to a grid of cells, quantized, and expanded to the output.

use super::{CurrentScene, Eye, Screen};
use crate::scene::Picture;
use bevy::asset::uuid_handle;
use bevy::core_pipeline::core_2d::main_transparent_pass_2d;
use bevy::core_pipeline::schedule::{Core2d, Core2dSystems};
use bevy::image::ToExtents;
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::render_resource::binding_types::{sampler, texture_2d, uniform_buffer};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::texture::{CachedTexture, TextureCache};
use bevy::render::view::{ExtractedView, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};

const SHADER: Handle<Shader> = uuid_handle!("6f0f7c0e-5b7d-4c0c-9a55-0f3f1c1d7a11");

/// Cells hold linear light behind the sRGB transfer function, so that every level they are rounded to survives.
const GRID_FORMAT: TextureFormat = TextureFormat::Rgba8UnormSrgb;

/// Where the picture lies on the output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letterbox {
    /// Upper left corner, in output pixels.
    pub offset: Vec2,
    /// Size, in output pixels.
    pub extent: Vec2,
}

/// Places the picture on an output of the given size, bars around it: cells at the largest whole scale that fits, or,
/// bypassed or where not even scale one fits, the whole picture as large as it can be.
pub fn letterbox(picture: &Picture, output: UVec2) -> Letterbox {
    let grid = UVec2::new(picture.grid_width, picture.grid_height);
    let scale = (output / grid).min_element();
    let extent = if !picture.bypass && scale > 0 {
        (grid * scale).as_vec2()
    } else {
        let shown = if picture.bypass { UVec2::new(picture.width, picture.height) } else { grid }.as_vec2();
        (shown * (output.as_vec2() / shown).min_element()).round().max(Vec2::ONE)
    };
    Letterbox { offset: ((output.as_vec2() - extent) / 2.0).floor(), extent }
}

/// Mirror of `Presentation` in pixelate.wgsl.
#[derive(Clone, Default, ShaderType)]
struct Presentation {
    picture: UVec2,
    grid: UVec2,
    offset: Vec2,
    extent: Vec2,
    levels: f32,
    dither: u32,
}

/// The three fragment entries.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Stage {
    Pixelate,
    Expand,
    Fit,
}

impl Stage {
    fn entry_point(self) -> &'static str {
        match self {
            Self::Pixelate => "pixelate",
            Self::Expand => "expand",
            Self::Fit => "fit",
        }
    }
}

#[derive(Resource)]
struct PresentationPass {
    layout: BindGroupLayoutDescriptor,
    sampler: Sampler,
    numbers: UniformBuffer<Presentation>,
    pipelines: HashMap<(Stage, TextureFormat), CachedRenderPipelineId>,
    /// The cells, absent when they are bypassed.
    grid: Option<CachedTexture>,
    /// Format of the screen's main texture.
    output: TextureFormat,
}

pub(super) fn plugin(app: &mut App) {
    let source = include_str!("../../shaders/pixelate.wgsl");
    if let Err(error) = app
        .world_mut()
        .resource_mut::<Assets<Shader>>()
        .insert(SHADER.id(), Shader::from_wgsl(source, "lightfall/pixelate.wgsl"))
    {
        error!("the presentation shader could not be added: {error}");
    }
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else { return };
    render_app
        .add_systems(RenderStartup, init)
        .add_systems(Render, prepare.in_set(RenderSystems::PrepareResources))
        .add_systems(
            Core2d,
            (pixelate, expand).chain().in_set(Core2dSystems::MainPass).after(main_transparent_pass_2d),
        );
}

fn init(mut commands: Commands, device: Res<RenderDevice>) {
    let layout = BindGroupLayoutDescriptor::new(
        "presentation layout",
        &BindGroupLayoutEntries::sequential(
            ShaderStages::FRAGMENT,
            (
                uniform_buffer::<Presentation>(false),
                texture_2d(TextureSampleType::Float { filterable: true }),
                sampler(SamplerBindingType::Filtering),
            ),
        ),
    );
    let sampler = device.create_sampler(&SamplerDescriptor {
        label: Some("presentation sampler"),
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..default()
    });
    commands.insert_resource(PresentationPass {
        layout,
        sampler,
        numbers: UniformBuffer::from(Presentation::default()),
        pipelines: HashMap::default(),
        grid: None,
        output: TextureFormat::Rgba8UnormSrgb,
    });
}

fn prepare(
    scene: Res<CurrentScene>,
    screen: Query<(&ExtractedCamera, &ExtractedView), With<Screen>>,
    pass: Option<ResMut<PresentationPass>>,
    mut textures: ResMut<TextureCache>,
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    let (Some(mut pass), Ok((camera, view))) = (pass, screen.single()) else { return };
    let Some(output) = camera.physical_target_size.filter(|size| size.min_element() > 0) else { return };
    let picture = scene.picture;
    let Letterbox { offset, extent } = letterbox(&picture, output);
    let grid = UVec2::new(picture.grid_width, picture.grid_height);
    pass.numbers.set(Presentation {
        picture: UVec2::new(picture.width, picture.height),
        grid,
        offset,
        extent,
        levels: picture.levels as f32,
        dither: u32::from(picture.dither),
    });
    pass.numbers.write_buffer(&device, &queue);
    pass.output = view.target_format;
    pass.grid = (!picture.bypass).then(|| {
        textures.get(
            &device,
            TextureDescriptor {
                label: Some("presentation grid"),
                size: grid.to_extents(),
                mip_level_count: 1,
                sample_count: 1,
                dimension: TextureDimension::D2,
                format: GRID_FORMAT,
                usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
                view_formats: &[],
            },
        )
    });
    let PresentationPass { layout, pipelines, output, .. } = &mut *pass;
    let stages: &[_] = if picture.bypass {
        &[(Stage::Fit, *output)]
    } else {
        &[(Stage::Pixelate, GRID_FORMAT), (Stage::Expand, *output)]
    };
    for &(stage, format) in stages {
        pipelines
            .entry((stage, format))
            .or_insert_with(|| cache.queue_render_pipeline(descriptor(layout.clone(), stage, format)));
    }
}

fn descriptor(layout: BindGroupLayoutDescriptor, stage: Stage, format: TextureFormat) -> RenderPipelineDescriptor {
    RenderPipelineDescriptor {
        label: Some(stage.entry_point().into()),
        layout: vec![layout],
        vertex: VertexState { shader: SHADER, entry_point: Some("vertex".into()), ..default() },
        fragment: Some(FragmentState {
            shader: SHADER,
            entry_point: Some(stage.entry_point().into()),
            targets: vec![Some(ColorTargetState { format, blend: None, write_mask: ColorWrites::ALL })],
            ..default()
        }),
        ..default()
    }
}

/// Picture -> cells.
fn pixelate(
    _screen: ViewQuery<&ViewTarget, With<Screen>>,
    eye: Query<&ViewTarget, With<Eye>>,
    pass: Option<Res<PresentationPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let (Some(pass), Ok(eye)) = (pass, eye.single()) else { return };
    let Some(grid) = &pass.grid else { return };
    run(&pass, &cache, &mut context, (Stage::Pixelate, GRID_FORMAT), eye.main_texture_view(), &grid.default_view);
}

/// Cells, or the picture itself when they are bypassed, -> output.
fn expand(
    screen: ViewQuery<&ViewTarget, With<Screen>>,
    eye: Query<&ViewTarget, With<Eye>>,
    pass: Option<Res<PresentationPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let screen = screen.into_inner();
    let (Some(pass), Ok(eye)) = (pass, eye.single()) else { return };
    let (stage, source) = match &pass.grid {
        Some(grid) => (Stage::Expand, &grid.default_view),
        None => (Stage::Fit, eye.main_texture_view()),
    };
    run(&pass, &cache, &mut context, (stage, pass.output), source, screen.main_texture_view());
}

fn run(
    pass: &PresentationPass,
    cache: &PipelineCache,
    context: &mut RenderContext,
    key: (Stage, TextureFormat),
    source: &TextureView,
    destination: &TextureView,
) {
    let (Some(pipeline), Some(numbers)) =
        (pass.pipelines.get(&key).and_then(|id| cache.get_render_pipeline(*id)), pass.numbers.binding())
    else {
        return;
    };
    let name = key.0.entry_point();
    let bind_group = context.render_device().create_bind_group(
        name,
        &cache.get_bind_group_layout(&pass.layout),
        &BindGroupEntries::sequential((numbers, source, &pass.sampler)),
    );
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let mut render_pass = context.begin_tracked_render_pass(RenderPassDescriptor {
        label: Some(name),
        color_attachments: &[Some(RenderPassColorAttachment {
            view: destination,
            depth_slice: None,
            resolve_target: None,
            ops: default(),
        })],
        depth_stencil_attachment: None,
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    let span = diagnostics.pass_span(&mut render_pass, name);
    render_pass.set_render_pipeline(pipeline);
    render_pass.set_bind_group(0, &bind_group, &[]);
    render_pass.draw(0..3, 0..1);
    span.end(&mut render_pass);
}
