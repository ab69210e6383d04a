//! The window's pixels as the picture's canvas: the picture gets the shape of the part of the window
//! that the panels leave free, and without cells it is traced as finely as the window shows and the
//! adapter can afford.

use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use crate::app::state::resolution::{Canvas, Resolution};
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use bevy::window::PrimaryWindow;
use lightfall_platform::IN_BROWSER;
use lightfall_render::PictureArea;
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

/// Finds the part of the window for the picture, and tells the resolution how large it is and how many
/// pixels may be traced.
pub(super) fn measure_canvas(
    window: Single<&Window, With<PrimaryWindow>>,
    preferences: Res<Preferences>,
    overlays: Res<Overlays>,
    adapter: Option<Res<RenderAdapterInfo>>,
    mut resolution: ResMut<Resolution>,
    mut area: ResMut<PictureArea>,
) {
    let size = window.physical_size();
    // A minimised window keeps its picture.
    if size.min_element() == 0 {
        return;
    }
    let pixels_per_point = window.scale_factor() * preferences.settings.ui_scale;
    let span = overlays.free_span(size.x as f32 / pixels_per_point);
    let [left, right] = span.map_or([0, size.x], |span| {
        span.map(|end| (end * pixels_per_point).round() as u32)
    });
    let right = right.clamp(left + 1, size.x.max(left + 1));
    let max_pixels = match adapter.map(|info| assumed_kind(&info)) {
        Some(DeviceType::Cpu) => MAX_SOFTWARE_PIXELS,
        Some(DeviceType::IntegratedGpu) => MAX_INTEGRATED_PIXELS,
        _ => u64::MAX,
    };
    let free = URect {
        min: UVec2::new(left, 0),
        max: UVec2::new(right, size.y),
    };
    area.set_if_neq(PictureArea {
        part: free,
        ..*area
    });
    resolution.set_canvas(Canvas {
        size: free.size(),
        window: size,
        shape: preferences.settings.picture_shape,
        max_pixels,
    });
}
