//! The replacement of a chosen adapter that cannot be used: some systems list adapters that give no
//! device, such as Direct3D 12 without a shader compiler, or whose driver is too old.

use super::adapter::{AdapterName, adapter, every_adapter, named_by_environment, replace_chosen};
use super::adapter_list::driver;
use super::error::GpuError;
use super::requirements::Abilities;
use wgpu::{Adapter, Device, DeviceDescriptor, DeviceType, Features, Queue};

/// An open device with its queue and adapter.
pub(super) type Opened = (Adapter, Device, Queue);

/// Opens a device of the chosen adapter or, unless the environment names one, of the next one that
/// has what the passes need and gives a device. Also returns why each adapter before it was not
/// used.
///
/// # Errors
/// There is no adapter, or none can be used.
pub(super) async fn open(
    describe: impl Fn(&Adapter) -> DeviceDescriptor<'static>,
) -> Result<(Opened, Vec<String>), GpuError> {
    let chosen = adapter().await?;
    let mut candidates = vec![chosen];
    let mut failures = Vec::new();
    let mut others_are_listed = named_by_environment().is_some();
    while let Some(adapter) = candidates.pop() {
        let name = AdapterName::of(&adapter.get_info());
        match open_one(&adapter, &describe(&adapter)).await {
            Ok((device, queue)) => {
                if !failures.is_empty() {
                    replace_chosen(Some(name));
                }
                return Ok(((adapter, device, queue), failures));
            }
            Err(reason) => failures.push(format!("{name}: {reason}")),
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

/// Opens a device, or says why there is none.
async fn open_one(
    adapter: &Adapter,
    description: &DeviceDescriptor<'_>,
) -> Result<(Device, Queue), String> {
    let missing = Abilities::of(adapter).missing();
    if !missing.is_empty() {
        return Err(missing.join(", "));
    }
    let opened = adapter.request_device(description).await;
    opened.map_err(|error| error.to_string())
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

/// An adapter that can be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WorkingAdapter {
    /// Its name with its interface and driver.
    pub description: String,
    /// Why each adapter before it cannot be used. Empty for the chosen one.
    pub failures: Vec<String>,
}

/// Finds the adapter that is used: the chosen one or, if it cannot be, the next one that can.
///
/// The device that this opens has every feature and the limits of its adapter, as Bevy's device
/// has, so that a driver that refuses one refuses both.
///
/// # Errors
/// There is no adapter, or none can be used.
pub fn working_adapter() -> Result<WorkingAdapter, GpuError> {
    let ((adapter, ..), failures) = pollster::block_on(open(|adapter| DeviceDescriptor {
        required_features: adapter.features() - Features::all_experimental_mask(),
        required_limits: adapter.limits(),
        ..Default::default()
    }))?;
    let info = adapter.get_info();
    let name = AdapterName::of(&info);
    Ok(WorkingAdapter {
        description: format!("{name}, {}", driver(&info)),
        failures,
    })
}
