//! The pass that runs the kernels of stars, before anything else is drawn.

use super::kernels::{StarPass, add_shaders};
use crate::camera_markers::SceneCamera;
use crate::draw_request::AlwaysDraw;
use crate::geodesic::GeodesicPass;
use crate::star_catalogue::StarCatalogue;
use crate::star_limit::StarLimit;
use bevy::core_pipeline::core_3d::main_opaque_pass_3d;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderQueue, ViewQuery};
use bevy::render::{RenderApp, RenderStartup};

pub(crate) fn plugin(app: &mut App) {
    add_shaders(app);
    app.add_plugins((
        ExtractResourcePlugin::<StarCatalogue>::default(),
        ExtractResourcePlugin::<StarLimit>::default(),
    ));
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, create_star_pass)
        .add_systems(
            Core3d,
            draw_stars
                .in_set(Core3dSystems::MainPass)
                .before(main_opaque_pass_3d),
        );
}

/// Pipelines and buffers belong to a device: a new one begins without any.
fn create_star_pass(mut commands: Commands) {
    commands.insert_resource(StarPass::default());
}

/// Finds the images of the stars of the current scene and of the pinned one, and adds up their
/// light.
fn draw_stars(
    _view: ViewQuery<(), With<SceneCamera>>,
    pass: Option<Res<GeodesicPass>>,
    always: Res<AlwaysDraw>,
    cache: Res<PipelineCache>,
    queue: Res<RenderQueue>,
    mut context: RenderContext,
) {
    let Some(pass) = pass else { return };
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
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let mut compute_pass = context
        .command_encoder()
        .begin_compute_pass(&ComputePassDescriptor {
            label: Some("stars"),
            timestamp_writes: None,
        });
    let span = diagnostics.pass_span(&mut compute_pass, "stars");
    for stars in &waiting {
        stars.dispatch(&mut compute_pass);
    }
    span.end(&mut compute_pass);
}
