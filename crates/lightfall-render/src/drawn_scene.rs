//! The scene that was chosen, the frame that is drawn of it, and the two together, which is what
//! the passes read.

use bevy::app::MainScheduleOrder;
use bevy::ecs::schedule::ScheduleLabel;
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Frame;

/// The scene as it was last chosen or flown: at its own size, with the exposure and the time of the
/// disk that it was chosen with.
#[derive(Resource, Clone, Deref, PartialEq)]
pub struct CurrentScene(pub Drawable);

/// What is drawn of the current scene: its size, its cells, its exposure and the disk's time.
#[derive(Resource, Clone, Copy, Deref, PartialEq)]
pub struct CurrentFrame(pub Frame);

/// The current scene in its frame. [`draw_scene_in_frame`] alone writes it.
#[derive(Resource, Clone, Deref, ExtractResource, PartialEq)]
pub struct DrawnScene(Drawable);

/// The schedule between `Update`, in which the scene changes, and `PostUpdate`, in which it is
/// prepared for the passes. The frame is written here.
#[derive(ScheduleLabel, Clone, Debug, PartialEq, Eq, Hash)]
pub struct FrameScene;

/// Begins with a scene in its own frame.
pub(super) fn insert(app: &mut App, scene: Drawable) {
    app.insert_resource(CurrentFrame(Frame::of(&scene)))
        .insert_resource(DrawnScene(scene.clone()))
        .insert_resource(CurrentScene(scene))
        .add_plugins(ExtractResourcePlugin::<DrawnScene>::default())
        .init_schedule(FrameScene)
        .add_systems(FrameScene, draw_scene_in_frame);
    app.world_mut()
        .resource_mut::<MainScheduleOrder>()
        .insert_after(Update, FrameScene);
}

/// Makes the scene that the passes read. Systems that write the frame come before.
pub fn draw_scene_in_frame(
    scene: Res<CurrentScene>,
    frame: Res<CurrentFrame>,
    mut drawn: ResMut<DrawnScene>,
) {
    if scene.is_changed() || frame.is_changed() {
        drawn.set_if_neq(DrawnScene(scene.shown_in(&frame)));
    }
}
