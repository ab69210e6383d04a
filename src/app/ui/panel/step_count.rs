//! How many steps the rays of the picture take, shown next to the method and its error setting. They
//! are counted on a background device, once the scene has come to rest.

use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::overlays::Overlays;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use lightfall_core::accuracy::steps::StepCount;
use lightfall_core::gpu::with_background_device;
use lightfall_core::scene::Scene;
use lightfall_platform::worker::Worker;

/// The thread that counts, and its last answer.
#[derive(Resource)]
pub(super) struct StepCounter {
    worker: Worker<Scene, Result<StepCount, String>>,
    /// The scene whose rays were asked for last.
    asked: Option<Scene>,
    /// The answer. None while it is awaited.
    count: Option<Result<StepCount, String>>,
}

impl StepCounter {
    fn start() -> Self {
        let worker = Worker::serving_latest(|scene, answers| {
            let count = with_background_device(|gpu| StepCount::of(gpu, &scene));
            answers.send(count.map_err(|error| error.to_string()));
        });
        Self {
            worker,
            asked: None,
            count: None,
        }
    }

    pub(super) fn in_words(&self) -> String {
        match &self.count {
            None => "counting steps".into(),
            Some(Ok(count)) if count.most == 0 => "no ray takes a step".into(),
            Some(Ok(count)) => {
                format!(
                    "{:.1} steps per ray, {} at most, in {} rays",
                    count.mean, count.most, count.rays
                )
            }
            Some(Err(reason)) => format!("steps: {reason}"),
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.insert_resource(StepCounter::start()).add_systems(
        Update,
        count_steps.run_if(|overlays: Res<Overlays>| overlays.shows_panel()),
    );
}

fn count_steps(pacing: Res<FramePacing>, editor: SceneEditor, mut counter: ResMut<StepCounter>) {
    if let Some(count) = counter.worker.latest_answer() {
        counter.count = Some(count);
    }
    if pacing.moving {
        return;
    }
    let scene = editor.scene().without_shading();
    if counter.asked.as_ref() != Some(&scene) {
        counter.worker.ask(scene.clone());
        (counter.asked, counter.count) = (Some(scene), None);
    }
}
