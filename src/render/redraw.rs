//! Draws the scene again only when something in it changes. Otherwise the scene camera is idle, and
//! the screen shows the picture that was drawn last. An idle camera runs no pass at all: no
//! foreground, no geodesics, no bloom, no tone mapping.
//!
//! The main world holds the request ([`DrawRequest`]) and wakes the camera in the same frame as a
//! change. The render world marks the request as drawn once a frame has drawn all of it. While the
//! shader of a new request compiles, the camera stays idle, so the last picture stays complete.

use crate::render::camera_markers::SceneCamera;
use crate::render::chain::Chain;
use crate::render::comparison::{ComparedScene, ComparisonLayout};
use crate::render::current_scene::CurrentScene;
use crate::render::error_map::{ErrorMapRequest, ShownErrorMap, update_error_map};
use crate::render::geodesic::{GeodesicPass, GeodesicShaders, select_geodesic_shaders};
use bevy::camera::CameraUpdateSystems;
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::{CachedPipelineState, PipelineCache};
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use bevy::shader::ShaderCacheError;
use lightfall_core::scene::{Scene, View};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the scene is drawn in every frame, changed or not: for measurements.
#[derive(Resource, Default)]
pub struct AlwaysDraw(pub bool);

/// The picture to draw. Every change makes a new request with a flag of its own, so that a late
/// "drawn" cannot be taken for the answer to a newer request.
#[derive(Resource, Clone, ExtractResource)]
pub struct DrawRequest {
    scene: Scene,
    /// The pinned scene that is compared with it.
    compared: Option<(Scene, ComparisonLayout)>,
    /// Whether a frame has drawn all of it; shared by the main and the render world.
    drawn: Arc<AtomicBool>,
    /// Whether a frame has drawn the scene at some time of the disk; shared by the requests that
    /// differ in that time only. While the disk's clock runs, every frame has a request of its own,
    /// of which none is known to be drawn before the next one comes.
    shown: Arc<AtomicBool>,
    /// Whether there is a picture, of this or an earlier request. All requests share it.
    has_picture: Arc<AtomicBool>,
}

impl DrawRequest {
    fn new(scene: &Scene, compared: &ComparedScene) -> Self {
        Self {
            scene: scene.without_presentation(),
            compared: compared.without_presentation(),
            drawn: default(),
            shown: default(),
            has_picture: default(),
        }
    }

    /// A request for another picture, which replaces this one's.
    fn next(&self, scene: &Scene, compared: &ComparedScene) -> Self {
        let next = Self::new(scene, compared);
        let shown = if next.scene.without_clock() == self.scene.without_clock() {
            Arc::clone(&self.shown)
        } else {
            default()
        };
        Self {
            shown,
            has_picture: Arc::clone(&self.has_picture),
            ..next
        }
    }

    fn mark_shown(&self) {
        self.shown.store(true, Ordering::Release);
    }

    fn mark_drawn(&self) {
        self.mark_shown();
        self.drawn.store(true, Ordering::Release);
        self.has_picture.store(true, Ordering::Release);
    }

    /// Whether a frame has drawn this scene, at this or another time of the disk.
    #[must_use]
    pub fn is_shown(&self) -> bool {
        self.shown.load(Ordering::Acquire)
    }

    /// Whether a frame has drawn all of it.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        self.drawn.load(Ordering::Acquire)
    }

    /// Asks for the same picture again, because the one that was drawn is lost.
    pub(super) fn forget_picture(&self) {
        self.drawn.store(false, Ordering::Release);
        self.shown.store(false, Ordering::Release);
        self.has_picture.store(false, Ordering::Release);
    }
}

/// Extra frames that a foreground is drawn before its picture is kept. Meshes and materials reach
/// the GPU some frames after they are made, the lamps' clusters are sized by what an earlier frame
/// needed, and Bevy does not report when either is done.
const FOREGROUND_FRAMES: u32 = 8;

pub(super) fn plugin(app: &mut App) {
    let world = app.world();
    let request = DrawRequest::new(
        world.resource::<CurrentScene>(),
        world.resource::<ComparedScene>(),
    );
    app.init_resource::<AlwaysDraw>()
        .insert_resource(request)
        .add_plugins(ExtractResourcePlugin::<DrawRequest>::default())
        .add_systems(
            PostUpdate,
            wake_scene_camera
                .after(select_geodesic_shaders)
                .after(update_error_map)
                .before(CameraUpdateSystems),
        );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app
        .add_systems(RenderStartup, forget_lost_picture)
        .add_systems(Render, mark_request_drawn.in_set(RenderSystems::Cleanup));
}

/// The startup of a new device: the picture of the device before it is lost.
fn forget_lost_picture(request: Option<Res<DrawRequest>>) {
    if let Some(request) = request {
        request.forget_picture();
    }
}

/// Makes a new request when the picture changes, and activates the scene camera while a request is
/// not drawn yet.
fn wake_scene_camera(
    scene: Res<CurrentScene>,
    compared: Res<ComparedScene>,
    shaders: Res<GeodesicShaders>,
    errors: Res<ShownErrorMap>,
    always: Res<AlwaysDraw>,
    mut request: ResMut<DrawRequest>,
    mut camera: Single<&mut Camera, With<SceneCamera>>,
) {
    // A system that writes the scene may have written the values it already had.
    let changed = scene.is_changed() && request.scene != scene.without_presentation()
        || compared.is_changed() && request.compared != compared.without_presentation();
    if changed || errors.is_changed() && scene.view == View::Error {
        *request = request.next(&scene, &compared);
    }
    // Before the first picture of a device the camera draws without the geodesic pass, so that Bevy compiles
    // the pipelines of the other passes at the same time.
    let has_picture = request.has_picture.load(Ordering::Acquire);
    let active = always.0 || !request.is_drawn() && (shaders.are_ready() || !has_picture);
    if camera.is_active != active {
        camera.is_active = active;
    }
}

/// Marks the request as drawn when this frame has drawn all of it.
fn mark_request_drawn(
    request: Option<Res<DrawRequest>>,
    pass: Option<Res<GeodesicPass>>,
    camera: Query<(), (With<SceneCamera>, With<ExtractedCamera>)>,
    cache: Res<PipelineCache>,
    mut frames_left: Local<u32>,
) {
    let (Some(request), Some(pass)) = (request, pass) else {
        return;
    };
    let extra_frames = if Chain::of(&request.scene).probe {
        FOREGROUND_FRAMES
    } else {
        0
    };
    // A pass whose pipeline is still compiling is skipped.
    let complete =
        !camera.is_empty() && pass.has_drawn_scene() && cache.waiting_pipelines().next().is_none();
    if !complete || request.is_changed() {
        *frames_left = extra_frames;
    }
    if complete {
        request.mark_shown();
    }
    if complete && *frames_left == 0 {
        request.mark_drawn();
    } else if complete {
        *frames_left -= 1;
    }
}

/// Whether all of the present scene has been drawn. To be asked after an update.
///
/// # Errors
/// A pipeline that could not be created (a shader error, or a limit of the device), or an error map
/// that could not be computed; in one sentence.
pub fn is_drawn(app: &App) -> Result<bool, String> {
    let Some(cache) = app
        .get_sub_app(RenderApp)
        .and_then(|render| render.world().get_resource::<PipelineCache>())
    else {
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
    let (Some(scene), Some(error_map), Some(request)) = (
        world.get_resource::<CurrentScene>(),
        world.get_resource::<ErrorMapRequest>(),
        world.get_resource::<DrawRequest>(),
    ) else {
        return Ok(false);
    };
    Ok(error_map.is_done(scene)? && request.is_drawn())
}
