//! Keeps the drawn scene for the report of a crash.

use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_core::gpu::AdapterName;
use lightfall_platform::storage::{note_adapter, note_scene};
use lightfall_render::DrawnScene;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Startup, note_used_adapter).add_systems(
        Last,
        note_drawn_scene.run_if(resource_changed::<DrawnScene>),
    );
}

fn note_used_adapter(adapter: Option<Res<RenderAdapterInfo>>) {
    if let Some(info) = adapter {
        note_adapter(format!("{} {}", AdapterName::of(&info), info.driver_info));
    }
}

fn note_drawn_scene(scene: Res<DrawnScene>) {
    note_scene(&scene);
}
