//! The kept picture: while nothing that the eye sees changes, the eye rests, and the picture it
//! drew last is what the screen goes on showing. A resting eye runs no pass at all: no foreground,
//! no geodesics, no bloom, no tone mapping.
//!
//! The main world tells what is to be seen (`DrawRequest`) and wakes the eye in the very frame of a
//! change; the render world says when a frame has drawn all of it. A request of which the shader is
//! still being made is waited for with the eye at rest: until then the last picture stays, whole
//! and of one scene.

use super::chain::Chain;
use super::geodesic::{GeodesicPass, GeodesicShader, join_shader};
use super::{CurrentScene, SceneCamera};
use crate::render::error_map;
use crate::render::error_map::PictureErrors;
use bevy::camera::CameraUpdateSystems;
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::PipelineCache;
use bevy::render::{Render, RenderApp, RenderSystems};
use lightfall_core::scene::{Scene, View};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the eye draws every frame, changed or not: for measurements.
#[derive(Resource, Default)]
pub struct AlwaysDraw(pub bool);

/// What the eye is to see. Each change makes a new one, so that no answer is taken for that to
/// another question.
#[derive(Resource, Clone, ExtractResource)]
pub struct DrawRequest {
    scene: Scene,
    /// Whether a frame has drawn all of it; both worlds hold it.
    drawn: Arc<AtomicBool>,
}

impl DrawRequest {
    fn new(scene: &Scene) -> Self {
        Self {
            scene: seen(scene),
            drawn: default(),
        }
    }

    /// Whether a frame has drawn all of it.
    #[must_use]
    pub fn is_drawn(&self) -> bool {
        self.drawn.load(Ordering::Acquire)
    }

    /// To be drawn again: what was drawn is lost.
    pub(super) fn forget(&self) {
        self.drawn.store(false, Ordering::Release);
    }
}

/// Frames more that a foreground is drawn before its picture is kept: its meshes and materials
/// reach the GPU some frames after they are made, the lamps' clusters are as large as a former
/// frame found necessary, and nothing tells when that is over.
const SETTLING: u32 = 8;

pub(super) fn plugin(app: &mut App) {
    let request = DrawRequest::new(app.world().resource::<CurrentScene>());
    app.init_resource::<AlwaysDraw>()
        .insert_resource(request)
        .add_plugins(ExtractResourcePlugin::<DrawRequest>::default())
        .add_systems(
            PostUpdate,
            look.after(join_shader)
                .after(error_map::follow)
                .before(CameraUpdateSystems),
        );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app.add_systems(Render, confirm.in_set(RenderSystems::Cleanup));
}

/// A scene without what the eye's passes know nothing of: words, and what the screen does with the
/// finished picture. All else counts as seen, needed by the scene or not: a field too many costs a
/// frame, one too few a wrong picture.
fn seen(scene: &Scene) -> Scene {
    let none = Scene::default();
    let mut seen = Scene {
        schema: none.schema,
        name: none.name,
        title: none.title,
        ..scene.clone()
    };
    seen.picture.grid_width = none.picture.grid_width;
    seen.picture.grid_height = none.picture.grid_height;
    seen.picture.levels = none.picture.levels;
    seen.picture.dither = none.picture.dither;
    seen.picture.bypass = none.picture.bypass;
    seen
}

/// Wakes the eye and puts it to rest.
fn look(
    scene: Res<CurrentScene>,
    shader: Res<GeodesicShader>,
    errors: Res<PictureErrors>,
    always: Res<AlwaysDraw>,
    mut request: ResMut<DrawRequest>,
    mut kept_any: Local<bool>,
    mut eye: Single<&mut Camera, With<SceneCamera>>,
) {
    *kept_any |= request.is_drawn();
    // What writes the scene may have written what was there already.
    let other = scene.is_changed() && request.scene != seen(&scene);
    if other || errors.is_changed() && scene.view == View::Error {
        *request = DrawRequest::new(&scene);
    }
    // Before there is anything to keep, the eye looks into the dark, so that the other passes'
    // pipelines are made, too.
    let wakes = always.0 || !request.is_drawn() && (shader.is_ready() || !*kept_any);
    if eye.is_active != wakes {
        eye.is_active = wakes;
    }
}

/// Says so when this frame has drawn all that is to be seen.
fn confirm(
    request: Option<Res<DrawRequest>>,
    pass: Option<Res<GeodesicPass>>,
    eye: Query<(), (With<SceneCamera>, With<ExtractedCamera>)>,
    cache: Res<PipelineCache>,
    mut settling: Local<u32>,
) {
    let (Some(request), Some(pass)) = (request, pass) else {
        return;
    };
    let unsettled = if Chain::of(&request.scene).probe {
        SETTLING
    } else {
        0
    };
    // A pass leaves itself out while its pipeline is being made.
    let whole =
        !eye.is_empty() && pass.has_drawn_scene() && cache.waiting_pipelines().next().is_none();
    if !whole || request.is_changed() {
        *settling = unsettled;
    }
    if whole && *settling == 0 {
        request.drawn.store(true, Ordering::Release);
    } else if whole {
        *settling -= 1;
    }
}
