//! The window's pixels as the picture's canvas: the picture gets the window's shape, and without
//! cells it is traced as finely as the window shows and the adapter can afford.

use crate::app::state::preferences::Preferences;
use crate::app::state::resolution::{Canvas, Resolution};
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use bevy::window::PrimaryWindow;
use lightfall_platform::IN_BROWSER;
use wgpu::DeviceType;

/// Most pixels of a picture without cells on an adapter that shares the processor's memory: those
/// of a common large monitor.
const MAX_INTEGRATED_PIXELS: u64 = 2560 * 1440;
/// The same on a software renderer. Two processor cores trace this picture in half a second.
const MAX_SOFTWARE_PIXELS: u64 = 1600 * 900;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, measure_canvas);
}

/// The kind of the adapter. A browser tells a software adapter from the others only, which then count
/// as parts of the processor.
pub(super) fn assumed_kind(info: &RenderAdapterInfo) -> DeviceType {
    match info.device_type {
        DeviceType::Cpu => DeviceType::Cpu,
        _ if IN_BROWSER => DeviceType::IntegratedGpu,
        kind => kind,
    }
}

/// Tells the resolution how large the window is and how many pixels it may trace.
pub(super) fn measure_canvas(
    window: Single<&Window, With<PrimaryWindow>>,
    preferences: Res<Preferences>,
    adapter: Option<Res<RenderAdapterInfo>>,
    mut resolution: ResMut<Resolution>,
) {
    let size = window.physical_size();
    // A minimised window keeps its picture.
    if size.min_element() == 0 {
        return;
    }
    let max_pixels = match adapter.map(|info| assumed_kind(&info)) {
        Some(DeviceType::Cpu) => MAX_SOFTWARE_PIXELS,
        Some(DeviceType::IntegratedGpu) => MAX_INTEGRATED_PIXELS,
        _ => u64::MAX,
    };
    resolution.set_canvas(Canvas {
        size,
        shape: preferences.settings.picture_shape,
        max_pixels,
    });
}
