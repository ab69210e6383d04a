//! Gives Bevy the shaders that an edit of their files has changed.

use crate::geodesic::{JoinedShaders, select_geodesic_shaders};
use crate::live_shaders::LiveShaders;
use bevy::asset::AssetEventSystems;
use bevy::prelude::*;

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<LiveShaders>().add_systems(
        PostUpdate,
        reload_shaders
            .run_if(LiveShaders::is_watching)
            .before(select_geodesic_shaders)
            .before(AssetEventSystems),
    );
}

fn reload_shaders(
    time: Res<Time<Real>>,
    mut live: ResMut<LiveShaders>,
    mut joined: ResMut<JoinedShaders>,
    mut shaders: ResMut<Assets<Shader>>,
) {
    let changed = live.bypass_change_detection().look(time.elapsed());
    if changed.is_empty() {
        return;
    }
    // The picture is drawn again, once all pipelines exist again.
    live.set_changed();
    joined.await_pipelines();
    for (id, shader) in changed {
        if let Err(error) = shaders.insert(id, shader) {
            error!("a shader could not be replaced: {error}");
        }
    }
}
