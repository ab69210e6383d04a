//! The adapters of a machine, with what can be said of each.

use super::adapter::{AdapterName, adapters_of, backends};
use super::error::GpuError;
use super::requirements::Abilities;
use std::fmt::{Display, Formatter};
use wgpu::{Adapter, AdapterInfo, Backends, DeviceType, Features, Instance, InstanceFlags, Limits};

/// An adapter that could be chosen.
#[derive(Clone, Debug)]
pub struct Listed {
    /// Its name.
    pub name: AdapterName,
    /// Software, integrated and so on.
    pub kind: &'static str,
    /// Its driver, with the version.
    pub driver: String,
    /// Its place on the PCI bus, such as 0000:01:00.0. Empty if the interface does not tell it.
    pub pci_bus_id: String,
    /// Whether it can measure the duration of passes.
    pub timestamps: bool,
    /// Its limits.
    pub limits: Limits,
    /// What the passes need and it lacks, each as a clause. Empty if it can be used.
    pub missing: Vec<String>,
}

impl Display for Listed {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let AdapterName { name, backend } = &self.name;
        write!(f, "{name} ({}, {backend}, {}", self.kind, self.driver)?;
        if !self.pci_bus_id.is_empty() {
            write!(f, ", PCI {}", self.pci_bus_id)?;
        }
        f.write_str(")")
    }
}

impl Listed {
    /// Whether this is the adapter with these properties. Two programs of one name are not told apart.
    pub fn is(&self, info: &AdapterInfo) -> bool {
        self.name == AdapterName::of(info) && self.pci_bus_id == info.device_pci_bus_id
    }
}

/// Every adapter that can be chosen, in the order of their numbers.
pub fn adapters() -> Vec<Listed> {
    list(adapters_of(backends()))
}

pub(super) fn list(adapters: Vec<Adapter>) -> Vec<Listed> {
    let listed = adapters.into_iter().map(|adapter| {
        let info = adapter.get_info();
        let abilities = Abilities::of(&adapter);
        Listed {
            name: AdapterName::of(&info),
            kind: kind(info.device_type),
            driver: driver(&info),
            pci_bus_id: info.device_pci_bus_id,
            timestamps: adapter.features().contains(Features::TIMESTAMP_QUERY),
            missing: abilities.missing(),
            limits: abilities.limits,
        }
    });
    listed.collect()
}

/// Adapters as the user can ask for them, each with its number.
pub fn numbered(adapters: &[Listed]) -> Vec<String> {
    let line = |(place, adapter)| format!("{place}: {adapter}");
    adapters.iter().enumerate().map(line).collect()
}

/// The variable that makes wgpu show adapters whose drivers do not claim to conform to Vulkan.
pub const SHOW_HIDDEN: &str = "WGPU_ALLOW_UNDERLYING_NONCOMPLIANT_ADAPTER";

/// The adapters that wgpu hides because their drivers do not claim to conform to Vulkan.
fn hidden_adapters() -> Vec<Listed> {
    let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    let all = Instance::new(wgpu::InstanceDescriptor {
        backends: backends() & Backends::VULKAN,
        flags: descriptor.flags | InstanceFlags::ALLOW_UNDERLYING_NONCOMPLIANT_ADAPTER,
        ..descriptor
    });
    let all = pollster::block_on(all.enumerate_adapters(Backends::VULKAN));
    let shown = adapters();
    let is_hidden = |listed: &Listed| shown.iter().all(|other| other.name != listed.name);
    list(all).into_iter().filter(is_hidden).collect()
}

/// What is said of hidden adapters, and how to use one. `None` if there are none.
pub fn about_hidden_adapters() -> Option<String> {
    hidden_error(|_| true).map(|error| error.to_string())
}

/// The error about hidden adapters whose names are asked for, if there are any.
pub(super) fn hidden_error(asked: impl Fn(&str) -> bool) -> Option<GpuError> {
    let names: Vec<String> = hidden_adapters()
        .iter()
        .filter(|adapter| asked(&adapter.name.name.to_lowercase()))
        .map(ToString::to_string)
        .collect();
    (!names.is_empty()).then_some(GpuError::HiddenAdapters { names })
}

/// The driver of an adapter, with the version. Empty where the interface tells neither.
pub fn driver(info: &AdapterInfo) -> String {
    format!("{} {}", info.driver, info.driver_info)
        .trim()
        .to_owned()
}

/// The kind of an adapter in one word.
pub fn kind(kind: DeviceType) -> &'static str {
    match kind {
        DeviceType::Cpu => "software",
        DeviceType::IntegratedGpu => "integrated",
        DeviceType::DiscreteGpu => "discrete",
        DeviceType::VirtualGpu => "virtual",
        DeviceType::Other => "other",
    }
}
