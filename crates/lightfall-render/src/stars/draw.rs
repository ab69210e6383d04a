//! The pass that runs the kernels of stars, before anything else is drawn.

use super::StarCatalogue;
use super::kernels::add_shaders;
use super::list::StarLists;
use crate::camera_markers::SceneCamera;
use crate::draw_request::AlwaysDraw;
use crate::geodesic::GeodesicPass;
use crate::graphics::run_compute_pass;
use bevy::core_pipeline::core_3d::main_opaque_pass_3d;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderQueue, ViewQuery};
use bevy::render::{GpuResourceAppExt, RenderApp};

pub(crate) fn plugin(app: &mut App) {
    add_shaders(app);
    app.add_plugins(ExtractResourcePlugin::<StarCatalogue>::default());
    app.sub_app_mut(RenderApp)
        // Buffers belong to a device: a new one begins without any.
        .init_gpu_resource::<StarLists>()
        .add_systems(
            Core3d,
            draw_stars
                .in_set(Core3dSystems::MainPass)
                .before(main_opaque_pass_3d),
        );
}

/// Finds the images of the stars of the current scene and of the pinned one, and adds up their
/// light.
fn draw_stars(
    _view: ViewQuery<(), With<SceneCamera>>,
    If(pass): If<Res<GeodesicPass>>,
    always: Res<AlwaysDraw>,
    cache: Res<PipelineCache>,
    queue: Res<RenderQueue>,
    mut context: RenderContext,
) {
    let waiting: Vec<_> = pass
        .scene_stars()
        // A change stays until its pipelines are ready.
        .filter_map(|stars| Some((stars, stars.ready(&cache)?)))
        .filter(|(stars, _)| stars.take_changed() || always.0)
        .map(|(_, ready)| ready)
        .collect();
    if waiting.is_empty() {
        return;
    }
    for stars in &waiting {
        stars.clear(context.command_encoder(), &queue);
    }
    let rounds = waiting.iter().map(|stars| stars.rounds()).max();
    for round in 0..rounds.unwrap_or(0) {
        let own = || waiting.iter().filter(|stars| round < stars.rounds());
        for stars in own().filter(|_| round > 0) {
            stars.clear_candidates(context.command_encoder());
        }
        run_compute_pass(&mut context, "stars", |compute_pass| {
            for stars in own() {
                stars.dispatch(round, compute_pass);
            }
        });
    }
}
