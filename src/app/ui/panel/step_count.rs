//! How many steps the rays of the picture take, shown below the method. They are counted on a
//! background device once the scene is at rest.

use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::overlays::Overlays;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use lightfall_core::accuracy::steps::StepCount;
use lightfall_core::gpu::{GpuError, with_background_device};
use lightfall_core::scene::Scene;
use lightfall_platform::worker::Follower;

/// The thread that counts.
#[derive(Resource)]
pub(super) struct StepCounter(Follower<Scene, Result<StepCount, GpuError>>);

impl StepCounter {
    pub(super) fn in_words(&self) -> String {
        match self.0.answer() {
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
    let counter =
        Follower::new(|scene: &Scene| with_background_device(|gpu| StepCount::of(gpu, scene)));
    app.insert_resource(StepCounter(counter)).add_systems(
        Update,
        count_steps.run_if(|overlays: Res<Overlays>| overlays.shows_panel()),
    );
}

fn count_steps(pacing: Res<FramePacing>, editor: SceneEditor, mut counter: ResMut<StepCounter>) {
    if !pacing.moving {
        counter.0.follow(editor.scene().without_shading());
    }
}
