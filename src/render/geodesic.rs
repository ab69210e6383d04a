//! The geodesic pass: a full-screen triangle at the far plane. The depth test discards the pixels
//! that the foreground covers.

mod pipeline;
mod shader;

pub(super) use shader::{GeodesicShader, select_geodesic_shader};

use crate::render::camera_markers::SceneCamera;
use crate::render::current_scene::CurrentScene;
use crate::render::error_map::ShownErrorMap;
use bevy::asset::AssetEventSystems;
use bevy::core_pipeline::core_3d::{main_opaque_pass_3d, main_transparent_pass_3d};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_resource::binding_types::{uniform_buffer, uniform_buffer_sized};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::{ErrorMap, GpuScene, bindings};
use lightfall_core::optics::{disk, spectrum};
use lightfall_core::scene::View;
use pipeline::pipeline_descriptor;
use shader::JoinedShaders;

/// Most pixels that one draw call traces: a full HD picture.
const MAX_BAND_PIXELS: u32 = 1920 * 1080;

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(super) struct GeodesicPass {
    layout: BindGroupLayoutDescriptor,
    spectrum: Buffer,
    /// The relativistic disk's flux. Always bound; only the variants that need it read it.
    page_thorne: Buffer,
    /// The map of the view `error`. Always bound; only that view reads it.
    error_map: Buffer,
    uniform: UniformBuffer<GpuScene>,
    /// The pipelines queued so far, by shader and samples per pixel.
    pipelines: HashMap<(AssetId<Shader>, u32), CachedRenderPipelineId>,
    /// The pipeline of the scene in the uniform.
    current: Option<CachedRenderPipelineId>,
    /// Samples per pixel of that pipeline.
    samples: u32,
    bind_group: Option<BindGroup>,
    /// Whether the scene has changed since the uniform was written.
    changed: bool,
    /// Whether this frame has drawn the scene in the uniform.
    drawn: bool,
}

impl GeodesicPass {
    /// Whether this frame has drawn the present scene.
    pub(super) fn has_drawn_scene(&self) -> bool {
        self.drawn && !self.changed
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<JoinedShaders>()
        .add_plugins(ExtractResourcePlugin::<GeodesicShader>::default())
        // Before asset events, so that the pipeline cache knows a new or replaced shader in the
        // same frame.
        .add_systems(
            PostUpdate,
            select_geodesic_shader
                .run_if(resource_changed::<CurrentScene>)
                .before(AssetEventSystems),
        );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, create_geodesic_pass)
        .add_systems(
            Render,
            prepare_geodesic_pass.in_set(RenderSystems::PrepareResources),
        )
        .add_systems(
            Core3d,
            draw_geodesic_pass
                .in_set(Core3dSystems::MainPass)
                .after(main_opaque_pass_3d)
                .before(main_transparent_pass_3d),
        );
}

/// The bytes of a table in a uniform.
fn table_bytes(table: &[[f32; 4]]) -> Vec<u8> {
    table
        .iter()
        .flatten()
        .flat_map(|value| value.to_le_bytes())
        .collect()
}

fn create_geodesic_pass(mut commands: Commands, device: Res<RenderDevice>) {
    let table = table_bytes(&spectrum::table());
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
    let error_map = uniform("error map", ErrorMap::SIZE);
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
                    uniform_buffer_sized(false, BufferSize::new(page_thorne.size())),
                ),
                (
                    bindings::ERROR_MAP,
                    uniform_buffer_sized(false, BufferSize::new(error_map.size())),
                ),
            ),
        ),
    );
    commands.insert_resource(GeodesicPass {
        layout,
        spectrum,
        page_thorne,
        error_map,
        uniform: UniformBuffer::from(GpuScene::default()),
        pipelines: HashMap::default(),
        current: None,
        samples: 1,
        bind_group: None,
        changed: true,
        drawn: false,
    });
}

/// Writes a changed scene to the uniform once its pipeline exists.
fn prepare_geodesic_pass(
    scene: Res<CurrentScene>,
    shader: Option<Res<GeodesicShader>>,
    errors: Res<ShownErrorMap>,
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
        error_map,
        uniform,
        pipelines,
        current,
        samples,
        bind_group,
        changed,
        drawn,
    } = &mut *pass;
    *changed |= scene.is_changed() || errors.is_changed();
    *drawn = false;
    let wanted = *pipelines
        .entry((shader.shader.id(), shader.samples))
        .or_insert_with(|| {
            cache.queue_render_pipeline(pipeline_descriptor(
                layout.clone(),
                shader.shader.clone(),
                shader.samples,
            ))
        });
    // Until the scene's own pipeline exists, the uniform and the pipeline of the last picture stay.
    let ready = cache.get_render_pipeline(wanted).is_some();
    shader.set_ready(ready);
    if !*changed || !ready {
        return;
    }
    uniform.set(scene.numbers().clone());
    uniform.write_buffer(&device, &queue);
    if let disk::Profile::PageThorne(disk) = disk::Profile::new(&scene) {
        queue.write_buffer(page_thorne, 0, &table_bytes(&disk.table()));
    }
    if scene.view == View::Error {
        queue.write_buffer(error_map, 0, &errors.map.bytes());
    }
    (*changed, *current, *samples) = (false, Some(wanted), shader.samples);
    if bind_group.is_none()
        && let Some(uniform) = uniform.binding()
    {
        *bind_group = Some(device.create_bind_group(
            "geodesic bindings",
            &cache.get_bind_group_layout(layout),
            &BindGroupEntries::with_indices((
                (bindings::SCENE, uniform),
                (bindings::SPECTRUM, spectrum.as_entire_binding()),
                (bindings::PAGE_THORNE, page_thorne.as_entire_binding()),
                (bindings::ERROR_MAP, error_map.as_entire_binding()),
            )),
        ));
    }
}

fn draw_geodesic_pass(
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
    // A pipeline for another number of samples waits until the target has as many.
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
    let size = target.main_texture().size();
    for (top, rows) in bands(size.width, size.height) {
        render_pass.set_scissor_rect(0, top, size.width, rows);
        render_pass.draw(0..3, 0..1);
    }
    span.end(&mut render_pass);
    drop(render_pass);
    pass.drawn = true;
}

/// The first row and the number of rows of each band that is drawn by one call. A driver ends a
/// device that does not respond for some seconds, and between two calls every device does.
fn bands(width: u32, height: u32) -> impl Iterator<Item = (u32, u32)> {
    let rows = (MAX_BAND_PIXELS / width.max(1)).max(1);
    (0..height)
        .step_by(rows as usize)
        .map(move |top| (top, rows.min(height - top)))
}
