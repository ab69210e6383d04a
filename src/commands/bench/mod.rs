//! `lightfall bench`: error against run time.

mod pictures;
mod refine;

use super::circumstances::circumstances;
use super::cli::{BenchArgs, EntryArg};
use super::output::{create_report_folder, print, write_report, write_tables};
use super::progress::Progress;
use super::scene::device;
use super::stop::Stop;
use crate::picture;
use glam::UVec2;
use lightfall_core::gpu::Gpu;
use lightfall_core::reports::bench::{
    AutoMargin, Measurement, Plan, Ranking, auto_margin, delay_table, light_table, markdown,
    pictures_table, plot, plot_delays, plot_pictures, with_smooth_disk,
};
use lightfall_core::reports::circumstances::Circumstances;
use lightfall_core::reports::export::{csv, json};
use lightfall_core::scene::{Method, Scene};
use pictures::measure_pictures;
use refine::bench_refinements;
use std::path::Path;

/// Number of frames that a whole frame's time is the median of.
const TIMED_FRAMES: usize = 9;

/// Measures, and prints and writes the report.
pub(super) fn bench(args: &BenchArgs) -> Result<(), Stop> {
    create_report_folder(args.out.as_deref())?;
    let gpu = device()?;
    let plan = args.plan();
    if plan.is_empty() {
        return Err(Stop::refused(
            "no method of --methods can trace a scene of --scenes: verlet and closed need hole.spin = 0",
        ));
    }
    if args.pictures {
        return bench_pictures(args, &gpu, &plan);
    }
    if args.delay {
        return bench_delays(args, &gpu, &plan);
    }
    if args.refine {
        return bench_refinements(args, &gpu, &plan);
    }
    if args.light {
        return bench_light(args, &gpu, &plan);
    }
    let scenes = match plan.scenes.as_slice() {
        [scene] => format!("in the scene {}", scene.name),
        scenes => format!("in {} scenes", scenes.len()),
    };
    eprintln!(
        "lightfall: bench: {} measurements {scenes} on {}",
        plan.len(),
        gpu.info.name
    );
    let mut rows = measure(&gpu, &plan)?;
    if args.frames {
        time_frames(&plan, &mut rows)?;
    }

    let circumstances = Circumstances {
        floor_ms: Some(plan.floor(&gpu).map_err(Stop::failed)?),
        ..circumstances_of(&plan, &gpu, "bench", args.entry)
    };
    let (json, markdown) = (json(&circumstances, &rows), markdown(&circumstances, &rows));
    if let Some(folder) = &args.out {
        let csv = csv(&circumstances, &rows);
        write_tables(folder, "bench", [&csv, &json, &markdown])?;
        write_plots(folder, "", &plan, &circumstances, |scene, about| {
            plot(scene, about, &rows)
        })?;
    }
    for scene in &plan.scenes {
        if let Some(margin) = auto_margin(&rows, &scene.name) {
            print_margin(&margin);
        }
    }
    print(if args.json { &json } else { &markdown })
}

/// Measures the delays, and prints and writes their report.
fn bench_delays(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let rows = plan
        .run_delays(gpu, |row| {
            eprintln!(
                "lightfall: bench: {}, {}, {} nodes",
                row.scene, row.method, row.nodes
            );
        })
        .map_err(Stop::failed)?;
    let circumstances = circumstances_of(plan, gpu, "delay", args.entry);
    let (json, table) = (json(&circumstances, &rows), delay_table(&rows));
    if let Some(folder) = &args.out {
        let csv = csv(&circumstances, &rows);
        write_tables(folder, "delay", [&csv, &json, &table])?;
        write_plots(folder, "delay-", plan, &circumstances, |scene, about| {
            plot_delays(scene, about, &rows)
        })?;
    }
    print(if args.json { &json } else { &table })
}

/// Times the light of living disks, and prints and writes the report.
fn bench_light(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let rows = plan
        .run_light(gpu, |row| {
            eprintln!("lightfall: bench: {}, {}", row.scene, row.method);
        })
        .map_err(Stop::failed)?;
    let circumstances = circumstances_of(plan, gpu, "light", EntryArg::Compute);
    let (json, table) = (json(&circumstances, &rows), light_table(&rows));
    if let Some(folder) = &args.out {
        let csv = csv(&circumstances, &rows);
        write_tables(folder, "light", [&csv, &json, &table])?;
    }
    print(if args.json { &json } else { &table })
}

/// Measures the error and the time of pictures, and prints and writes the report.
fn bench_pictures(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let plan = &Plan {
        scenes: plan.scenes.iter().flat_map(with_smooth_disk).collect(),
        ..plan.clone()
    };
    let mut rows = Vec::new();
    for scene in &plan.scenes {
        rows.extend(measure_pictures(scene, plan.size)?);
    }
    let circumstances = circumstances_of(plan, gpu, "pictures", EntryArg::Fragment);
    let (json, table) = (json(&circumstances, &rows), pictures_table(&rows));
    if let Some(folder) = &args.out {
        let csv = csv(&circumstances, &rows);
        write_tables(folder, "pictures", [&csv, &json, &table])?;
        write_plots(folder, "pictures-", plan, &circumstances, |scene, about| {
            plot_pictures(scene, about, &rows)
        })?;
    }
    print(if args.json { &json } else { &table })
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

/// Measures everything that is planned, and shows how far it has come.
fn measure(gpu: &Gpu, plan: &Plan) -> Result<Vec<Measurement>, Stop> {
    // All rows of a scene are timed before the error of any is computed, so a whole scene tells how
    // long the rest will take.
    let mut progress = Progress::new("bench", plan.work(), plan.work_of_scene(0));
    let (mut timed, mut complete) = (0, 0);
    let measured = plan.run(gpu, |step| {
        let what = if step.completes_row {
            complete += 1;
            format!("errors of {complete}")
        } else {
            timed += 1;
            format!("times of {timed}")
        };
        progress.set_task(format!(
            "{what} of {} measured; {}, {}",
            plan.len(),
            step.scene,
            step.setting
        ));
        progress.advance(step.work);
    });
    progress.finish();
    measured.map_err(Stop::failed)
}

/// Times the frame of each method at the scene's own setting, as the sum of its passes.
fn time_frames(plan: &Plan, rows: &mut [Measurement]) -> Result<(), Stop> {
    for row in rows.iter_mut().filter(|row| row.own_setting) {
        let bench_scene = plan.scenes.iter().find(|scene| scene.name == row.scene);
        let Some((bench_scene, method)) = bench_scene.zip(Method::from_word(&row.method)) else {
            continue;
        };
        let scene = Scene {
            method,
            ..bench_scene.scene.clone()
        };
        let size = UVec2::new(scene.picture.width, scene.picture.height);
        let (_, passes) =
            picture::render_timed(&scene, size, TIMED_FRAMES).map_err(Stop::failed)?;
        row.frame_ms = (!passes.is_empty()).then(|| passes.iter().map(|pass| pass.median_ms).sum());
    }
    Ok(())
}

/// Writes one plot per scene, as `prefix` and the scene's name. `plot` gets this name and a line about
/// the measurement.
fn write_plots(
    folder: &Path,
    prefix: &str,
    plan: &Plan,
    circumstances: &Circumstances,
    plot: impl Fn(&str, &str) -> Result<Option<String>, String>,
) -> Result<(), Stop> {
    let about = format!("{}, {}", circumstances.size, circumstances.adapter);
    for scene in &plan.scenes {
        if let Some(svg) = plot(&scene.name, &about).map_err(Stop::failed)? {
            write_report(folder, &format!("{prefix}{}.svg", scene.name), &svg)?;
        }
    }
    Ok(())
}

/// Says on standard error whether `auto` is on the Pareto front of its scene, or that the times vary
/// too much to tell.
fn print_margin(margin: &AutoMargin) {
    let verdict = match margin.ranking {
        Ranking::OnFront => "on the front",
        Ranking::NotOnFront => "NOT on the front",
        Ranking::Undecided { spread } => {
            eprintln!(
                "{}: no ranking of auto: the times vary by up to +-{:.0} %, which is too much",
                margin.scene,
                100.0 * spread
            );
            return;
        }
    };
    let speed = match &margin.next {
        Some(next) => format!(
            "it is {:.1} times as fast as {next}, the next method with no larger error",
            margin.faster
        ),
        None => "no other method reaches its error".into(),
    };
    let error = if margin.more_exact.is_finite() {
        format!(
            "at its speed it is {:.1} times as exact as any other method",
            margin.more_exact
        )
    } else {
        "no other method reaches its speed".into()
    };
    eprintln!("{}: auto is {verdict}; {speed}; {error}", margin.scene);
}
