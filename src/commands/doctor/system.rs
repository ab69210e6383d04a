//! The computer, and the display that a window would open on.

use crate::app::display;
use serde::Serialize;
use std::env::consts;
use std::fs::read_to_string;
use std::num::NonZero;
use std::thread::available_parallelism;

/// The computer.
#[derive(Clone, Debug, Serialize)]
pub struct System {
    /// Operating system, with its version if that is known.
    pub os: String,
    /// Architecture of the processor.
    pub architecture: &'static str,
    /// Number of processor cores that the program may use.
    pub cores: usize,
    /// The display server, if one responds.
    pub display: Option<String>,
    /// Why there is no display, if there is none.
    pub no_display: Option<String>,
}

impl System {
    /// Examines this computer.
    #[must_use]
    pub fn here() -> Self {
        let (display, no_display) = match display() {
            Ok(display) => (Some(display), None),
            Err(missing) => (None, Some(missing)),
        };
        Self {
            os: os(),
            architecture: consts::ARCH,
            cores: available_parallelism().map_or(1, NonZero::get),
            display,
            no_display,
        }
    }
}

/// The operating system. On Linux: the distribution from /etc/os-release (freedesktop.org) and the
/// kernel's version.
fn os() -> String {
    let release = read_to_string("/etc/os-release").unwrap_or_default();
    let distribution = release
        .lines()
        .find_map(|line| line.strip_prefix("PRETTY_NAME="))
        .map(|name| name.trim_matches('"'));
    let kernel = read_to_string("/proc/sys/kernel/osrelease")
        .ok()
        .map(|kernel| format!("{} {}", consts::OS, kernel.trim()));
    let parts: Vec<String> = distribution
        .map(str::to_owned)
        .into_iter()
        .chain(kernel)
        .collect();
    if parts.is_empty() {
        consts::OS.into()
    } else {
        parts.join(", ")
    }
}
