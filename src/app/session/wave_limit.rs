//! Limits the waves of the disk's structure in the window to what its adapter can draw.

use crate::app::session::canvas::assumed_kind;
use crate::render::WaveLimit;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PreUpdate,
        limit_waves.run_if(resource_exists_and_changed::<RenderAdapterInfo>),
    );
}

fn limit_waves(adapter: Res<RenderAdapterInfo>, mut limit: ResMut<WaveLimit>) {
    limit.set_if_neq(WaveLimit::of_window(assumed_kind(&adapter)));
}
