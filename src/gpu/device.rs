//! A graphics device without a window.

use super::GpuError;
use std::env;
use std::sync::Mutex;
use wgpu::{Adapter, AdapterInfo, Backends, Device, Instance, Queue, ShaderModule};

/// A device, its queue, and which adapter they belong to.
#[derive(Debug)]
pub struct Gpu {
    /// The device.
    pub device: Device,
    /// Its queue.
    pub queue: Queue,
    /// Name, driver and backend of the adapter.
    pub info: AdapterInfo,
    /// Held while an error scope is open.
    scope: Mutex<()>,
}

/// The backends that the program draws with: those of `WGPU_BACKEND`, else the first-class ones. OpenGL is left out, for
/// it lacks what the passes need and is noisy to ask.
pub fn backends() -> Backends {
    Backends::from_env().unwrap_or(Backends::PRIMARY)
}

fn instance() -> Instance {
    let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    Instance::new(wgpu::InstanceDescriptor { backends: backends(), ..descriptor })
}

/// The adapter that Bevy would choose: the fastest, or the first whose name contains `WGPU_ADAPTER_NAME`, a software one if
/// `WGPU_FORCE_FALLBACK_ADAPTER` is 1.
async fn adapter() -> Result<Adapter, GpuError> {
    let instance = instance();
    let name = env::var("WGPU_ADAPTER_NAME").ok().filter(|name| !name.is_empty());
    let Some(given) = name else {
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::from_env().unwrap_or(wgpu::PowerPreference::HighPerformance),
            force_fallback_adapter: env::var("WGPU_FORCE_FALLBACK_ADAPTER").is_ok_and(|flag| flag == "1"),
            compatible_surface: None,
        };
        return instance.request_adapter(&options).await.map_err(|_| GpuError::NoAdapter);
    };
    let wanted = given.to_lowercase();
    let adapters = instance.enumerate_adapters(backends()).await;
    let names: Vec<String> = adapters.iter().map(|adapter| adapter.get_info().name).collect();
    let found = adapters.into_iter().find(|adapter| adapter.get_info().name.to_lowercase().contains(&wanted));
    found.ok_or(if names.is_empty() { GpuError::NoAdapter } else { GpuError::UnknownAdapter { given, names } })
}

/// Whether there is an adapter to draw with.
///
/// # Errors
/// There is none.
pub fn check_adapter() -> Result<(), GpuError> {
    pollster::block_on(adapter()).map(drop)
}

/// Every adapter that could be chosen, one line each: name, kind and driver.
pub fn adapters() -> Vec<String> {
    let adapters = pollster::block_on(instance().enumerate_adapters(backends()));
    let line = |adapter: Adapter| {
        let info = adapter.get_info();
        let kind = match info.device_type {
            wgpu::DeviceType::Cpu => "software",
            wgpu::DeviceType::IntegratedGpu => "integrated",
            wgpu::DeviceType::DiscreteGpu => "discrete",
            wgpu::DeviceType::VirtualGpu => "virtual",
            wgpu::DeviceType::Other => "other",
        };
        format!("{} ({kind}, {}, {} {})", info.name, info.backend, info.driver, info.driver_info)
    };
    adapters.into_iter().map(line).collect()
}

impl Gpu {
    /// The device of the adapter that Bevy would choose; see [`check_adapter`].
    ///
    /// # Errors
    /// No adapter, or one that gives no device.
    pub fn headless() -> Result<Self, GpuError> {
        pollster::block_on(async {
            let adapter = adapter().await?;
            let descriptor = wgpu::DeviceDescriptor {
                label: Some("lightfall"),
                required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
                required_limits: adapter.limits(),
                ..Default::default()
            };
            let (device, queue) =
                adapter.request_device(&descriptor).await.map_err(|error| GpuError::Device(error.to_string()))?;
            Ok(Self { device, queue, info: adapter.get_info(), scope: Mutex::new(()) })
        })
    }

    /// A compiled shader, without the run-time checks that Bevy leaves out too, so that what is tested and measured is
    /// what is drawn.
    ///
    /// # Errors
    /// The compiler's message.
    pub fn shader(&self, label: &str, source: &str) -> Result<ShaderModule, GpuError> {
        let source = wgpu::ShaderSource::Wgsl(source.into());
        let module = self.validated(|| self.unchecked(wgpu::ShaderModuleDescriptor { label: Some(label), source }));
        module.map_err(GpuError::Shader)
    }

    /// What `work` gives, or what the device has to say against it.
    pub(super) fn validated<T>(&self, work: impl FnOnce() -> T) -> Result<T, String> {
        // A device's error scopes may be one stack for all threads, so only one is open at a time.
        let _alone = self.scope.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let done = work();
        pollster::block_on(scope.pop()).map_or(Ok(done), |error| Err(error.to_string()))
    }

    #[expect(unsafe_code, reason = "the only way to the module that Bevy makes, too")]
    fn unchecked(&self, descriptor: wgpu::ShaderModuleDescriptor<'_>) -> ShaderModule {
        // SAFETY: the shaders are this crate's own; each bounds its loops by constants and its indices by lengths.
        unsafe { self.device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked()) }
    }
}
