//! `lightfall bench --delay`: the error of the time between emission and arrival against the run time.

use super::row_report::RowReport;
use crate::commands::circumstances::circumstances_of;
use crate::commands::cli::BenchArgs;
use crate::commands::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_lab::bench::{DelayMeasurement, Plan, delay_table};

/// Measures the delays, and prints and writes their report.
pub(super) fn bench_delays(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let circumstances = circumstances_of(plan, gpu, args.entry);
    let left = |known: usize| plan.delay_rows().saturating_sub(known) as f64;
    let mut report = RowReport::<DelayMeasurement>::begin(args, "delay", circumstances, left);
    let rows = plan
        .run_delays(gpu, &report.rows(), |row| {
            let task = format!("{}, {}, {} nodes", row.scene, row.method, row.nodes);
            report.keep([row.clone()]);
            report.advance(task, 1.0);
        })
        .map_err(Stop::failed)?;
    report.finish(&rows, &delay_table(&rows))
}
