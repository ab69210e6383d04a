//! How many frames the window's picture is the mean of while it rests.

use crate::app::session::canvas::assumed_kind;
use crate::app::state::preferences::Preferences;
use crate::app::state::settings::Automatic;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_render::RestingFrames;
use wgpu::DeviceType;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(PreUpdate, choose_resting_frames);
}

/// A software renderer takes a good part of a second for a frame, so by default its window is content
/// with what the scene asks for.
fn choose_resting_frames(
    adapter: Option<Res<RenderAdapterInfo>>,
    preferences: Res<Preferences>,
    mut frames: ResMut<RestingFrames>,
) {
    let Some(adapter) = adapter else { return };
    let software = assumed_kind(&adapter) == DeviceType::Cpu;
    let averages = match preferences.settings.average_at_rest {
        Automatic::On => true,
        Automatic::Off => false,
        Automatic::Auto => !software,
    };
    frames.set_if_neq(RestingFrames::of_window(averages, software));
}
