//! The pass that runs the kernels of stars, before anything else is drawn.

use super::StarCatalogue;
use super::kernels::add_shaders;
use super::list::StarLists;
use super::ready::Stale;
use crate::camera_markers::SceneCamera;
use crate::draw_request::AlwaysDraw;
use crate::geodesic::GeodesicPass;
use crate::given_light::traces_light;
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
                .before(main_opaque_pass_3d)
                .run_if(traces_light),
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
        .filter_map(|(stars, ready)| {
            let stale = stars.take_changed();
            Some((ready, if always.0 { Stale::All } else { stale? }))
        })
        .collect();
    if waiting.is_empty() {
        return;
    }
    for (stars, stale) in &waiting {
        stars.clear(*stale, context.command_encoder(), &queue);
    }
    let rounds = waiting.iter().map(|(stars, stale)| stars.rounds(*stale));
    for round in 0..rounds.max().unwrap_or(0) {
        let running = || {
            let all = waiting.iter();
            all.filter(|(stars, stale)| round < stars.rounds(*stale))
        };
        for (stars, _) in running().filter(|_| round > 0) {
            stars.clear_candidates(context.command_encoder());
        }
        run_compute_pass(&mut context, "stars", |compute_pass| {
            for (stars, stale) in running() {
                stars.dispatch((*stale, round), compute_pass);
            }
        });
    }
}
