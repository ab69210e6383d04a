//! How Bevy opens its graphics device.

use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::renderer::{
    RenderAdapter, RenderAdapterInfo, RenderDevice, RenderInstance, RenderQueue, WgpuWrapper,
};
use bevy::render::settings::{RenderCreation, RenderResources, WgpuFeatures, WgpuSettings};
use bevy::tasks::block_on;
use lightfall_core::gpu::{Choice, chosen};
use std::sync::Arc;
use wgpu::{
    BackendOptions, DeviceDescriptor, DeviceType, Dx12BackendOptions, Features, Instance,
    InstanceDescriptor,
};

/// Bevy's renderer, on the same backends and adapter as
/// [`Gpu::headless`](lightfall_core::gpu::Gpu::headless). A still compiles its pipelines
/// synchronously; a window does not.
pub fn render_plugin(synchronous_pipeline_compilation: bool) -> RenderPlugin {
    RenderPlugin {
        render_creation: render_creation(),
        synchronous_pipeline_compilation,
        ..default()
    }
}

/// How the renderer gets its device: by itself, or from here where the name of the chosen adapter is
/// that of another one, too, and Bevy would open the other one.
pub(super) fn render_creation() -> RenderCreation {
    let Choice {
        backends,
        name,
        place,
    } = chosen();
    let settings = WgpuSettings {
        backends: Some(backends),
        adapter_name: name,
        // Every feature that the adapter has is used. By default Bevy insists on one that the passes
        // do not need, and panics on an adapter without it.
        features: WgpuFeatures::empty(),
        ..default()
    };
    let opened = place.and_then(|place| block_on(open(&settings, place)));
    opened.map_or_else(|| settings.into(), RenderCreation::Manual)
}

/// Opens a device of the adapter in this place among those of the settings' backends, as Bevy does. `None`
/// if there is none.
async fn open(settings: &WgpuSettings, place: usize) -> Option<RenderResources> {
    let backends = settings.backends?;
    let usual = InstanceDescriptor::new_without_display_handle_from_env();
    let instance = Instance::new(InstanceDescriptor {
        backends,
        flags: settings.instance_flags,
        memory_budget_thresholds: settings.instance_memory_budget_thresholds,
        backend_options: BackendOptions {
            dx12: Dx12BackendOptions {
                shader_compiler: settings.dx12_shader_compiler.clone(),
                ..usual.backend_options.dx12
            },
            ..usual.backend_options
        },
        ..usual
    });
    let adapters = instance.enumerate_adapters(backends).await;
    let adapter = adapters.into_iter().nth(place)?;
    let info = adapter.get_info();
    let mut features = adapter.features() - Features::all_experimental_mask();
    if info.device_type == DeviceType::DiscreteGpu {
        // With this feature, buffers of a card can be read across the bus, and become slow.
        features.remove(Features::MAPPABLE_PRIMARY_BUFFERS);
    }
    let description = DeviceDescriptor {
        required_features: features,
        required_limits: adapter.limits(),
        memory_hints: settings.memory_hints.clone(),
        ..default()
    };
    let (device, queue) = adapter.request_device(&description).await.ok()?;
    Some(RenderResources(
        RenderDevice::from(device),
        RenderQueue(Arc::new(WgpuWrapper::new(queue))),
        RenderAdapterInfo(WgpuWrapper::new(info)),
        RenderAdapter(Arc::new(WgpuWrapper::new(adapter))),
        RenderInstance(Arc::new(WgpuWrapper::new(instance))),
    ))
}
