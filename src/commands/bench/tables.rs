//! The measurements of `lightfall bench` that make one table, row by row.

use super::SAMPLE_SHARE;
use crate::commands::circumstances::{circumstances, circumstances_of, circumstances_of_core};
use crate::commands::cli::BenchArgs;
use crate::commands::kept_rows::KeptRows;
use crate::commands::progress::Progress;
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_core::gpu::Gpu;
use lightfall_lab::bench::{
    DelayMeasurement, FlightMeasurement, LightMeasurement, MediumMeasurement, Plan,
    RefinementMeasurement, delay_table, flight_rows, flight_table, light_table, medium_table,
    refinement_table, run_flights,
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use wgpu::DeviceType;

/// `lightfall bench --delay`: the error of the time between emission and arrival against the run
/// time.
pub(super) fn bench_delays(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let kept = KeptRows::open(&args.report, "delay", circumstances_of(plan, gpu));
    let task =
        |row: &DelayMeasurement| format!("{}, {}, {} nodes", row.scene, row.method, row.nodes);
    let rows = plan.delay_rows();
    bench_rows(kept, rows, task, delay_table, |known, done| {
        plan.run_delays(gpu, known, done)
    })
}

/// `lightfall bench --light`: the run time of a living disk's light over that of a smooth disk's.
pub(super) fn bench_light(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let kept = KeptRows::open(&args.report, "light", circumstances_of(plan, gpu));
    let task = |row: &LightMeasurement| format!("{}, {}", row.scene, row.method);
    let rows = plan.light_rows();
    bench_rows(kept, rows, task, light_table, |known, done| {
        plan.run_light(gpu, known, done)
    })
}

/// Size of the picture whose light is timed on a software renderer.
const SOFTWARE_SIZE: UVec2 = UVec2::new(480, 270);

/// `lightfall bench --medium`: the error of light from matter with depth against the run time.
pub(super) fn bench_medium(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let software = gpu.info.device_type == DeviceType::Cpu;
    let mut plan = plan.clone();
    if software && args.size.is_none() {
        plan.size = plan.size.min(SOFTWARE_SIZE);
    }
    let kept = KeptRows::open(&args.report, "medium", circumstances_of(&plan, gpu));
    let task =
        |row: &MediumMeasurement| format!("{}, {}, {} nodes", row.scene, row.disk, row.nodes);
    let rows = plan.medium_rows();
    bench_rows(kept, rows, task, medium_table, |known, done| {
        plan.run_medium(gpu, known, done)
    })
}

/// `lightfall bench --refine`: how far the article's methods can be refined.
pub(super) fn bench_refinements(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let rows = plan.refinement_rows();
    if rows == 0 {
        return Err(Stop::refused(
            "no method of --methods can be refined in a scene of --scenes: only verlet and kerr-schild \
             have these settings, and verlet needs hole.spin = 0",
        ));
    }
    let circumstances = circumstances(gpu, "that of each scene".into(), "compute");
    let kept = KeptRows::open(&args.report, "refine", circumstances);
    let task = |row: &RefinementMeasurement| {
        let study = row.study.word();
        format!("{}, {}, {study} {}", row.scene, row.method, row.label())
    };
    bench_rows(kept, rows, task, refinement_table, |known, done| {
        plan.run_refinements(gpu, known, done)
    })
}

/// `lightfall bench --flight`: the error of a ship's flight against the run time.
pub(super) fn bench_flights(args: &BenchArgs) -> Result<(), Stop> {
    let kept = KeptRows::open(&args.report, "flight", circumstances_of_core());
    let task = |row: &FlightMeasurement| {
        let [spin, r, tolerance] = [row.spin, row.r, row.tolerance];
        format!("spin {spin}, r {r}, tolerance {tolerance:.0e}")
    };
    bench_rows(kept, flight_rows(), task, flight_table, |known, done| {
        run_flights(known, done)
    })
}

/// Measures so many rows, except those that are known, and prints and writes their report. `task`
/// says what a row is, and `measure` gets the known rows and what is to be called with each new one.
fn bench_rows<T: Clone + Serialize + DeserializeOwned, Fault: std::error::Error>(
    mut kept: KeptRows<T>,
    count: usize,
    task: impl Fn(&T) -> String,
    table: fn(&[T]) -> String,
    measure: impl FnOnce(&[T], &mut dyn FnMut(&T)) -> Result<Vec<T>, Fault>,
) -> Result<(), Stop> {
    let known = kept.rows();
    let left = count.saturating_sub(known.len()) as f64;
    let mut progress = Progress::new("bench", left, SAMPLE_SHARE * left);
    let measured = measure(&known, &mut |row| {
        kept.add(row.clone());
        progress.advance(task(row), 1.0);
    });
    progress.finish();
    let rows = measured.map_err(Stop::failed)?;
    kept.finish(&rows, &table(&rows))
}
