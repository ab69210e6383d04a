//! The presentation: the tone-mapped picture reduced to a grid of cells, quantized, and expanded to
//! the output.

use super::{Chain, CurrentScene, SceneCamera, Screen};
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
use bevy::render::view::{ExtractedView, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::scene::Picture;

const SHADER: Handle<Shader> = uuid_handle!("6f0f7c0e-5b7d-4c0c-9a55-0f3f1c1d7a11");

/// Cells hold linear light behind the sRGB transfer function, so that every level they are rounded
/// to survives.
const GRID_FORMAT: TextureFormat = TextureFormat::Rgba8UnormSrgb;

/// Where the picture lies on the output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letterbox {
    /// Upper left corner, in output pixels.
    pub offset: Vec2,
    /// Size, in output pixels.
    pub extent: Vec2,
}

/// Places the picture on an output of the given size, bars around it: cells at the largest whole
/// scale that fits, or, bypassed or where not even scale one fits, the whole picture as large as it
/// can be.
pub fn letterbox(picture: &Picture, output: UVec2) -> Letterbox {
    let grid = UVec2::new(picture.grid_width, picture.grid_height);
    let scale = (output / grid).min_element();
    let extent = if !picture.bypass && scale > 0 {
        (grid * scale).as_vec2()
    } else {
        let shown = if picture.bypass {
            UVec2::new(picture.width, picture.height)
        } else {
            grid
        }
        .as_vec2();
        (shown * (output.as_vec2() / shown).min_element())
            .round()
            .max(Vec2::ONE)
    };
    Letterbox {
        offset: ((output.as_vec2() - extent) / 2.0).floor(),
        extent,
    }
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

/// The presentation grid, and what it was filled with.
struct Cells {
    view: TextureView,
    /// Size, levels and pattern.
    numbers: (UVec2, f32, u32),
    /// Whether they show the eye's last picture.
    filled: bool,
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
    /// The cells, absent when they are bypassed; kept as long as the picture is.
    cells: Option<Cells>,
    /// Format of the screen's main texture.
    output: TextureFormat,
}

pub(super) fn plugin(app: &mut App) {
    let source = include_str!("../../shaders/pixelate.wgsl");
    if let Err(error) = app.world_mut().resource_mut::<Assets<Shader>>().insert(
        SHADER.id(),
        Shader::from_wgsl(source, "lightfall/pixelate.wgsl"),
    ) {
        error!("the presentation shader could not be added: {error}");
    }
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, init)
        .add_systems(Render, prepare.in_set(RenderSystems::PrepareResources))
        .add_systems(
            Core2d,
            (pixelate, expand)
                .chain()
                .in_set(Core2dSystems::MainPass)
                .after(main_transparent_pass_2d),
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
        cells: None,
        output: TextureFormat::Rgba8UnormSrgb,
    });
}

fn prepare(
    scene: Res<CurrentScene>,
    screen: Query<(&ExtractedCamera, &ExtractedView), With<Screen>>,
    eye: Query<(&ViewTarget, Has<ExtractedCamera>), With<SceneCamera>>,
    pass: Option<ResMut<PresentationPass>>,
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    let (Some(mut pass), Ok((camera, view)), Ok((eye, awake))) =
        (pass, screen.single(), eye.single())
    else {
        return;
    };
    let Some(output) = camera
        .physical_target_size
        .filter(|size| size.min_element() > 0)
    else {
        return;
    };
    // The picture at hand may be a kept one, of another size than the scene asks for by now.
    let size = eye.main_texture().size();
    let picture = Picture {
        width: size.width,
        height: size.height,
        ..scene.picture
    };
    let Letterbox { offset, extent } = letterbox(&picture, output);
    let numbers = Presentation {
        picture: UVec2::new(picture.width, picture.height),
        grid: UVec2::new(picture.grid_width, picture.grid_height),
        offset,
        extent,
        levels: picture.levels as f32,
        dither: u32::from(picture.dither),
    };
    pass.output = view.target_format;
    pass.cells = Chain::of(&scene).cells.map(|size| {
        let numbers = (size, numbers.levels, numbers.dither);
        match pass.cells.take() {
            Some(cells) if cells.numbers == numbers => Cells {
                filled: cells.filled && !awake,
                ..cells
            },
            Some(cells) if cells.numbers.0 == size => Cells {
                numbers,
                filled: false,
                ..cells
            },
            _ => Cells {
                view: grid(&device, size),
                numbers,
                filled: false,
            },
        }
    });
    pass.numbers.set(numbers);
    pass.numbers.write_buffer(&device, &queue);
    let PresentationPass {
        layout,
        pipelines,
        output,
        ..
    } = &mut *pass;
    let stages: &[_] = if picture.bypass {
        &[(Stage::Fit, *output)]
    } else {
        &[(Stage::Pixelate, GRID_FORMAT), (Stage::Expand, *output)]
    };
    for &(stage, format) in stages {
        pipelines.entry((stage, format)).or_insert_with(|| {
            cache.queue_render_pipeline(descriptor(layout.clone(), stage, format))
        });
    }
}

fn grid(device: &RenderDevice, size: UVec2) -> TextureView {
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

fn descriptor(
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

/// Picture -> cells; a kept picture's are there already.
fn pixelate(
    _screen: ViewQuery<&ViewTarget, With<Screen>>,
    eye: Query<&ViewTarget, With<SceneCamera>>,
    pass: Option<ResMut<PresentationPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let (Some(mut pass), Ok(eye)) = (pass, eye.single()) else {
        return;
    };
    let Some(Cells {
        view,
        filled: false,
        ..
    }) = &pass.cells
    else {
        return;
    };
    let filled = run(
        &pass,
        &cache,
        &mut context,
        (Stage::Pixelate, GRID_FORMAT),
        eye.main_texture_view(),
        view,
    );
    if let Some(cells) = &mut pass.cells {
        cells.filled = filled;
    }
}

/// Cells, or the picture itself when they are bypassed, -> output.
fn expand(
    screen: ViewQuery<&ViewTarget, With<Screen>>,
    eye: Query<&ViewTarget, With<SceneCamera>>,
    pass: Option<Res<PresentationPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let screen = screen.into_inner();
    let (Some(pass), Ok(eye)) = (pass, eye.single()) else {
        return;
    };
    let (stage, source) = match &pass.cells {
        Some(cells) => (Stage::Expand, &cells.view),
        None => (Stage::Fit, eye.main_texture_view()),
    };
    run(
        &pass,
        &cache,
        &mut context,
        (stage, pass.output),
        source,
        screen.main_texture_view(),
    );
}

/// Draws one stage, and says whether it could: its pipeline may still be in the making.
fn run(
    pass: &PresentationPass,
    cache: &PipelineCache,
    context: &mut RenderContext,
    key: (Stage, TextureFormat),
    source: &TextureView,
    destination: &TextureView,
) -> bool {
    let (Some(pipeline), Some(numbers)) = (
        pass.pipelines
            .get(&key)
            .and_then(|id| cache.get_render_pipeline(*id)),
        pass.numbers.binding(),
    ) else {
        return false;
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
    true
}
