//! Draws the scene again only when something in it changes. Otherwise the scene camera is idle, and
//! the screen shows the picture that was drawn last. An idle camera runs no pass at all: no
//! foreground, no geodesics, no bloom, no tone mapping.
//!
//! The main world holds the request ([`DrawRequest`]) and wakes the camera in the same frame as a
//! change. The render world counts the frames that have drawn all of it. While the shader of a new
//! request compiles, the camera stays idle, so the last picture stays complete.
//!
//! A request may ask for the mean of several frames (accumulate.rs). The camera then stays awake
//! until all of them are drawn. A change begins with the first frame again, so nothing is averaged
//! while the camera moves or the disk's clock runs.

use crate::camera_markers::SceneCamera;
use crate::comparison::ComparedScene;
use crate::draw_request::{AlwaysDraw, DrawRequest};
use crate::drawn_layers::DrawnLayers;
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::error_map::{ErrorMapRequest, ShownErrorMap, update_error_map};
use crate::geodesic::{GeodesicShaders, select_geodesic_shaders};
use crate::given_light::GivenLight;
use crate::live_shaders::LiveShaders;
use crate::progress::{DrawnFrame, Progress};
use crate::resting_frames::RestingFrames;
use bevy::camera::CameraUpdateSystems;
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::extract_resource::ExtractResourcePlugin;
use bevy::render::render_resource::{CachedPipelineState, PipelineCache};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use bevy::shader::ShaderCacheError;
use lightfall_core::scene::View;

pub(super) fn plugin(app: &mut App) {
    let world = app.world();
    let request = DrawRequest::new(
        (world.resource::<DrawnScene>(), None),
        world.resource::<ComparedScene>(),
        world.resource::<RestingFrames>().to_owned(),
    );
    app.init_resource::<AlwaysDraw>()
        .init_resource::<Progress>()
        .insert_resource(request)
        .add_plugins((
            ExtractResourcePlugin::<DrawRequest>::default(),
            ExtractResourcePlugin::<AlwaysDraw>::default(),
        ))
        .add_systems(
            PostUpdate,
            wake_scene_camera
                .after(select_geodesic_shaders)
                .after(update_error_map)
                .before(CameraUpdateSystems),
        );
    app.sub_app_mut(RenderApp)
        .init_resource::<DrawnFrame>()
        .add_systems(RenderStartup, forget_lost_picture)
        .add_systems(Render, count_frame.in_set(RenderSystems::Cleanup));
}

/// The startup of a new device: the picture of the device before it is lost.
fn forget_lost_picture(request: Option<Res<DrawRequest>>) {
    if let Some(request) = request {
        request.forget_picture();
    }
}

/// Makes a new request when the picture changes, activates the scene camera while a request is not
/// drawn yet, and states the progress.
fn wake_scene_camera(
    (scene, part, given): (Res<DrawnScene>, Res<DrawnPart>, Res<GivenLight>),
    layers: Res<DrawnLayers>,
    compared: Res<ComparedScene>,
    shaders: Res<GeodesicShaders>,
    errors: Res<ShownErrorMap>,
    (always, resting): (Res<AlwaysDraw>, Res<RestingFrames>),
    live: Res<LiveShaders>,
    (mut request, mut progress): (ResMut<DrawRequest>, ResMut<Progress>),
    mut camera: Single<&mut Camera, With<SceneCamera>>,
) {
    // A system that writes the scene may have written the values it already had.
    let changed = request.part != part.drawn()
        || given.is_changed()
        || layers.is_changed()
        || scene.is_changed() && request.scene != scene.without_presentation()
        || compared.is_changed() && request.compared != compared.without_presentation()
        || resting.is_changed()
        || live.is_changed();
    if changed || errors.is_changed() && scene.view == View::Error {
        *request = request.next((&scene, part.drawn()), &compared, *resting);
    }
    // Before the first picture of a device the camera draws without the geodesic pass, so that Bevy compiles
    // the pipelines of the other passes at the same time.
    progress.set_if_neq(request.progress(shaders.are_ready()));
    let waits = *progress == Progress::Compiling && request.has_picture();
    let active = always.0 || *progress != Progress::Done && !waits;
    if camera.is_active != active {
        camera.is_active = active;
    }
}

/// Counts the frame for the request, and leaves nothing drawn for the next one.
fn count_frame(
    request: Option<Res<DrawRequest>>,
    mut frame: ResMut<DrawnFrame>,
    camera: Query<(), (With<SceneCamera>, With<ExtractedCamera>)>,
    cache: Res<PipelineCache>,
) {
    let frame = std::mem::take(&mut *frame);
    let Some(request) = request else {
        return;
    };
    // A pass whose pipeline is still compiling is skipped.
    let complete = !camera.is_empty()
        && frame.shows_scene()
        && (request.averaged_frame().is_none() || frame.is_added)
        && cache.waiting_pipelines().next().is_none();
    request.count_frame(complete);
}

/// Whether all of the present scene has been drawn. To be asked after an update.
///
/// # Errors
/// A pipeline that could not be created (a shader error, or a limit of the device), or an error map
/// that could not be computed; in one sentence.
pub fn is_drawn(app: &App) -> Result<bool, String> {
    let render_world = app.sub_app(RenderApp).world();
    let Some(cache) = render_world.get_resource::<PipelineCache>() else {
        return Ok(false);
    };
    for pipeline in cache.pipelines() {
        if let CachedPipelineState::Err(error) = &pipeline.state
            && !matches!(error, ShaderCacheError::ShaderNotLoaded(_))
        {
            return Err(format!("a render pipeline could not be created: {error}"));
        }
    }
    let world = app.world();
    let error_map = world.resource::<ErrorMapRequest>();
    let request = world.resource::<DrawRequest>();
    Ok(error_map.is_done(world.resource::<DrawnScene>())?
        && request.progress(true) == Progress::Done)
}
