//! The circumstances of a measurement: machine, program and command line.

use lightfall_core::gpu::{Gpu, driver};
use lightfall_lab::bench::Plan;
use lightfall_lab::circumstances::{Circumstances, date};
use std::time::{SystemTime, UNIX_EPOCH};

/// The circumstances of a report made now on this device.
pub(super) fn circumstances(gpu: &Gpu, size: String, entry: &str) -> Circumstances {
    let info = &gpu.info;
    Circumstances {
        adapter: info.name.clone(),
        driver: driver(info),
        backend: info.backend.to_string(),
        size,
        entry: entry.into(),
        ..circumstances_of_core()
    }
}

/// The circumstances of a report made now on one core of the processor.
pub(super) fn circumstances_of_core() -> Circumstances {
    use std::env::consts::{ARCH, OS};
    Circumstances {
        adapter: "one core of the processor".into(),
        driver: format!("{ARCH}, {OS}"),
        backend: "none".into(),
        size: "none".into(),
        entry: "none".into(),
        commit: commit().unwrap_or_else(|| format!("version {}", env!("CARGO_PKG_VERSION"))),
        date: date(
            SystemTime::now()
                .duration_since(UNIX_EPOCH)
                .unwrap_or_default(),
        ),
        floor_ms: None,
        command: command_line(),
    }
}

/// What the plan is measured on.
pub(super) fn circumstances_of(plan: &Plan, gpu: &Gpu) -> Circumstances {
    let size = format!("{}x{}", plan.size.x, plan.size.y);
    circumstances(gpu, size, plan.stage.word())
}

/// The revision of the sources, if the environment variable LIGHTFALL_COMMIT names it. Git is not
/// asked: the sources in the current folder may differ from those that the program was built from.
pub(super) fn commit() -> Option<String> {
    std::env::var("LIGHTFALL_COMMIT")
        .ok()
        .filter(|commit| !commit.is_empty())
}

/// The command line, with `lightfall` in place of the program's path.
fn command_line() -> String {
    std::iter::once("lightfall".to_owned())
        .chain(std::env::args().skip(1))
        .collect::<Vec<_>>()
        .join(" ")
}
