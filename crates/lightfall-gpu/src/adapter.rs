//! The choice of the graphics adapter: the one that the environment names (the command line is
//! copied there), else the preferred one, else the fastest.

use super::adapter_list::{hidden_error, list, numbered};
use super::adapter_request::requested_place;
use super::error::GpuError;
use serde::{Deserialize, Serialize};
use std::env;
use std::fmt::{Display, Formatter};
use std::sync::{Mutex, MutexGuard, PoisonError};
use wgpu::{Adapter, AdapterInfo, Backends, Instance};

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

/// The variable that asks for an adapter by its number, its PCI bus id or a part of its name.
const NAME_VARIABLE: &str = "WGPU_ADAPTER_NAME";

/// The environment variable that chooses the adapter, if one is set.
pub fn named_by_environment() -> Option<&'static str> {
    let variables = [NAME_VARIABLE, "WGPU_BACKEND", "WGPU_FORCE_FALLBACK_ADAPTER"];
    let is_set = |name: &&str| variable(name).is_some();
    variables.into_iter().find(is_set)
}

/// The backends that the program draws with: those of `WGPU_BACKEND`, else Vulkan, Metal and DX12.
/// OpenGL is left out: it lacks features that the passes need, and its drivers print messages when
/// they are queried.
pub(super) fn backends() -> Backends {
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

/// Every adapter of these interfaces.
pub(super) fn adapters_of(backends: Backends) -> Vec<Adapter> {
    pollster::block_on(instance(backends).enumerate_adapters(backends))
}

/// Every adapter that can be chosen, in wgpu's order.
pub(super) async fn every_adapter() -> Vec<Adapter> {
    instance(backends()).enumerate_adapters(backends()).await
}

/// How code that opens a device by itself, as Bevy does, finds the adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The interfaces that are searched.
    pub backends: Backends,
    /// The name of the preferred adapter if it exists, or of the one that replaces an adapter without a
    /// device.
    pub name: Option<String>,
    /// The adapter's place among all of these interfaces, if a search by its name, or by that of the
    /// environment, finds another one.
    pub place: Option<usize>,
}

/// The choice for code that opens a device by itself.
pub fn chosen() -> Choice {
    if let Some(given) = variable(NAME_VARIABLE) {
        let infos = infos(&adapters_of(backends()));
        let place = requested_place(&given, &infos).ok();
        return Choice {
            backends: backends(),
            name: None,
            place: place.filter(|place| first_named(&given, &infos) != Some(*place)),
        };
    }
    let wanted = locked(&REPLACEMENT).clone().or_else(preferred);
    let found = wanted.and_then(|wanted| {
        let backends = Backends::from_comma_list(&wanted.backend);
        let infos = infos(&adapters_of(backends));
        let place = infos
            .iter()
            .position(|info| AdapterName::of(info) == wanted)?;
        let is_first = first_named(&wanted.name, &infos) == Some(place);
        Some(Choice {
            backends,
            name: Some(wanted.name),
            place: (!is_first).then_some(place),
        })
    });
    found.unwrap_or_else(|| Choice {
        backends: backends(),
        name: None,
        place: None,
    })
}

fn infos(adapters: &[Adapter]) -> Vec<AdapterInfo> {
    adapters.iter().map(Adapter::get_info).collect()
}

/// The place of the adapter that Bevy finds by a name.
fn first_named(name: &str, infos: &[AdapterInfo]) -> Option<usize> {
    let name = name.to_lowercase();
    infos
        .iter()
        .position(|info| info.name.to_lowercase().contains(&name))
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

/// The adapter to use: the one that `WGPU_ADAPTER_NAME` asks for, else the preferred one, else a
/// software adapter if `WGPU_FORCE_FALLBACK_ADAPTER` is 1, else the fastest.
pub(super) async fn adapter() -> Result<Adapter, GpuError> {
    if let Some(given) = variable(NAME_VARIABLE) {
        let mut adapters = every_adapter().await;
        return match requested_place(&given, &infos(&adapters)) {
            Ok(place) => Ok(adapters.swap_remove(place)),
            Err(_) if adapters.is_empty() => Err(no_adapter()),
            Err(meant) => Err(refused_request(given, &meant, adapters)),
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

/// The error about a request that means none of the adapters or, in these places, several.
fn refused_request(given: String, meant: &[usize], adapters: Vec<Adapter>) -> GpuError {
    let lines = numbered(&list(adapters));
    if meant.is_empty() {
        let wanted = given.to_lowercase();
        let adapters = lines;
        return hidden_error(|name| name.contains(&wanted))
            .unwrap_or(GpuError::UnknownAdapter { given, adapters });
    }
    let adapters = meant.iter().map(|place| lines[*place].clone()).collect();
    GpuError::SeveralAdapters { given, adapters }
}

/// Checks that there is an adapter to draw with.
///
/// # Errors
/// There is none, or none that the environment asks for.
pub fn check_adapter() -> Result<(), GpuError> {
    pollster::block_on(adapter()).map(drop)
}
