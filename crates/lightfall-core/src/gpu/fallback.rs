//! The adapter that is used when the chosen one gives no device: some systems list adapters that
//! cannot be opened, such as a Direct3D 12 without a shader compiler.

use super::adapter::{AdapterName, adapter, every_adapter, named_by_environment, replace_chosen};
use super::error::GpuError;
use wgpu::{Adapter, Device, DeviceDescriptor, DeviceType, Queue};

/// An open device with its queue and adapter.
pub(super) type Opened = (Adapter, Device, Queue);

/// Opens a device of the chosen adapter or, unless the environment names one, of the next one that
/// gives a device. Also returns why each adapter before it gave none.
///
/// # Errors
/// There is no adapter, or none gives a device.
pub(super) async fn open(
    describe: impl Fn(&Adapter) -> DeviceDescriptor<'static>,
) -> Result<(Opened, Vec<String>), GpuError> {
    let chosen = adapter().await?;
    let mut candidates = vec![chosen];
    let mut failures = Vec::new();
    let mut others_are_listed = named_by_environment().is_some();
    while let Some(adapter) = candidates.pop() {
        let name = AdapterName::of(&adapter.get_info());
        match adapter.request_device(&describe(&adapter)).await {
            Ok((device, queue)) => {
                if !failures.is_empty() {
                    replace_chosen(Some(name));
                }
                return Ok(((adapter, device, queue), failures));
            }
            Err(error) => failures.push(format!("{name}: {error}")),
        }
        if !others_are_listed {
            others_are_listed = true;
            candidates = every_adapter().await;
            candidates.retain(|other| AdapterName::of(&other.get_info()) != name);
            // The last one is tried first.
            candidates.reverse();
            candidates.sort_by_key(|other| std::cmp::Reverse(rank(other.get_info().device_type)));
        }
    }
    Err(GpuError::NoDevice { failures })
}

/// The order in which kinds of adapters are tried.
fn rank(kind: DeviceType) -> u8 {
    match kind {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu | DeviceType::Other => 2,
        DeviceType::Cpu => 3,
    }
}

/// An adapter that has given a device.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkingAdapter {
    /// Its name with its interface and driver.
    pub description: String,
    /// Why each adapter before it gave no device. Empty for the chosen one.
    pub failures: Vec<String>,
}

/// Finds the adapter that is used: the chosen one or, if it gives no device, the next one that does.
///
/// # Errors
/// There is no adapter, or none gives a device.
pub fn working_adapter() -> Result<WorkingAdapter, GpuError> {
    let ((adapter, ..), failures) = pollster::block_on(open(|_| DeviceDescriptor::default()))?;
    let info = adapter.get_info();
    let name = AdapterName::of(&info);
    Ok(WorkingAdapter {
        description: format!("{name}, {} {}", info.driver, info.driver_info),
        failures,
    })
}
