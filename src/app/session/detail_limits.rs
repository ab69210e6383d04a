//! Limits the waves of the disk's structure and the faint stars in the window to what its adapter
//! can draw.

use crate::app::session::canvas::assumed_kind;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_render::{StarLimit, WaveLimit};

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        PreUpdate,
        limit_details.run_if(resource_exists_and_changed::<RenderAdapterInfo>),
    );
}

fn limit_details(
    adapter: Res<RenderAdapterInfo>,
    mut waves: ResMut<WaveLimit>,
    mut stars: ResMut<StarLimit>,
) {
    let kind = assumed_kind(&adapter);
    waves.set_if_neq(WaveLimit::of_window(kind));
    stars.set_if_neq(StarLimit::of_window(kind));
}
