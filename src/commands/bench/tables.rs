//! The measurements of `lightfall bench` that make one table, row by row.

use super::row_report::RowReport;
use crate::commands::circumstances::{circumstances, circumstances_of};
use crate::commands::cli::{BenchArgs, EntryArg};
use crate::commands::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_lab::bench::{Plan, delay_table, light_table, refinement_table};

/// `lightfall bench --delay`: the error of the time between emission and arrival against the run
/// time.
pub(super) fn bench_delays(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let circumstances = circumstances_of(plan, gpu, args.entry);
    let mut report = RowReport::of_rows(args, "delay", circumstances, plan.delay_rows());
    let rows = plan.run_delays(gpu, &report.rows(), |row| {
        let task = format!("{}, {}, {} nodes", row.scene, row.method, row.nodes);
        report.add(row, task);
    });
    let rows = rows.map_err(Stop::failed)?;
    report.finish(&rows, &delay_table(&rows))
}

/// `lightfall bench --light`: the run time of a living disk's light over that of a smooth disk's.
pub(super) fn bench_light(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let circumstances = circumstances_of(plan, gpu, EntryArg::Compute);
    let mut report = RowReport::of_rows(args, "light", circumstances, plan.light_rows());
    let rows = plan.run_light(gpu, &report.rows(), |row| {
        report.add(row, format!("{}, {}", row.scene, row.method));
    });
    let rows = rows.map_err(Stop::failed)?;
    report.finish(&rows, &light_table(&rows))
}

/// `lightfall bench --refine`: how far the article's methods can be refined.
pub(super) fn bench_refinements(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    if plan.refinement_rows() == 0 {
        return Err(Stop::refused(
            "no method of --methods can be refined in a scene of --scenes: only verlet and kerr-schild \
             have these settings, and verlet needs hole.spin = 0",
        ));
    }
    let circumstances = circumstances(gpu, "that of each scene".into(), "compute");
    let mut report = RowReport::of_rows(args, "refine", circumstances, plan.refinement_rows());
    let rows = plan.run_refinements(gpu, &report.rows(), |row| {
        let study = row.study.word();
        let task = format!("{}, {}, {study} {}", row.scene, row.method, row.label());
        report.add(row, task);
    });
    let rows = rows.map_err(Stop::failed)?;
    report.finish(&rows, &refinement_table(&rows))
}
