//! A graphics device without a window.

use super::GpuError;
use super::adapter::adapter;
use std::sync::Mutex;
use wgpu::{AdapterInfo, Device, Queue, ShaderModule};

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

impl Gpu {
    /// The device of the adapter that Bevy would choose; see
    /// [`check_adapter`](super::check_adapter).
    ///
    /// # ErrorSummary
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
            let (device, queue) = adapter
                .request_device(&descriptor)
                .await
                .map_err(|error| GpuError::Device(error.to_string()))?;
            Ok(Self {
                device,
                queue,
                info: adapter.get_info(),
                scope: Mutex::new(()),
            })
        })
    }

    /// A compiled shader, without the run-time checks that Bevy leaves out too, so that what is
    /// tested and measured is what is drawn.
    ///
    /// # ErrorSummary
    /// The compiler's message.
    pub fn shader(&self, label: &str, source: &str) -> Result<ShaderModule, GpuError> {
        let source = wgpu::ShaderSource::Wgsl(source.into());
        let module = self.validated(|| {
            self.unchecked(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source,
            })
        });
        module.map_err(GpuError::Shader)
    }

    /// What `work` gives, or what the device has to say against it.
    pub(super) fn validated<T>(&self, work: impl FnOnce() -> T) -> Result<T, String> {
        // A device's error scopes may be one stack for all threads, so only one is open at a time.
        let _alone = self
            .scope
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner);
        let scope = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let done = work();
        pollster::block_on(scope.pop()).map_or(Ok(done), |error| Err(error.to_string()))
    }

    #[expect(
        unsafe_code,
        reason = "the only way to the module that Bevy makes, too"
    )]
    fn unchecked(&self, descriptor: wgpu::ShaderModuleDescriptor<'_>) -> ShaderModule {
        // SAFETY: the shaders are this crate's own; each bounds its loops by constants and its
        // indices by lengths.
        unsafe {
            self.device
                .create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked())
        }
    }
}
