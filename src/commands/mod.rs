//! The longer commands: measures, tells how far it is, writes the reports.

mod bench;
pub mod cli;
pub mod doctor;
mod extremes;
mod render;
mod run;

pub use run::run;

use crate::commands::run::{Stop, failed};
use crate::picture;
use indicatif::{ProgressBar, ProgressStyle};
use lightfall_core::gpu::Gpu;
use lightfall_core::reports::bench::Circumstances;
use std::io;
use std::path::Path;

/// A bar on standard error with what is being done and the time that is left; silent where nobody
/// watches.
fn progress(length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len}, {eta} left: {wide_msg}");
    ProgressBar::new(length as u64)
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

fn circumstances(gpu: &Gpu, size: String, entry: &str) -> Circumstances {
    let info = &gpu.info;
    Circumstances {
        adapter: info.name.clone(),
        driver: format!("{} {}", info.driver, info.driver_info)
            .trim()
            .to_owned(),
        backend: info.backend.to_string(),
        size,
        entry: entry.into(),
        commit: commit().unwrap_or_else(|| format!("version {}", env!("CARGO_PKG_VERSION"))),
        floor_ms: None,
        command: command(),
    }
}

/// The revision of the sources, where who runs the program says it in LIGHTFALL_COMMIT. Sources
/// that lie about may be others than those that the program was built from, so they are not asked.
fn commit() -> Option<String> {
    std::env::var("LIGHTFALL_COMMIT")
        .ok()
        .filter(|commit| !commit.is_empty())
}

/// The command line, with the program's own name first.
fn command() -> String {
    std::iter::once("lightfall".to_owned())
        .chain(std::env::args().skip(1))
        .collect::<Vec<_>>()
        .join(" ")
}

/// Makes the folder of the reports, before any work is done for them.
fn make_folder(folder: Option<&Path>) -> Result<(), Stop> {
    let Some(folder) = folder else { return Ok(()) };
    std::fs::create_dir_all(folder).map_err(|error| {
        let reason = match folder
            .ancestors()
            .find(|part| part.exists() && !part.is_dir())
        {
            Some(part) => format!(
                "{} is a file, and this must be a folder, or one that can be made",
                part.display()
            ),
            None => format!("this folder cannot be made: {error}"),
        };
        Stop(2, format!("--out {}: {reason}", folder.display()))
    })
}

/// Writes a report's file, whole or not at all.
fn write(folder: &Path, name: &str, text: &str) -> Result<(), Stop> {
    picture::write_text(&folder.join(name), text).map_err(failed)
}

/// Prints a result.
pub(crate) fn print(text: &str) -> Result<(), Stop> {
    cli::print(text, &mut io::stdout().lock())
        .map_err(|error| Stop(error.exit_code(), error.to_string()))
}
