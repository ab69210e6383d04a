//! `lightfall bench --refine`: how far the article's methods can be refined.

use crate::commands::circumstances::circumstances;
use crate::commands::cli::BenchArgs;
use crate::commands::output::{print, write_report, write_tables};
use crate::commands::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_core::reports::bench::{Plan, plot_refinements, refinement_table};
use lightfall_core::reports::export::{csv, json};

/// Measures the errors of every series, and prints and writes their report.
pub(super) fn bench_refinements(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let refinable = |scene| !plan.refinable(scene).is_empty();
    if !plan.scenes.iter().any(|scene| refinable(&scene.scene)) {
        return Err(Stop::refused(
            "no method of --methods can be refined in a scene of --scenes: only verlet and kerr-schild \
             have these settings, and verlet needs hole.spin = 0",
        ));
    }
    let rows = plan
        .run_refinements(gpu, |row| {
            eprintln!(
                "lightfall: bench: {}, {}, {} {}",
                row.scene,
                row.method,
                row.study.word(),
                row.label
            );
        })
        .map_err(Stop::failed)?;
    let circumstances = circumstances(gpu, "refine", "that of each scene".into(), "compute");
    let (json, table) = (json(&circumstances, &rows), refinement_table(&rows));
    if let Some(folder) = &args.out {
        let csv = csv(&circumstances, &rows);
        write_tables(folder, "refine", [&csv, &json, &table])?;
        let about = format!("{} rays, {}", plan.rays, circumstances.adapter);
        for scene in &plan.scenes {
            let plot = plot_refinements(&scene.name, &about, &rows).map_err(Stop::failed)?;
            if let Some(svg) = plot {
                write_report(folder, &format!("refine-{}.svg", scene.name), &svg)?;
            }
        }
    }
    print(if args.json { &json } else { &table })
}
