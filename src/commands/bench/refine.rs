//! `lightfall bench --refine`: how far the article's methods can be refined.

use super::row_report::RowReport;
use crate::commands::circumstances::circumstances;
use crate::commands::cli::BenchArgs;
use crate::commands::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_lab::bench::{Plan, RefinementMeasurement, refinement_table};

/// Measures the errors of every series, and prints and writes their report.
pub(super) fn bench_refinements(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    if plan.refinement_rows() == 0 {
        return Err(Stop::refused(
            "no method of --methods can be refined in a scene of --scenes: only verlet and kerr-schild \
             have these settings, and verlet needs hole.spin = 0",
        ));
    }
    let circumstances = circumstances(gpu, "that of each scene".into(), "compute");
    let left = |known: usize| plan.refinement_rows().saturating_sub(known) as f64;
    let mut report = RowReport::<RefinementMeasurement>::begin(args, "refine", circumstances, left);
    let rows = plan
        .run_refinements(gpu, &report.rows(), |row| {
            let study = row.study.word();
            let task = format!("{}, {}, {study} {}", row.scene, row.method, row.label());
            report.keep([row.clone()]);
            report.advance(task, 1.0);
        })
        .map_err(Stop::failed)?;
    report.finish(&rows, &refinement_table(&rows))
}
