//! The geodesic pass: a full-screen triangle at the far plane. The depth test discards the pixels
//! that the foreground covers. Two compared scenes are drawn side by side in the same pass, or each
//! in a texture of its own.

mod draw;
mod inputs;
mod pass;
mod pipeline;
mod queue;
mod shader;
mod side;
mod sky;

pub(crate) use inputs::InputBuffers;
pub(super) use pass::GeodesicPass;
pub(crate) use shader::GeodesicShaders;
pub(super) use shader::{JoinedShaders, select_geodesic_shaders};

use crate::antialias::{AntialiasPass, prepare_antialias};
use crate::comparison::{
    ComparedScene, Comparison, DifferencePass, draw_difference, follow_current_scene,
    prepare_difference,
};
use crate::detail_limits::DetailLimits;
use crate::draw_request::DrawRequest;
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::error_map::ShownErrorMap;
use crate::given_light::traces_light;
use crate::graphics::{ComputePipelines, Graphics};
use crate::live_shaders::LiveShaders;
use crate::progress::DrawnFrame;
use crate::stars::{StarCatalogue, StarLists};
use bevy::asset::AssetEventSystems;
use bevy::core_pipeline::core_3d::{main_opaque_pass_3d, main_transparent_pass_3d};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_resource::BindGroupLayoutDescriptor;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use bevy::render::{GpuResourceAppExt, Render, RenderApp, RenderStartup, RenderSystems};
use draw::draw_geodesic_pass;
use lightfall_core::gpu::bindings;
use pipeline::Destination;
use queue::PipelineQueue;
use side::{Shared, Side, SideWriter};

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
                    resource_changed::<DrawnScene>
                        .or_eager(resource_changed::<Comparison>)
                        .or_eager(resource_changed::<LiveShaders>),
                )
                .before(AssetEventSystems),
        );
    app.sub_app_mut(RenderApp)
        .init_gpu_resource::<ComputePipelines>()
        .add_systems(RenderStartup, create_geodesic_pass)
        .add_systems(
            Render,
            (prepare_difference, prepare_antialias, write_scenes)
                .chain()
                .in_set(RenderSystems::PrepareResources),
        )
        .add_systems(
            Core3d,
            (draw_geodesic_pass, draw_difference)
                .chain()
                .in_set(Core3dSystems::MainPass)
                .after(main_opaque_pass_3d)
                .before(main_transparent_pass_3d)
                .run_if(traces_light),
        );
}

fn create_geodesic_pass(
    mut commands: Commands,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    commands.insert_resource(GeodesicPass {
        layout: BindGroupLayoutDescriptor::new("geodesic layout", &bindings::picture_layout()),
        pipelines: default(),
        shared: Shared::new(&device, &queue),
        current: Side::default(),
        pinned: None,
        destination: Destination::Light,
        changed: true,
    });
}

/// Queues the pipelines of the scenes, and writes changed scenes once their pipelines exist.
fn write_scenes(
    (scene, part, compared): (Res<DrawnScene>, Res<DrawnPart>, Res<ComparedScene>),
    If(shaders): If<Res<GeodesicShaders>>,
    errors: Res<ShownErrorMap>,
    request: Option<Res<DrawRequest>>,
    mut drawn: ResMut<DrawnFrame>,
    (catalogue, limits): (Res<StarCatalogue>, Res<DetailLimits>),
    (If(difference), If(antialias)): (If<Res<DifferencePass>>, If<Res<AntialiasPass>>),
    (If(mut kernels), If(mut lists)): (If<ResMut<ComputePipelines>>, If<ResMut<StarLists>>),
    If(mut pass): If<ResMut<GeodesicPass>>,
    graphics: Graphics,
) {
    let pass = &mut *pass;
    let mut queue = PipelineQueue {
        layout: &pass.layout,
        pictures: &mut pass.pipelines,
        kernels: &mut kernels,
        shows_difference: difference.is_ready(&graphics.cache),
        finds_edges: antialias.finds_edges(&graphics.cache),
        reloads: shaders.reloads,
        cache: &graphics.cache,
    };
    let current = queue.all_of(&shaders.current);
    let pinned = shaders.pinned.as_ref().map(|pinned| queue.all_of(pinned));
    pass.changed |= scene.is_changed()
        || part.is_changed()
        || shaders.is_changed()
        || errors.is_changed()
        || compared.is_changed()
        || limits.is_changed();
    let request = request.as_deref();
    if !pass.changed {
        drawn.is_present = true;
        pass.set_frame(&scene, &compared, request, &graphics);
        return;
    }
    // Until all pipelines exist, the scenes and the pipelines of the last picture stay.
    if !shaders.are_ready() {
        return;
    }
    let mut writer = SideWriter {
        shared: &mut pass.shared,
        layout: &pass.layout,
        errors: &errors.map,
        limits: *limits,
        part: part.drawn(),
        lists: &mut lists,
        catalogue: *catalogue,
        request,
        graphics: &graphics,
    };
    let corner = UVec2::new(compared.first_column(), 0);
    let alone = compared.drawn_current(&scene);
    pass.current.write((alone, corner), current, &mut writer);
    pass.pinned = match (compared.drawn(), pinned) {
        (Some((scene, layout)), Some(pipelines)) => {
            let (mut side, _) = pass.pinned.take().unwrap_or((Side::default(), layout));
            side.write((scene, UVec2::ZERO), pipelines, &mut writer);
            Some((side, layout))
        }
        _ => None,
    };
    pass.destination = shaders.current.picture.destination;
    (pass.changed, drawn.is_present) = (false, true);
}
