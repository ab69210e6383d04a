//! The kept picture: while nothing that the eye sees changes, the eye rests, and the picture it
//! drew last is what the screen goes on showing. A resting eye runs no pass at all: no foreground,
//! no geodesics, no bloom, no tone mapping.
//!
//! The main world tells what is to be seen (`Sight`) and wakes the eye in the very frame of a
//! change; the render world says when a frame has drawn all of it. A sight of which the shader is
//! still being made is waited for with the eye at rest: until then the last picture stays, whole
//! and of one scene.

use super::chain::Chain;
use super::errors::{self, Errors};
use super::geodesic::{GeodesicPass, GeodesicShader, join_shader};
use super::{CurrentScene, Eye};
use crate::scene::{Scene, View};
use bevy::camera::CameraUpdateSystems;
use bevy::prelude::*;
use bevy::render::camera::ExtractedCamera;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::PipelineCache;
use bevy::render::{Render, RenderApp, RenderSystems};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the eye draws every frame, changed or not: for measurements.
#[derive(Resource, Default)]
pub struct AlwaysDraw(pub bool);

/// What the eye is to see. Each change makes a new one, so that no answer is taken for that to
/// another question.
#[derive(Resource, Clone, ExtractResource)]
pub struct Sight {
    scene: Scene,
    /// Whether a frame has drawn all of it; both worlds hold it.
    drawn: Arc<AtomicBool>,
}

impl Sight {
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
    let sight = Sight::new(app.world().resource::<CurrentScene>());
    app.init_resource::<AlwaysDraw>()
        .insert_resource(sight)
        .add_plugins(ExtractResourcePlugin::<Sight>::default())
        .add_systems(
            PostUpdate,
            look.after(join_shader)
                .after(errors::follow)
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
    errors: Res<Errors>,
    always: Res<AlwaysDraw>,
    mut sight: ResMut<Sight>,
    mut kept_any: Local<bool>,
    mut eye: Single<&mut Camera, With<Eye>>,
) {
    *kept_any |= sight.is_drawn();
    // What writes the scene may have written what was there already.
    let other = scene.is_changed() && sight.scene != seen(&scene);
    if other || errors.is_changed() && scene.view == View::Error {
        *sight = Sight::new(&scene);
    }
    // Before there is anything to keep, the eye looks into the dark, so that the other passes'
    // pipelines are made, too.
    let wakes = always.0 || !sight.is_drawn() && (shader.is_ready() || !*kept_any);
    if eye.is_active != wakes {
        eye.is_active = wakes;
    }
}

/// Says so when this frame has drawn all that is to be seen.
fn confirm(
    sight: Option<Res<Sight>>,
    pass: Option<Res<GeodesicPass>>,
    eye: Query<(), (With<Eye>, With<ExtractedCamera>)>,
    cache: Res<PipelineCache>,
    mut settling: Local<u32>,
) {
    let (Some(sight), Some(pass)) = (sight, pass) else {
        return;
    };
    let unsettled = if Chain::of(&sight.scene).probe {
        SETTLING
    } else {
        0
    };
    // A pass leaves itself out while its pipeline is being made.
    let whole =
        !eye.is_empty() && pass.has_drawn_scene() && cache.waiting_pipelines().next().is_none();
    if !whole || sight.is_changed() {
        *settling = unsettled;
    }
    if whole && *settling == 0 {
        sight.drawn.store(true, Ordering::Release);
    } else if whole {
        *settling -= 1;
    }
}
