//! The geodesic pass: a fullscreen triangle at the far plane, so that the depth test lets only
//! uncovered pixels through.

mod pipeline;

use super::chain::Chain;
use super::{CurrentScene, SceneCamera};
use crate::render::error_map::PictureErrors;
use crate::render::redraw::DrawRequest;
use bevy::asset::AssetEventSystems;
use bevy::core_pipeline::core_3d::{main_opaque_pass_3d, main_transparent_pass_3d};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::binding_types::{uniform_buffer, uniform_buffer_sized};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::{ErrorMap, GpuScene, Variant};
use lightfall_core::optics::{disk, spectrum};
use lightfall_core::scene::View;
use pipeline::descriptor;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The shader that the current scene needs; written in the main world, where shader assets live.
#[derive(Resource, Clone, ExtractResource)]
pub(super) struct GeodesicShader {
    variant: Variant,
    /// Samples of a pixel, which a pipeline is made for.
    samples: u32,
    shader: Handle<Shader>,
    /// Whether its pipeline exists; both worlds hold it.
    ready: Arc<AtomicBool>,
}

impl GeodesicShader {
    /// Whether its pipeline exists.
    pub(super) fn is_ready(&self) -> bool {
        self.ready.load(Ordering::Acquire)
    }
}

/// The variants joined so far, so that going back to one costs nothing; the last used last.
#[derive(Resource, Default)]
pub(super) struct JoinedShaders(Vec<GeodesicShader>);

/// Most variants that are kept, each a compiled pipeline: more than keys and presets lead through
/// in a while.
const MAX_VARIANTS: usize = 48;

/// What the pass needs on the GPU.
#[derive(Resource)]
pub(super) struct GeodesicPass {
    layout: BindGroupLayoutDescriptor,
    spectrum: Buffer,
    /// The relativistic disk's flux; always bound, read by the variants that need it.
    page_thorne: Buffer,
    /// The grid of the view `error`; likewise.
    errors: Buffer,
    numbers: UniformBuffer<GpuScene>,
    pipelines: HashMap<(AssetId<Shader>, u32), CachedRenderPipelineId>,
    /// The pipeline of the scene whose numbers are in the buffer.
    current: Option<CachedRenderPipelineId>,
    /// How many samples that pipeline is made for.
    samples: u32,
    bind_group: Option<BindGroup>,
    /// Whether the scene has changed since its numbers were written.
    stale: bool,
    /// Whether this frame has drawn with them.
    drew: bool,
}

impl GeodesicPass {
    /// Whether this frame has drawn the light of the present scene.
    pub(super) fn has_drawn_scene(&self) -> bool {
        self.drew && !self.stale
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<JoinedShaders>()
        .add_plugins(ExtractResourcePlugin::<GeodesicShader>::default())
        // A shader that takes a place is to be known to the pipelines in the same frame as that it
        // is wanted.
        .add_systems(
            PostUpdate,
            join_shader
                .run_if(resource_changed::<CurrentScene>)
                .before(AssetEventSystems),
        );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, init)
        .add_systems(Render, prepare.in_set(RenderSystems::PrepareResources))
        .add_systems(
            Core3d,
            draw.in_set(Core3dSystems::MainPass)
                .after(main_opaque_pass_3d)
                .before(main_transparent_pass_3d),
        );
}

/// Joins the parts that the scene needs into one shader, once per variant. The longest unused gives
/// up its place.
pub(super) fn join_shader(
    mut commands: Commands,
    scene: Res<CurrentScene>,
    mut joined: ResMut<JoinedShaders>,
    mut shaders: ResMut<Assets<Shader>>,
) {
    let (variant, samples) = (Variant::picture(&scene), Chain::of(&scene).samples);
    let JoinedShaders(joined) = &mut *joined;
    let shader = match joined
        .iter()
        .position(|known| known.variant == variant && known.samples == samples)
    {
        Some(place) => joined.remove(place),
        None => {
            let text = Shader::from_wgsl(variant.source(), "lightfall/geodesic.wgsl");
            let shader = if joined.len() < MAX_VARIANTS {
                shaders.add(text)
            } else {
                let GeodesicShader { shader, .. } = joined.remove(0);
                if let Err(error) = shaders.insert(shader.id(), text) {
                    error!("a shader could not be replaced: {error}");
                }
                shader
            };
            GeodesicShader {
                variant,
                samples,
                shader,
                ready: default(),
            }
        }
    };
    joined.push(shader.clone());
    commands.insert_resource(shader);
}

/// A table as it lies in a uniform.
fn bytes(table: &[[f32; 4]]) -> Vec<u8> {
    table
        .iter()
        .flatten()
        .flat_map(|value| value.to_le_bytes())
        .collect()
}

fn init(mut commands: Commands, device: Res<RenderDevice>, request: Option<Res<DrawRequest>>) {
    // After the loss of a device there is no picture any more.
    if let Some(request) = request {
        request.forget();
    }
    let table = bytes(&spectrum::table());
    let spectrum = device.create_buffer_with_data(&BufferInitDescriptor {
        label: Some("spectrum table"),
        contents: &table,
        usage: BufferUsages::UNIFORM,
    });
    let uniform = |label, size: usize| {
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        device.create_buffer(&BufferDescriptor {
            label: Some(label),
            size: size as u64,
            usage,
            mapped_at_creation: false,
        })
    };
    let page_thorne = uniform(
        "Page-Thorne table",
        size_of::<[[f32; 4]; disk::TABLE_LEN]>(),
    );
    let errors = uniform("grid of errors", ErrorMap::SIZE);
    let layout = BindGroupLayoutDescriptor::new(
        "geodesic layout",
        &BindGroupLayoutEntries::with_indices(
            ShaderStages::FRAGMENT,
            (
                (0, uniform_buffer::<GpuScene>(false)),
                (
                    1,
                    uniform_buffer_sized(false, BufferSize::new(spectrum.size())),
                ),
                (
                    4,
                    uniform_buffer_sized(false, BufferSize::new(page_thorne.size())),
                ),
                (
                    5,
                    uniform_buffer_sized(false, BufferSize::new(errors.size())),
                ),
            ),
        ),
    );
    commands.insert_resource(GeodesicPass {
        layout,
        spectrum,
        page_thorne,
        errors,
        numbers: UniformBuffer::from(GpuScene::default()),
        pipelines: HashMap::default(),
        current: None,
        samples: 1,
        bind_group: None,
        stale: true,
        drew: false,
    });
}

/// Writes the scene's numbers and picks the pipeline.
fn prepare(
    scene: Res<CurrentScene>,
    shader: Option<Res<GeodesicShader>>,
    known: Res<PictureErrors>,
    pass: Option<ResMut<GeodesicPass>>,
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    let (Some(shader), Some(mut pass)) = (shader, pass) else {
        return;
    };
    let GeodesicPass {
        layout,
        spectrum,
        page_thorne,
        errors,
        numbers,
        pipelines,
        current,
        samples,
        bind_group,
        stale,
        drew,
    } = &mut *pass;
    *stale |= scene.is_changed() || known.is_changed();
    *drew = false;
    let wanted = *pipelines
        .entry((shader.shader.id(), shader.samples))
        .or_insert_with(|| {
            cache.queue_render_pipeline(descriptor(
                layout.clone(),
                shader.shader.clone(),
                shader.samples,
            ))
        });
    // A scene is not begun before its own shader is there: until then the last picture stays as it
    // was.
    let ready = cache.get_render_pipeline(wanted).is_some();
    shader.ready.store(ready, Ordering::Release);
    if !*stale || !ready {
        return;
    }
    numbers.set(scene.numbers().clone());
    numbers.write_buffer(&device, &queue);
    if let disk::Profile::PageThorne(disk) = disk::Profile::new(&scene) {
        queue.write_buffer(page_thorne, 0, &bytes(&disk.table()));
    }
    if scene.view == View::Error {
        queue.write_buffer(errors, 0, &known.cells.bytes());
    }
    (*stale, *current, *samples) = (false, Some(wanted), shader.samples);
    if bind_group.is_none()
        && let Some(numbers) = numbers.binding()
    {
        *bind_group = Some(device.create_bind_group(
            "geodesic bindings",
            &cache.get_bind_group_layout(layout),
            &BindGroupEntries::with_indices((
                (0, numbers),
                (1, spectrum.as_entire_binding()),
                (4, page_thorne.as_entire_binding()),
                (5, errors.as_entire_binding()),
            )),
        ));
    }
}

fn draw(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    pass: Option<ResMut<GeodesicPass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let Some(mut pass) = pass else { return };
    let (target, depth) = view.into_inner();
    let (Some(pipeline), Some(bind_group)) = (
        pass.current.and_then(|id| cache.get_render_pipeline(id)),
        pass.bind_group.as_ref(),
    ) else {
        return;
    };
    // A pipeline for another number of samples waits until the picture has it, too.
    if (pass.samples > 1) != target.sampled_main_texture().is_some() {
        return;
    }
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let mut render_pass = context.begin_tracked_render_pass(RenderPassDescriptor {
        label: Some("geodesic"),
        color_attachments: &[Some(target.get_color_attachment())],
        depth_stencil_attachment: Some(depth.get_attachment(StoreOp::Store)),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    let span = diagnostics.pass_span(&mut render_pass, "geodesic");
    render_pass.set_render_pipeline(pipeline);
    render_pass.set_bind_group(0, bind_group, &[]);
    render_pass.draw(0..3, 0..1);
    span.end(&mut render_pass);
    drop(render_pass);
    pass.drew = true;
}
