//! How Bevy opens its graphics device.

use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::settings::{WgpuFeatures, WgpuSettings};

/// Bevy's renderer, on the same backends and adapter as
/// [`Gpu::headless`](lightfall_core::gpu::Gpu::headless). A still compiles its pipelines
/// synchronously; a window does not.
pub fn render_plugin(synchronous_pipeline_compilation: bool) -> RenderPlugin {
    RenderPlugin {
        render_creation: wgpu_settings().into(),
        synchronous_pipeline_compilation,
        ..default()
    }
}

pub(super) fn wgpu_settings() -> WgpuSettings {
    let (backends, adapter_name) = lightfall_core::gpu::chosen();
    WgpuSettings {
        backends: Some(backends),
        adapter_name,
        // Every feature that the adapter has is used. By default Bevy insists on one that the passes
        // do not need, and panics on an adapter without it.
        features: WgpuFeatures::empty(),
        ..default()
    }
}
