//! Keeps the drawn scene for the report of a crash.

use crate::render::CurrentScene;
use crate::storage::note_scene;
use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Last,
        note_drawn_scene.run_if(resource_changed::<CurrentScene>),
    );
}

fn note_drawn_scene(scene: Res<CurrentScene>) {
    note_scene(&scene);
}
