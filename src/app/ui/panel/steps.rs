//! How many steps the rays of the picture take, beside the method and its error setting. Counted on
//! the inspector's own device, once the scene has come to rest.

use crate::app::input::keyboard::SceneEditor;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::session::window::Overlays;
use crate::app::ui::inspector::Worker;
use bevy::prelude::*;
use lightfall_core::reports::steps::StepCount;
use lightfall_core::scene::{Picture, Scene};

/// What is known of it.
#[derive(Resource, Default)]
pub(super) struct Steps {
    /// The scene whose rays were asked for last.
    asked: Option<Scene>,
    /// The answer; none yet while it is awaited.
    count: Option<Result<StepCount, String>>,
}

impl Steps {
    pub(super) fn in_words(&self) -> String {
        match &self.count {
            None => "steps: being counted".into(),
            Some(Ok(count)) if count.most == 0 => "solved in closed form, without steps".into(),
            Some(Ok(count)) => {
                format!(
                    "{:.1} steps a ray, {} at most, of {} rays",
                    count.mean, count.most, count.rays
                )
            }
            Some(Err(reason)) => format!("steps: {reason}"),
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Steps>().add_systems(
        Update,
        follow.run_if(|shown: Res<Overlays>| shown.panel_seen()),
    );
}

fn follow(
    worker: Res<Worker>,
    pace: Res<FramePacing>,
    editor: SceneEditor,
    mut steps: ResMut<Steps>,
) {
    if let Some(counted) = worker.counted() {
        steps.count = Some(counted);
    }
    if pace.moving {
        return;
    }
    let scene = traced(editor.meant());
    if steps.asked.as_ref() != Some(&scene) {
        worker.count(scene.clone());
        *steps = Steps {
            asked: Some(scene),
            count: None,
        };
    }
}

/// A scene without what its rays know nothing of: words, views, and what becomes of their light.
fn traced(scene: Scene) -> Scene {
    let none = Scene::default();
    let picture = Picture {
        width: scene.picture.width,
        height: scene.picture.height,
        ..none.picture
    };
    Scene {
        name: none.name,
        title: none.title,
        view: none.view,
        picture,
        ..scene
    }
}
