//! `lightfall bench`: error against run time.

mod delays;
mod light;
mod methods;
mod pictures;
mod refine;
mod row_report;

use super::circumstances::circumstances;
use super::cli::{BenchArgs, EntryArg};
use super::output::{create_report_folder, write_report};
use super::scene::device;
use super::stop::Stop;
use delays::bench_delays;
use light::bench_light;
use lightfall_core::gpu::Gpu;
use lightfall_core::reports::bench::Plan;
use lightfall_core::reports::circumstances::Circumstances;
use methods::bench_methods;
use pictures::bench_pictures;
use refine::bench_refinements;
use std::path::Path;

/// Measures, and prints and writes the report.
pub(super) fn bench(args: &BenchArgs) -> Result<(), Stop> {
    create_report_folder(args.out.as_deref())?;
    let gpu = device()?;
    let plan = args.plan();
    if plan.is_empty() {
        return Err(Stop::refused(
            "no method of --methods can trace a scene of --scenes: verlet needs hole.spin = 0",
        ));
    }
    let run = match args {
        BenchArgs { pictures: true, .. } => bench_pictures,
        BenchArgs { delay: true, .. } => bench_delays,
        BenchArgs { refine: true, .. } => bench_refinements,
        BenchArgs { light: true, .. } => bench_light,
        _ => bench_methods,
    };
    run(args, &gpu, &plan)
}

/// What the plan is measured on, with this entry.
fn circumstances_of(plan: &Plan, gpu: &Gpu, report: &str, entry: EntryArg) -> Circumstances {
    let entry = match entry {
        EntryArg::Compute => "compute",
        EntryArg::Fragment => "fragment",
    };
    circumstances(
        gpu,
        report,
        format!("{}x{}", plan.size.x, plan.size.y),
        entry,
    )
}

/// Writes one plot per scene, as `prefix` and the scene's name. `plot` gets this name.
fn write_plots(
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
