//! The geodesic pass: a full-screen triangle at the far plane. The depth test discards the pixels
//! that the foreground covers. Two compared scenes are drawn side by side in the same pass, or each
//! in a texture of its own.

mod pipeline;
mod shader;
mod side;
mod sky;

use crate::render::antialias::{AntialiasPass, prepare_antialias};

pub(crate) use shader::GeodesicShaders;
pub(super) use shader::{JoinedShaders, select_geodesic_shaders};

use crate::render::camera_markers::SceneCamera;
use crate::render::comparison::{
    ComparedScene, Comparison, ComparisonLayout, DifferencePass, draw_difference,
    follow_current_scene, prepare_difference,
};
use crate::render::current_scene::CurrentScene;
use crate::render::draw_request::DrawRequest;
use crate::render::error_map::ShownErrorMap;
use crate::render::full_screen_pass::run_full_screen_pass;
use crate::render::live_shaders::LiveShaders;
use crate::render::star_catalogue::StarCatalogue;
use crate::render::star_limit::StarLimit;
use crate::render::stars::{SceneStars, StarPass};
use crate::render::wave_limit::WaveLimit;
use bevy::asset::AssetEventSystems;
use bevy::core_pipeline::core_3d::{main_opaque_pass_3d, main_transparent_pass_3d};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_phase::TrackedRenderPass;
use bevy::render::render_resource::binding_types::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::kernel::table_bytes;
use lightfall_core::gpu::{
    ErrorMap, GpuHotSpot, GpuScene, GpuStarlight, GpuStructure, GpuTilt, SkyTexture, bands,
    bindings,
};
use lightfall_core::optics::spectrum;
use lightfall_core::scene::View;
use pipeline::{Destination, Traits, pipeline_descriptor};
use shader::{JoinedShader, SceneShaders};
use side::{PAGE_THORNE_SIZE, Shared, Side, SidePipelines, SideWriter};
use sky::NoStars;
use std::ops::Range;

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

    /// The columns of a picture of this width that show the pinned scene and the current one.
    fn columns(&self, width: u32) -> [Range<u32>; 2] {
        let divider = match self.pinned {
            Some((_, ComparisonLayout::SideBySide { columns })) => columns.min(width),
            _ => 0,
        };
        [0..divider, divider..width]
    }

    /// The stars of the scenes.
    pub(super) fn scene_stars(&self) -> impl Iterator<Item = &SceneStars> {
        let pinned = self.pinned.as_ref().map(|(side, _)| side);
        let sides = pinned.into_iter().chain([&self.current]);
        sides.filter_map(Side::stars)
    }

    /// What refines the scenes that this frame has drawn, and the columns of each.
    pub(super) fn refinements<'a>(
        &'a self,
        cache: &'a PipelineCache,
        width: u32,
    ) -> impl Iterator<Item = (&'a ComputePipeline, &'a BindGroup, Range<u32>)> {
        let [left, right] = self.columns(width);
        let pinned = self.pinned.as_ref().map(|(side, _)| (side, left));
        pinned
            .into_iter()
            .chain([(&self.current, right)])
            .filter(move |(_, columns)| self.drawn && !columns.is_empty())
            .filter_map(|(side, columns)| {
                let (pipeline, bind_group) = side.refinement(cache)?;
                Some((pipeline, bind_group, columns))
            })
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
                .run_if(
                    resource_changed::<CurrentScene>
                        .or_eager(resource_changed::<Comparison>)
                        .or_eager(resource_changed::<LiveShaders>),
                )
                .before(AssetEventSystems),
        );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, create_geodesic_pass)
        .add_systems(
            Render,
            (prepare_difference, prepare_antialias, prepare_geodesic_pass)
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

fn create_geodesic_pass(
    mut commands: Commands,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
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
            ShaderStages::FRAGMENT | ShaderStages::COMPUTE,
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
                (bindings::TILT, uniform_buffer::<GpuTilt>(false)),
                (bindings::STARLIGHT, uniform_buffer::<GpuStarlight>(false)),
                (
                    bindings::MILKY_WAY,
                    texture_cube(TextureSampleType::Float { filterable: true }),
                ),
                (
                    bindings::MILKY_WAY_SAMPLER,
                    sampler(SamplerBindingType::Filtering),
                ),
                (
                    bindings::STAR_SUMS,
                    storage_buffer_read_only_sized(false, None),
                ),
            ),
        ),
    );
    let no_stars = NoStars::new(&device, &queue);
    commands.insert_resource(GeodesicPass {
        shared: Shared {
            layout,
            spectrum,
            error_map,
            waves: WaveLimit::default(),
            no_stars,
            milky_way: None,
            sampler: device.create_sampler(&SkyTexture::sampler()),
        },
        current: Side::new(&device),
        pinned: None,
        pipelines: HashMap::default(),
        destination: Destination::Light,
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
    (waves, request): (Res<WaveLimit>, Option<Res<DrawRequest>>),
    (catalogue, star_limit): (Res<StarCatalogue>, Res<StarLimit>),
    (pass, difference, antialias, stars): (
        Option<ResMut<GeodesicPass>>,
        Option<Res<DifferencePass>>,
        Option<ResMut<AntialiasPass>>,
        Option<ResMut<StarPass>>,
    ),
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    let (Some(shaders), Some(mut pass), Some(mut antialias), Some(mut stars)) =
        (shaders, pass, antialias, stars)
    else {
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
    *changed |= scene.is_changed()
        || shaders.is_changed()
        || errors.is_changed()
        || compared.is_changed()
        || waves.is_changed()
        || star_limit.is_changed();
    *drawn = false;
    shared.waves = *waves;
    let reloads = shaders.reloads;
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
    let finds_edges = antialias.finds_edges(&cache);
    let mut refinement_of = |joined: &JoinedShader| {
        let id = antialias.refinement(&shared.layout, &joined.shader, &cache);
        let ready = cache.get_compute_pipeline(id).is_some() && finds_edges;
        joined.set_ready(ready);
        ready.then_some(id)
    };
    let mut stars_of = |SceneShaders {
                            picture,
                            stars: kernels,
                            ..
                        }: &SceneShaders| {
        let shaders = kernels
            .iter()
            .filter_map(|joined| Some((joined.star_kernel()?, &joined.shader)));
        let pipelines = stars.pipelines(shaders, picture.projection(), reloads, &cache);
        let ready = pipelines.are_ready(&cache);
        for joined in kernels {
            joined.set_ready(ready);
        }
        ready.then_some(pipelines)
    };
    // All pipelines of a scene are asked for at the same time. `None` until they exist.
    let mut pipelines_of = |shaders: &SceneShaders| {
        let picture = pipeline_of(&shaders.picture);
        let refine = shaders.refine.as_ref().map(&mut refinement_of);
        let stars = (!shaders.stars.is_empty()).then(|| stars_of(shaders));
        Some(SidePipelines {
            picture: picture?,
            refine: refine.map_or(Some(None), |refine| refine.map(Some))?,
            stars: stars.map_or(Some(None), |stars| stars.map(Some))?,
        })
    };
    let current_pipelines = pipelines_of(&shaders.current);
    let pinned_pipelines = shaders.pinned.as_ref().map(&mut pipelines_of);
    // The number of the frame, and of all frames that are averaged.
    let frame = request.and_then(|request| {
        let frame = request.averaged_frame()?;
        Some((frame, request.averaged_frames()))
    });
    let frame = frame.unwrap_or((0, 1));
    if !*changed {
        current.set_frame(frame, &device, &queue);
        if let Some((side, _)) = pinned {
            side.set_frame(frame, &device, &queue);
        }
    }
    // Until all pipelines exist, the scenes and the pipelines of the last picture stay.
    let (true, Some(current_pipelines)) = (*changed, current_pipelines) else {
        return;
    };
    let pinned_pipelines = match pinned_pipelines {
        Some(None) => return,
        None => None,
        Some(ready) => ready,
    };
    let mut writer = SideWriter {
        shared,
        stars: &mut stars,
        catalogue: *catalogue,
        star_limit: *star_limit,
        frame,
        cache: &cache,
        device: &device,
        queue: &queue,
    };
    current.write(&scene, current_pipelines, &mut writer);
    *pinned = match (compared.drawn(), pinned_pipelines) {
        (Some((scene, layout)), Some(pipelines)) => {
            let mut side = pinned
                .take()
                .map_or_else(|| Side::new(&device), |(side, _)| side);
            side.write(scene, pipelines, &mut writer);
            Some((side, layout))
        }
        _ => None,
    };
    if scene.view == View::Error {
        queue.write_buffer(&shared.error_map, 0, &errors.map.bytes());
    }
    (*changed, *destination) = (false, shaders.current.picture.destination);
}

fn draw_geodesic_pass(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    pass: Option<ResMut<GeodesicPass>>,
    (difference, antialias): (Option<Res<DifferencePass>>, Option<Res<AntialiasPass>>),
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
        (Destination::Light, None) | (Destination::Compute(_), _) => false,
        // A pipeline for another number of samples waits until the target has as many.
        (Destination::Picture { samples, .. }, _)
            if (samples > 1) != target.sampled_main_texture().is_some() =>
        {
            false
        }
        (Destination::Picture { traits, .. }, _) => {
            let second = antialias.as_ref().and_then(|pass| pass.attachment(target));
            // So does a pipeline with a second target.
            (traits == Traits::Absent || second.is_some())
                && draw_picture(
                    &mut context,
                    &cache,
                    &pass,
                    (target, second.filter(|_| traits != Traits::Absent)),
                    depth,
                )
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
    (target, second): (&ViewTarget, Option<RenderPassColorAttachment>),
    depth: &ViewDepthTexture,
) -> bool {
    let Some(current) = pass.current.ready(cache) else {
        return false;
    };
    let pinned = match &pass.pinned {
        Some((side, ComparisonLayout::SideBySide { .. })) => {
            let Some(ready) = side.ready(cache) else {
                return false;
            };
            Some(ready)
        }
        _ => None,
    };
    let size = target.main_texture().size();
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let attachments: Vec<_> = [Some(target.get_color_attachment())]
        .into_iter()
        .chain(second.map(Some))
        .collect();
    let mut render_pass = context.begin_tracked_render_pass(RenderPassDescriptor {
        label: Some("geodesic"),
        color_attachments: &attachments,
        depth_stencil_attachment: Some(depth.get_attachment(StoreOp::Store)),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    let span = diagnostics.pass_span(&mut render_pass, "geodesic");
    let [left, right] = pass.columns(size.width);
    let pinned = pinned.map(|ready| (ready, left));
    for ((pipeline, bind_group, most), columns) in pinned.into_iter().chain([(current, right)]) {
        if columns.is_empty() {
            continue;
        }
        // Not a scissor rectangle: some drivers let its edge cut through the samples of a pixel.
        let (left, width) = (columns.start as f32, columns.len() as f32);
        render_pass.set_viewport(left, 0.0, width, size.height as f32, 0.0, 1.0);
        render_pass.set_render_pipeline(pipeline);
        render_pass.set_bind_group(0, bind_group, &[]);
        draw_in_bands(&mut render_pass, UVec2::new(size.width, size.height), most);
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
    let Some((pipeline, bind_group, most)) = side.ready(cache) else {
        return false;
    };
    let target = RenderPassColorAttachment {
        view: texture,
        depth_slice: None,
        resolve_target: None,
        ops: default(),
    };
    run_full_screen_pass(context, name, target, pipeline, bind_group, |render_pass| {
        draw_in_bands(render_pass, size, most);
    });
    true
}

/// Draws the triangle band by band on a target of this size, with at most `most` pixels a band.
fn draw_in_bands(render_pass: &mut TrackedRenderPass, size: UVec2, most: u32) {
    for (top, rows) in bands(size.x, size.y, most) {
        render_pass.set_scissor_rect(0, top, size.x, rows);
        render_pass.draw(0..3, 0..1);
    }
}
