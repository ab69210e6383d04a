//! The choice of the graphics adapter: the one that the environment names (the command line is
//! copied there), else the preferred one, else the fastest.

use super::error::GpuError;
use super::requirements::Abilities;
use serde::{Deserialize, Serialize};
use std::env;
use std::fmt::{Display, Formatter};
use std::sync::{Mutex, MutexGuard, PoisonError};
use wgpu::{Adapter, AdapterInfo, Backends, DeviceType, Features, Instance, InstanceFlags, Limits};

/// An adapter by its full name and its interface: on some systems one adapter has several
/// interfaces.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AdapterName {
    /// The name that its driver gives.
    pub name: String,
    /// vulkan, metal, dx12 or gl.
    pub backend: String,
}

impl AdapterName {
    /// The name of an adapter.
    pub fn of(info: &AdapterInfo) -> Self {
        Self {
            name: info.name.clone(),
            backend: info.backend.to_str().to_owned(),
        }
    }
}

impl Display for AdapterName {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({})", self.name, self.backend)
    }
}

/// An adapter that could be chosen.
#[derive(Clone, Debug)]
pub struct Listed {
    /// Its name.
    pub name: AdapterName,
    /// Software, integrated and so on.
    pub kind: &'static str,
    /// Its driver, with the version.
    pub driver: String,
    /// Whether it can measure the duration of passes.
    pub timestamps: bool,
    /// Its limits.
    pub limits: Limits,
    /// What the passes need and it lacks, each as a clause. Empty if it can be used.
    pub missing: Vec<String>,
}

impl Display for Listed {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{} ({}, {}, {})",
            self.name.name, self.kind, self.name.backend, self.driver
        )
    }
}

/// The preferred adapter. It belongs to the whole process, as the environment does, because devices
/// are opened in many places.
static PREFERRED: Mutex<Option<AdapterName>> = Mutex::new(None);

/// Makes devices open on this adapter if it exists and the environment names no other one.
pub fn prefer(adapter: Option<AdapterName>) {
    replace_chosen(None);
    *locked(&PREFERRED) = adapter;
}

/// The adapter that replaces a chosen one without a device.
static REPLACEMENT: Mutex<Option<AdapterName>> = Mutex::new(None);

fn locked(name: &Mutex<Option<AdapterName>>) -> MutexGuard<'_, Option<AdapterName>> {
    name.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Sets the adapter that replaces the chosen one; `None` tries the chosen one again.
pub(super) fn replace_chosen(name: Option<AdapterName>) {
    *locked(&REPLACEMENT) = name;
}

/// The value of an environment variable, unless it is empty.
fn variable(name: &str) -> Option<String> {
    env::var(name).ok().filter(|value| !value.is_empty())
}

/// The environment variable that chooses the adapter, if one is set.
pub fn named_by_environment() -> Option<&'static str> {
    let variables = [
        "WGPU_ADAPTER_NAME",
        "WGPU_BACKEND",
        "WGPU_FORCE_FALLBACK_ADAPTER",
    ];
    let is_set = |name: &&str| variable(name).is_some();
    variables.into_iter().find(is_set)
}

/// The backends that the program draws with: those of `WGPU_BACKEND`, else Vulkan, Metal and DX12.
/// OpenGL is left out: it lacks features that the passes need, and its drivers print messages when
/// they are queried.
fn backends() -> Backends {
    let named = variable("WGPU_BACKEND");
    named.map_or(Backends::PRIMARY, |names| Backends::from_comma_list(&names))
}

/// The error if there is no adapter: no driver at all, or none for the interface that the
/// environment names.
fn no_adapter() -> GpuError {
    let others = Instance::enabled_backend_features().difference(backends() | Backends::NOOP);
    let mut available: Vec<&str> = adapters_of(others)
        .iter()
        .map(|adapter| adapter.get_info().backend.to_str())
        .collect();
    available.sort_unstable();
    available.dedup();
    match variable("WGPU_BACKEND") {
        Some(given) if !available.is_empty() => GpuError::UnknownBackend { given, available },
        _ => hidden_error(|_| true).unwrap_or(GpuError::NoAdapter),
    }
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
fn hidden_error(asked: impl Fn(&str) -> bool) -> Option<GpuError> {
    let names: Vec<String> = hidden_adapters()
        .iter()
        .filter(|adapter| asked(&adapter.name.name.to_lowercase()))
        .map(ToString::to_string)
        .collect();
    (!names.is_empty()).then_some(GpuError::HiddenAdapters { names })
}

/// Every adapter of these interfaces.
fn adapters_of(backends: Backends) -> Vec<Adapter> {
    pollster::block_on(instance(backends).enumerate_adapters(backends))
}

/// Every adapter that can be chosen, in wgpu's order.
pub(super) async fn every_adapter() -> Vec<Adapter> {
    instance(backends()).enumerate_adapters(backends()).await
}

/// The choice for code that opens a device by itself, as Bevy does: the backends, and the name of
/// the preferred adapter if it exists, or of the one that replaces an adapter without a device.
pub fn chosen() -> (Backends, Option<String>) {
    let preferred =
        preferred().filter(|preferred| adapters().iter().any(|listed| listed.name == *preferred));
    match locked(&REPLACEMENT).clone().or(preferred) {
        Some(AdapterName { name, backend }) => (Backends::from_comma_list(&backend), Some(name)),
        None => (backends(), None),
    }
}

fn preferred() -> Option<AdapterName> {
    let preferred = locked(&PREFERRED).clone();
    preferred.filter(|_| named_by_environment().is_none())
}

fn instance(backends: Backends) -> Instance {
    let descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    Instance::new(wgpu::InstanceDescriptor {
        backends,
        ..descriptor
    })
}

/// The adapter that Bevy would choose: the first whose name contains `WGPU_ADAPTER_NAME`, else the
/// preferred one, else a software adapter if `WGPU_FORCE_FALLBACK_ADAPTER` is 1, else the fastest.
pub(super) async fn adapter() -> Result<Adapter, GpuError> {
    if let Some(given) = variable("WGPU_ADAPTER_NAME") {
        let wanted = given.to_lowercase();
        let adapters = every_adapter().await;
        let name = |adapter: &Adapter| adapter.get_info().name;
        let names: Vec<String> = adapters.iter().map(name).collect();
        let mut adapters = adapters.into_iter();
        return match adapters.find(|adapter| name(adapter).to_lowercase().contains(&wanted)) {
            Some(adapter) => Ok(adapter),
            None if names.is_empty() => Err(no_adapter()),
            None => Err(hidden_error(|name| name.contains(&wanted))
                .unwrap_or(GpuError::UnknownAdapter { given, names })),
        };
    }
    let wanted = locked(&REPLACEMENT).clone().or_else(preferred);
    if let Some(wanted) = wanted {
        let mut adapters = every_adapter().await.into_iter();
        if let Some(adapter) =
            adapters.find(|adapter| AdapterName::of(&adapter.get_info()) == wanted)
        {
            return Ok(adapter);
        }
    }
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::from_env()
            .unwrap_or(wgpu::PowerPreference::HighPerformance),
        force_fallback_adapter: variable("WGPU_FORCE_FALLBACK_ADAPTER")
            .is_some_and(|flag| flag == "1"),
        compatible_surface: None,
    };
    instance(backends())
        .request_adapter(&options)
        .await
        .map_err(|_| no_adapter())
}

/// Checks that there is an adapter to draw with.
///
/// # Errors
/// There is none, or none that the environment asks for.
pub fn check_adapter() -> Result<(), GpuError> {
    pollster::block_on(adapter()).map(drop)
}

/// Every adapter that can be chosen. If several have the same name and interface, only the first is
/// listed, which is the one that would be used.
pub fn adapters() -> Vec<Listed> {
    list(adapters_of(backends()))
}

fn list(adapters: Vec<Adapter>) -> Vec<Listed> {
    let mut listed: Vec<Listed> = Vec::new();
    for adapter in adapters {
        let info = adapter.get_info();
        let name = AdapterName::of(&info);
        if listed.iter().all(|other| other.name != name) {
            let timestamps = adapter.features().contains(Features::TIMESTAMP_QUERY);
            let abilities = Abilities::of(&adapter);
            listed.push(Listed {
                name,
                kind: kind(info.device_type),
                driver: driver(&info),
                timestamps,
                missing: abilities.missing(),
                limits: abilities.limits,
            });
        }
    }
    listed
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
