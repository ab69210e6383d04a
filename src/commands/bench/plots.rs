//! The plots of the reports of `lightfall bench`.

use crate::commands::output::write_report;
use crate::commands::stop::Stop;
use lightfall_core::reports::bench::Plan;
use std::path::Path;

/// Writes one plot per scene, as `prefix` and the scene's name. `plot` gets this name.
pub(super) fn write_plots(
    folder: &Path,
    prefix: &str,
    plan: &Plan,
    plot: impl Fn(&str) -> Result<Option<String>, String>,
) -> Result<(), Stop> {
    for scene in &plan.scenes {
        if let Some(svg) = plot(&scene.name).map_err(Stop::failed)? {
            write_report(folder, &format!("{prefix}{}.svg", scene.name), &svg)?;
        }
    }
    Ok(())
}
