//! A graphics device without a window.

use super::error::GpuError;
use super::fallback::open;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use wgpu::{AdapterInfo, Device, ErrorFilter, Queue, ShaderModule};

/// A device with its queue and the description of its adapter.
#[derive(Debug)]
pub struct Gpu {
    /// The device.
    pub device: Device,
    /// The device's queue.
    pub queue: Queue,
    /// Name, driver and backend of the adapter.
    pub info: AdapterInfo,
    /// Held while error scopes are open.
    scope: Mutex<()>,
    /// The reason why the device is lost, once it is.
    lost: Arc<OnceLock<String>>,
}

impl Gpu {
    /// Opens a device of the adapter that Bevy would choose, see
    /// [`check_adapter`](super::check_adapter).
    ///
    /// # Errors
    /// There is no adapter, or it provides no device; or the program runs in a browser.
    pub fn headless() -> Result<Self, GpuError> {
        if cfg!(target_arch = "wasm32") {
            return Err(GpuError::InBrowser);
        }
        pollster::block_on(async {
            let ((adapter, device, queue), _) = open(|adapter| wgpu::DeviceDescriptor {
                label: Some("lightfall"),
                required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
                required_limits: adapter.limits(),
                ..Default::default()
            })
            .await?;
            let lost = Arc::new(OnceLock::new());
            let reason = Arc::clone(&lost);
            device.set_device_lost_callback(move |_, message| {
                reason.get_or_init(|| message);
            });
            Ok(Self {
                device,
                queue,
                info: adapter.get_info(),
                scope: Mutex::new(()),
                lost,
            })
        })
    }

    /// Compiles a shader without run-time checks, as Bevy does, so that tests and measurements run
    /// the same code as pictures.
    ///
    /// # Errors
    /// [`GpuError::Shader`] with the compiler's message.
    pub fn shader(&self, label: &str, source: &str) -> Result<ShaderModule, GpuError> {
        let source = wgpu::ShaderSource::Wgsl(source.into());
        let module = self.validated(|| {
            self.unchecked_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source,
            })
        });
        module.map_err(|error| match error {
            GpuError::Invalid(message) => GpuError::Shader(message),
            other => other,
        })
    }

    /// The result of `work`, or the error that the device reports about its commands:
    /// [`GpuError::Invalid`], [`GpuError::OutOfMemory`] or, for a lost device,
    /// [`GpuError::Device`].
    pub(super) fn validated<T>(&self, work: impl FnOnce() -> T) -> Result<T, GpuError> {
        // All threads may share one stack of error scopes, so only one thread opens scopes at a
        // time.
        let _lock = self.scope.lock().unwrap_or_else(PoisonError::into_inner);
        self.check_not_lost()?;
        let memory = self.device.push_error_scope(ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(ErrorFilter::Validation);
        let done = work();
        let invalid = pollster::block_on(validation.pop());
        let out_of_memory = pollster::block_on(memory.pop());
        // A lost device reports no other errors, but leaves its resources invalid.
        self.check_not_lost()?;
        // A buffer that could not be allocated is invalid in every later command, so the lack of
        // memory is the cause.
        match (out_of_memory, invalid) {
            (Some(error), _) => Err(GpuError::OutOfMemory(error.to_string())),
            (None, Some(error)) => Err(GpuError::Invalid(error.to_string())),
            (None, None) => Ok(done),
        }
    }

    /// Checks that the device still works.
    fn check_not_lost(&self) -> Result<(), GpuError> {
        // Polling calls the callback that notes the loss.
        self.device
            .poll(wgpu::PollType::Poll)
            .map_err(GpuError::device_failed)?;
        match self.lost.get() {
            Some(reason) => Err(GpuError::device_failed(reason)),
            None => Ok(()),
        }
    }

    #[expect(
        unsafe_code,
        reason = "the only way to the same module that Bevy creates"
    )]
    fn unchecked_module(&self, descriptor: wgpu::ShaderModuleDescriptor<'_>) -> ShaderModule {
        // SAFETY: all shaders are this crate's own. Constants bound their loops, and array lengths
        // bound their indices.
        unsafe {
            self.device
                .create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked())
        }
    }
}
