//! The error map that the view `error` shows. A background thread computes it on a GPU device of
//! its own, so that no frame waits for it.
//!
//! When the camera moves, the map of the last place stays on screen until the next one arrives. A
//! still waits for its map.

use crate::drawn_scene::DrawnScene;
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use lightfall_core::accuracy::picture_errors;
use lightfall_core::gpu::{ERROR_MAP_SIZE, ErrorMap, GpuError, with_background_device};
use lightfall_core::scene::{Scene, View};
use lightfall_platform::worker::Worker;

/// Whether a frame of the view `error` waits until its error map is computed: for stills.
#[derive(Resource, Default)]
pub struct AwaitErrorMap(pub bool);

/// The error map that the view shows.
#[derive(Resource, Clone, Default, ExtractResource)]
pub(super) struct ShownErrorMap {
    /// The scene that the map belongs to, without its shading; `None` for an empty map.
    scene: Option<Scene>,
    pub(super) map: ErrorMap,
}

/// The request for the latest error map. The thread starts with the first request.
#[derive(Resource, Default)]
pub(super) struct ErrorMapRequest {
    /// The scene whose map was requested last, without its shading.
    scene: Option<Scene>,
    /// Whether that map is still to come.
    pending: bool,
    /// Why the map could not be computed.
    failure: Option<String>,
    worker: Option<Worker<Scene, ComputedMap>>,
}

/// An answer of the background thread.
struct ComputedMap {
    scene: Scene,
    map: Result<ErrorMap, GpuError>,
}

impl ErrorMapRequest {
    /// Whether the present scene needs no error map, or has it.
    ///
    /// # Errors
    /// Why the map could not be computed.
    pub(super) fn is_done(&self, scene: &Scene) -> Result<bool, String> {
        match &self.failure {
            _ if scene.view != View::Error => Ok(true),
            Some(failure) => Err(failure.clone()),
            None => Ok(!self.pending && self.scene == Some(scene.without_shading())),
        }
    }

    fn ask(&mut self, scene: Scene) {
        self.worker
            .get_or_insert_with(|| Worker::serving_latest(|scene, maps| maps.send(compute(scene))))
            .ask(scene.clone());
        (self.scene, self.pending, self.failure) = (Some(scene), true, None);
    }

    /// The newest map, if there is a new one. With `wait`, waits for the map requested last.
    fn take_map(&self, wait: bool) -> Option<ComputedMap> {
        let worker = self.worker.as_ref().filter(|_| self.pending)?;
        if wait {
            worker.wait_for(|computed| self.scene.as_ref() == Some(&computed.scene))
        } else {
            worker.latest_answer()
        }
    }
}

fn compute(scene: Scene) -> ComputedMap {
    let map = with_background_device(|gpu| picture_errors(gpu, &scene, ERROR_MAP_SIZE))
        .map(|errors| ErrorMap::new(&errors));
    ComputedMap { scene, map }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<AwaitErrorMap>()
        .init_resource::<ShownErrorMap>()
        .init_resource::<ErrorMapRequest>()
        .add_plugins(ExtractResourcePlugin::<ShownErrorMap>::default())
        .add_systems(PostUpdate, update_error_map);
}

/// Requests the error map of the present scene, and shows it when it arrives.
pub(super) fn update_error_map(
    scene: Res<DrawnScene>,
    wait: Res<AwaitErrorMap>,
    mut request: ResMut<ErrorMapRequest>,
    mut shown: ResMut<ShownErrorMap>,
) {
    if scene.view == View::Error && scene.is_changed() {
        let wanted = scene.without_shading();
        if request.scene.as_ref() != Some(&wanted) {
            // The map of another place only lags behind. The map of another method, hole or disk
            // would be wrong, so it is cleared.
            let (camera, observer) = (wanted.camera, wanted.observer);
            if shown.scene.take().is_none_or(|scene| {
                Scene {
                    camera,
                    observer,
                    ..scene
                } != wanted
            }) {
                shown.map = ErrorMap::default();
            }
            request.ask(wanted);
        }
    }
    if !request.pending {
        return;
    }
    let Some(ComputedMap { scene, map }) = request.take_map(wait.0) else {
        return;
    };
    request.pending = request.scene.as_ref() != Some(&scene);
    match map {
        Ok(map) => {
            *shown = ShownErrorMap {
                scene: Some(scene),
                map,
            }
        }
        Err(error) => {
            let failure = format!("the error map of the picture could not be computed: {error}");
            error!("{failure}");
            request.failure = Some(failure);
        }
    }
}
