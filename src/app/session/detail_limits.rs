//! What the window's adapter decides: how much detail is drawn, and how many frames a picture at
//! rest is the mean of.

use crate::app::session::canvas::assumed_kind;
use crate::app::state::preferences::Preferences;
use crate::app::state::settings::Automatic;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_render::{DetailLimits, RestingFrames};
use wgpu::DeviceType;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(PreUpdate, limit_details);
}

fn limit_details(
    If(adapter): If<Res<RenderAdapterInfo>>,
    preferences: Res<Preferences>,
    mut limits: ResMut<DetailLimits>,
    mut frames: ResMut<RestingFrames>,
) {
    let kind = assumed_kind(&adapter);
    limits.set_if_neq(DetailLimits::of_window(kind));
    // A software renderer takes a good part of a second for a frame, so by default its window is
    // content with what the scene asks for.
    let software = kind == DeviceType::Cpu;
    let averages = match preferences.settings.average_at_rest {
        Automatic::On => true,
        Automatic::Off => false,
        Automatic::Auto => !software,
    };
    frames.set_if_neq(RestingFrames::of_window(averages, software));
}
