//! `lightfall bench --light`: the run time of a living disk's light over that of a smooth disk's.

use super::row_report::RowReport;
use crate::commands::circumstances::circumstances_of;
use crate::commands::cli::{BenchArgs, EntryArg};
use crate::commands::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_lab::bench::{LightMeasurement, Plan, light_table};

/// Times the light of living disks, and prints and writes the report.
pub(super) fn bench_light(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let circumstances = circumstances_of(plan, gpu, EntryArg::Compute);
    let left = |known: usize| plan.light_rows().saturating_sub(known) as f64;
    let mut report = RowReport::<LightMeasurement>::begin(args, "light", circumstances, left);
    let rows = plan
        .run_light(gpu, &report.rows(), |row| {
            report.keep([row.clone()]);
            report.advance(format!("{}, {}", row.scene, row.method), 1.0);
        })
        .map_err(Stop::failed)?;
    report.finish(&rows, &light_table(&rows))
}
