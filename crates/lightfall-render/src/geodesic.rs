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

pub(super) use pass::GeodesicPass;
pub(crate) use shader::GeodesicShaders;
pub(super) use shader::{JoinedShaders, select_geodesic_shaders};

use crate::antialias::prepare_antialias;
use crate::comparison::{
    ComparedScene, Comparison, draw_difference, follow_current_scene, prepare_difference,
};
use crate::detail_limits::DetailLimits;
use crate::draw_request::DrawRequest;
use crate::drawn_scene::DrawnScene;
use crate::error_map::ShownErrorMap;
use crate::graphics::Graphics;
use crate::live_shaders::LiveShaders;
use crate::progress::DrawnFrame;
use crate::star_catalogue::StarCatalogue;
use crate::stars::StarPass;
use bevy::asset::AssetEventSystems;
use bevy::core_pipeline::core_3d::{main_opaque_pass_3d, main_transparent_pass_3d};
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use bevy::render::{GpuResourceAppExt, Render, RenderApp, RenderStartup, RenderSystems};
use draw::draw_geodesic_pass;
use lightfall_core::scene::Frame;
use pipeline::Destination;
use queue::{GeodesicPipelines, queue_pipelines};
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
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .init_gpu_resource::<GeodesicPipelines>()
        .add_systems(RenderStartup, create_geodesic_pass)
        .add_systems(
            Render,
            (
                prepare_difference,
                prepare_antialias,
                queue_pipelines,
                write_scenes,
            )
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
    commands.insert_resource(GeodesicPass {
        shared: Shared::new(&device, &queue),
        current: Side::default(),
        pinned: None,
        destination: Destination::Light,
        changed: true,
    });
}

/// Writes changed scenes once their pipelines exist.
fn write_scenes(
    scene: Res<DrawnScene>,
    compared: Res<ComparedScene>,
    (If(shaders), If(pipelines)): (If<Res<GeodesicShaders>>, If<Res<GeodesicPipelines>>),
    errors: Res<ShownErrorMap>,
    request: Option<Res<DrawRequest>>,
    mut drawn: ResMut<DrawnFrame>,
    (catalogue, limits): (Res<StarCatalogue>, Res<DetailLimits>),
    (If(mut pass), If(mut stars)): (If<ResMut<GeodesicPass>>, If<ResMut<StarPass>>),
    graphics: Graphics,
) {
    let pass = &mut *pass;
    pass.changed |= scene.is_changed()
        || shaders.is_changed()
        || errors.is_changed()
        || compared.is_changed()
        || limits.is_changed();
    let frame = Frame::of(&scene);
    let frame = request.map_or(frame, |request| request.next_sample(frame));
    if !pass.changed {
        drawn.is_present = true;
        pass.set_frame(&scene, &compared, &frame, &graphics);
        return;
    }
    // Until all pipelines exist, the scenes and the pipelines of the last picture stay.
    let (true, Some(current)) = (shaders.are_ready(), pipelines.current) else {
        return;
    };
    let mut writer = SideWriter {
        shared: &mut pass.shared,
        layout: &pipelines.layout,
        errors: &errors.map,
        limits: *limits,
        stars: &mut stars,
        catalogue: *catalogue,
        frame: &frame,
        graphics: &graphics,
    };
    pass.current.write(&scene, current, &mut writer);
    pass.pinned = match (compared.drawn(), pipelines.pinned) {
        (Some((scene, layout)), Some(pipelines)) => {
            let (mut side, _) = pass.pinned.take().unwrap_or((Side::default(), layout));
            side.write(scene, pipelines, &mut writer);
            Some((side, layout))
        }
        _ => None,
    };
    pass.destination = shaders.current.picture.destination;
    (pass.changed, drawn.is_present) = (false, true);
}
