//! The geodesic pass: a full-screen triangle at the far plane. The depth test discards the pixels
//! that the foreground covers. Two compared scenes are drawn side by side in the same pass, or each
//! in a texture of its own.

mod pipeline;
mod shader;
mod side;

pub(crate) use shader::GeodesicShaders;
pub(super) use shader::select_geodesic_shaders;

use crate::render::camera_markers::SceneCamera;
use crate::render::comparison::{
    ComparedScene, Comparison, ComparisonLayout, DifferencePass, draw_difference,
    follow_current_scene, prepare_difference,
};
use crate::render::current_scene::CurrentScene;
use crate::render::error_map::ShownErrorMap;
use crate::render::full_screen_pass::run_full_screen_pass;
use crate::render::wave_limit::WaveLimit;
use bevy::asset::AssetEventSystems;
use bevy::core_pipeline::core_3d::{main_opaque_pass_3d, main_transparent_pass_3d};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_phase::TrackedRenderPass;
use bevy::render::render_resource::binding_types::{uniform_buffer, uniform_buffer_sized};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::kernel::table_bytes;
use lightfall_core::gpu::{ErrorMap, GpuHotSpot, GpuScene, GpuStructure, bindings};
use lightfall_core::optics::spectrum;
use lightfall_core::scene::View;
use pipeline::{Destination, pipeline_descriptor};
use shader::{JoinedShader, JoinedShaders};
use side::{PAGE_THORNE_SIZE, Shared, Side};

/// Most pixels that one draw call traces: a full HD picture.
const MAX_BAND_PIXELS: u32 = 1920 * 1080;

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(super) struct GeodesicPass {
    shared: Shared,
    current: Side,
    /// The pinned scene, and where the two are drawn; `None` while nothing is compared.
    pinned: Option<(Side, ComparisonLayout)>,
    /// The pipelines queued so far, by shader and what they draw to.
    pipelines: HashMap<(AssetId<Shader>, Destination), CachedRenderPipelineId>,
    /// What the pipelines of the written scenes draw to.
    destination: Destination,
    /// Whether a scene has changed since it was written.
    changed: bool,
    /// Whether this frame has drawn the written scenes.
    drawn: bool,
}

impl GeodesicPass {
    /// Whether this frame has drawn the present scenes.
    pub(super) fn has_drawn_scene(&self) -> bool {
        self.drawn && !self.changed
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<JoinedShaders>()
        .add_plugins(ExtractResourcePlugin::<GeodesicShaders>::default())
        // Before asset events, so that the pipeline cache knows a new or replaced shader in the
        // same frame.
        .add_systems(
            PostUpdate,
            (follow_current_scene, select_geodesic_shaders)
                .chain()
                .run_if(resource_changed::<CurrentScene>.or_eager(resource_changed::<Comparison>))
                .before(AssetEventSystems),
        );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, create_geodesic_pass)
        .add_systems(
            Render,
            (prepare_difference, prepare_geodesic_pass)
                .chain()
                .in_set(RenderSystems::PrepareResources),
        )
        .add_systems(
            Core3d,
            (draw_geodesic_pass, draw_difference)
                .chain()
                .in_set(Core3dSystems::MainPass)
                .after(main_opaque_pass_3d)
                .before(main_transparent_pass_3d),
        );
}

fn create_geodesic_pass(mut commands: Commands, device: Res<RenderDevice>) {
    let table = table_bytes(&spectrum::table());
    let spectrum = device.create_buffer_with_data(&BufferInitDescriptor {
        label: Some("spectrum table"),
        contents: &table,
        usage: BufferUsages::UNIFORM,
    });
    let error_map = device.create_buffer(&BufferDescriptor {
        label: Some("error map"),
        size: ErrorMap::SIZE as u64,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let layout = BindGroupLayoutDescriptor::new(
        "geodesic layout",
        &BindGroupLayoutEntries::with_indices(
            ShaderStages::FRAGMENT,
            (
                (bindings::SCENE, uniform_buffer::<GpuScene>(false)),
                (
                    bindings::SPECTRUM,
                    uniform_buffer_sized(false, BufferSize::new(spectrum.size())),
                ),
                (
                    bindings::PAGE_THORNE,
                    uniform_buffer_sized(false, BufferSize::new(PAGE_THORNE_SIZE)),
                ),
                (
                    bindings::ERROR_MAP,
                    uniform_buffer_sized(false, BufferSize::new(error_map.size())),
                ),
                (
                    bindings::STRUCTURE,
                    uniform_buffer_sized(false, BufferSize::new(GpuStructure::SIZE)),
                ),
                (bindings::HOT_SPOT, uniform_buffer::<GpuHotSpot>(false)),
            ),
        ),
    );
    commands.insert_resource(GeodesicPass {
        shared: Shared {
            layout,
            spectrum,
            error_map,
            waves: WaveLimit::default(),
        },
        current: Side::new(&device),
        pinned: None,
        pipelines: HashMap::default(),
        destination: Destination::Picture { samples: 1 },
        changed: true,
        drawn: false,
    });
}

/// Writes changed scenes once their pipelines exist.
fn prepare_geodesic_pass(
    scene: Res<CurrentScene>,
    compared: Res<ComparedScene>,
    shaders: Option<Res<GeodesicShaders>>,
    errors: Res<ShownErrorMap>,
    waves: Res<WaveLimit>,
    (pass, difference): (Option<ResMut<GeodesicPass>>, Option<Res<DifferencePass>>),
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    let (Some(shaders), Some(mut pass)) = (shaders, pass) else {
        return;
    };
    let GeodesicPass {
        shared,
        current,
        pinned,
        pipelines,
        destination,
        changed,
        drawn,
    } = &mut *pass;
    *changed |=
        scene.is_changed() || errors.is_changed() || compared.is_changed() || waves.is_changed();
    *drawn = false;
    shared.waves = *waves;
    let shows_difference = difference.is_some_and(|pass| pass.is_ready(&cache));
    let mut pipeline_of = |joined: &JoinedShader| {
        let id = *pipelines
            .entry((joined.shader.id(), joined.destination))
            .or_insert_with(|| {
                cache.queue_render_pipeline(pipeline_descriptor(
                    shared.layout.clone(),
                    joined.shader.clone(),
                    joined.destination,
                ))
            });
        let ready = cache.get_render_pipeline(id).is_some()
            && (joined.destination != Destination::Light || shows_difference);
        joined.set_ready(ready);
        ready.then_some(id)
    };
    let current_pipeline = pipeline_of(&shaders.current);
    let pinned_pipeline = shaders.pinned.as_ref().map(&mut pipeline_of);
    // Until all pipelines exist, the scenes and the pipelines of the last picture stay.
    let (true, Some(current_pipeline)) = (*changed, current_pipeline) else {
        return;
    };
    let pinned_pipeline = match pinned_pipeline {
        Some(None) => return,
        None => None,
        Some(ready) => ready,
    };
    let gpu = (&*cache, &*device, &*queue);
    current.write(&scene, current_pipeline, shared, gpu);
    *pinned = match (compared.drawn(), pinned_pipeline) {
        (Some((scene, layout)), Some(pipeline)) => {
            let mut side = pinned
                .take()
                .map_or_else(|| Side::new(&device), |(side, _)| side);
            side.write(scene, pipeline, shared, gpu);
            Some((side, layout))
        }
        _ => None,
    };
    if scene.view == View::Error {
        queue.write_buffer(&shared.error_map, 0, &errors.map.bytes());
    }
    (*changed, *destination) = (false, shaders.current.destination);
}

fn draw_geodesic_pass(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    pass: Option<ResMut<GeodesicPass>>,
    difference: Option<Res<DifferencePass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let Some(mut pass) = pass else { return };
    let (target, depth) = view.into_inner();
    let drawn = match (pass.destination, &pass.pinned) {
        (Destination::Light, Some((pinned, _))) => {
            let lights = difference.as_ref().and_then(|pass| pass.lights());
            lights.is_some_and(|lights| {
                draw_light(
                    &mut context,
                    &cache,
                    "geodesic",
                    &pass.current,
                    (&lights.current, lights.size),
                ) && draw_light(
                    &mut context,
                    &cache,
                    "geodesic_pinned",
                    pinned,
                    (&lights.pinned, lights.size),
                )
            })
        }
        (Destination::Light, None) => false,
        // A pipeline for another number of samples waits until the target has as many.
        (Destination::Picture { samples }, _)
            if (samples > 1) != target.sampled_main_texture().is_some() =>
        {
            false
        }
        (Destination::Picture { .. }, _) => {
            draw_picture(&mut context, &cache, &pass, target, depth)
        }
    };
    pass.drawn = drawn;
}

/// Draws the current scene to the picture, and the pinned one left of the divider. Returns whether
/// all is drawn.
fn draw_picture(
    context: &mut RenderContext,
    cache: &PipelineCache,
    pass: &GeodesicPass,
    target: &ViewTarget,
    depth: &ViewDepthTexture,
) -> bool {
    let Some(current) = pass.current.ready(cache) else {
        return false;
    };
    let pinned = match &pass.pinned {
        Some((side, ComparisonLayout::SideBySide { columns })) => {
            let Some(ready) = side.ready(cache) else {
                return false;
            };
            Some((ready, *columns))
        }
        _ => None,
    };
    let size = target.main_texture().size();
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
    let divider = pinned.map_or(0, |(_, columns)| columns.min(size.width));
    let left = pinned.map(|(ready, _)| (ready, 0..divider));
    for ((pipeline, bind_group), columns) in
        left.into_iter().chain([(current, divider..size.width)])
    {
        if columns.is_empty() {
            continue;
        }
        // Not a scissor rectangle: some drivers let its edge cut through the samples of a pixel.
        let (left, width) = (columns.start as f32, columns.len() as f32);
        render_pass.set_viewport(left, 0.0, width, size.height as f32, 0.0, 1.0);
        render_pass.set_render_pipeline(pipeline);
        render_pass.set_bind_group(0, bind_group, &[]);
        draw_in_bands(&mut render_pass, UVec2::new(size.width, size.height));
    }
    span.end(&mut render_pass);
    true
}

/// Draws one scene to a texture of its own. Returns whether it is drawn.
fn draw_light(
    context: &mut RenderContext,
    cache: &PipelineCache,
    name: &'static str,
    side: &Side,
    (texture, size): (&TextureView, UVec2),
) -> bool {
    let Some((pipeline, bind_group)) = side.ready(cache) else {
        return false;
    };
    let target = RenderPassColorAttachment {
        view: texture,
        depth_slice: None,
        resolve_target: None,
        ops: default(),
    };
    run_full_screen_pass(context, name, target, pipeline, bind_group, |render_pass| {
        draw_in_bands(render_pass, size);
    });
    true
}

/// Draws the triangle band by band on a target of this size.
fn draw_in_bands(render_pass: &mut TrackedRenderPass, size: UVec2) {
    for (top, rows) in bands(size.x, size.y) {
        render_pass.set_scissor_rect(0, top, size.x, rows);
        render_pass.draw(0..3, 0..1);
    }
}

/// The first row and the number of rows of each band that is drawn by one call. A driver ends a
/// device that does not respond for some seconds, and between two calls every device does.
fn bands(width: u32, height: u32) -> impl Iterator<Item = (u32, u32)> {
    let rows = (MAX_BAND_PIXELS / width.max(1)).max(1);
    (0..height)
        .step_by(rows as usize)
        .map(move |top| (top, rows.min(height - top)))
}
