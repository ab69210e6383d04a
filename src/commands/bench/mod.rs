//! `lightfall bench`: error against run time.

mod methods;
mod pictures;
mod tables;

use super::cli::BenchArgs;
use super::output::create_report_folder;
use super::scene::device;
use super::stop::Stop;
use methods::bench_methods;
use pictures::bench_pictures;
use tables::{bench_delays, bench_flights, bench_light, bench_medium, bench_refinements};

/// Share of the work after which the time of the rest is estimated.
const SAMPLE_SHARE: f64 = 0.1;

/// Measures, and prints and writes the report.
pub(super) fn bench(args: &BenchArgs) -> Result<(), Stop> {
    create_report_folder(&args.report)?;
    if args.flight {
        return bench_flights(args);
    }
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
        BenchArgs { medium: true, .. } => bench_medium,
        _ => bench_methods,
    };
    run(args, &gpu, &plan)
}
