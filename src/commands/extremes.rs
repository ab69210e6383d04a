//! `lightfall extremes`: measures the matrix of hard places, or searches random scenes.

use super::circumstances::circumstances;
use super::cli::ExtremesArgs;
use super::output::{create_report_folder, publish};
use super::progress::Progress;
use super::scene::device;
use super::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_core::numbers::counted;
use lightfall_core::scene::Method;
use lightfall_lab::extremes::{
    Cell, CellDelays, Hunt, HuntRow, WorstRay, cells, delays_table, delays_work, grid, hunt_text,
    markdown, matrix_work, matter_cells, matter_table, measure_delays, measure_matrix,
    measure_matter,
};
use lightfall_platform::log::say;

/// Number of scenes that a hunt lists even if their worst rays are within the tolerance.
const MIN_LISTED: usize = 10;

/// The seed of a hunt that names none.
const DEFAULT_SEED: u64 = 1;

/// Share of the work after which the time of the rest is estimated.
const SAMPLE_SHARE: f64 = 0.03;

/// Measures the matrix, or hunts. Prints and writes the result.
pub(super) fn extremes(args: &ExtremesArgs) -> Result<(), Stop> {
    create_report_folder(&args.report)?;
    let gpu = device()?;
    if let Some(rays) = args.hunt {
        return hunt(
            &gpu,
            &Hunt {
                rays: rays as usize,
                seed: args.seed.unwrap_or(DEFAULT_SEED),
            },
            args,
        );
    }
    let methods = if args.methods.is_empty() {
        Method::on_gpu()
    } else {
        args.methods.clone()
    };
    if args.delay
        && !methods
            .iter()
            .any(|method| method.properties().answers_every_ray)
    {
        return Err(Stop::refused(
            "--delay measures closed and mino, and --methods names neither",
        ));
    }
    if args.medium {
        return matter(args, &gpu);
    }
    say(
        "lightfall: extremes: finding the edges of the shadows; then the first cells will tell how long the rest takes",
    );
    let cells = if args.grid { grid } else { cells }(args.rays as usize);
    if args.delay {
        return delays(args, &gpu, &cells, &methods);
    }
    let work = matrix_work(&cells, &methods);
    let mut progress = Progress::new("extremes", work, SAMPLE_SHARE * work);
    let measured = measure_matrix(&gpu, &cells, &methods, |verdict, work| {
        let task = format!("{}: {}, {}", verdict.group, verdict.cell, verdict.method);
        progress.advance(task, work);
    });
    progress.finish();
    let verdicts = measured.map_err(Stop::failed)?;

    let circumstances = circumstances(&gpu, format!("{} rays a cell", args.rays), "compute");
    let text = ("md", &*markdown(&verdicts));
    publish(&args.report, "extremes", &circumstances, &verdicts, text)?;
    let is_solved = |method: &str| {
        // Mino at its tightest setting is called "mino, tightest".
        let word = method.split(',').next().unwrap_or_default();
        Method::from_word(word).is_some_and(|method| method.properties().answers_every_ray)
    };
    let solved: Vec<_> = verdicts
        .iter()
        .filter(|verdict| is_solved(&verdict.method))
        .collect();
    let failing = solved.iter().filter(|verdict| !verdict.holds).count();
    say(format_args!(
        "lightfall: closed and mino, where they were measured, hold {} of their {} cells",
        solved.len() - failing,
        solved.len()
    ));
    if failing > 0 {
        return Err(Stop::failed(format!(
            "cells that do not hold: {failing}; see the table"
        )));
    }
    Ok(())
}

/// Measures the delays of the cells' hits, and prints and writes the report.
fn delays(args: &ExtremesArgs, gpu: &Gpu, cells: &[Cell], methods: &[Method]) -> Result<(), Stop> {
    let work = delays_work(cells, methods);
    let mut progress = Progress::new("extremes --delay", work, SAMPLE_SHARE * work);
    let measured = measure_delays(gpu, cells, methods, |row, work| {
        let task = format!("{}: {}, {}", row.group, row.cell, row.method);
        progress.advance(task, work);
    });
    progress.finish();
    let rows = measured.map_err(Stop::failed)?;

    let circumstances = circumstances(gpu, format!("{} rays a cell", args.rays), "compute");
    let text = ("md", &*delays_table(&rows));
    publish(&args.report, "delays", &circumstances, &rows, text)?;
    let sum = |of: fn(&CellDelays) -> usize| rows.iter().map(of).sum::<usize>();
    let unexplained = sum(|row| row.unexplained);
    say(format_args!(
        "lightfall: hits: {}; with an error worth more than 1e-3 rad: {}, of which the place explains {}, \
         {} are at another place, and {unexplained} are unexplained; rays lost: {}",
        sum(|row| row.hits),
        sum(|row| row.over),
        sum(|row| row.place),
        sum(|row| row.far),
        sum(|row| row.lost),
    ));
    if sum(|row| row.hits) == 0 {
        return Err(Stop::failed("no ray meets a disk: no delay was compared"));
    }
    if unexplained > 0 {
        return Err(Stop::failed(format!(
            "hits whose delay is wrong for their place: {unexplained}"
        )));
    }
    Ok(())
}

/// Measures the light of matter with depth, and prints and writes the report.
fn matter(args: &ExtremesArgs, gpu: &Gpu) -> Result<(), Stop> {
    let cells = matter_cells(args.rays as usize);
    let work = cells.len() as f64;
    let mut progress = Progress::new("extremes --medium", work, SAMPLE_SHARE * work);
    let measured = measure_matter(gpu, &cells, |verdict| {
        progress.advance(verdict.cell.clone(), 1.0);
    });
    progress.finish();
    let verdicts = measured.map_err(Stop::failed)?;

    let circumstances = circumstances(gpu, format!("{} rays a cell", args.rays), "compute");
    let text = ("md", &*matter_table(&verdicts));
    publish(&args.report, "matter", &circumstances, &verdicts, text)?;
    let failing = verdicts.iter().filter(|verdict| !verdict.holds).count();
    say(format_args!(
        "lightfall: matter with depth holds {} of {} cells",
        verdicts.len() - failing,
        verdicts.len()
    ));
    if failing > 0 {
        return Err(Stop::failed(format!(
            "cells that do not hold: {failing}; see the table"
        )));
    }
    Ok(())
}

fn hunt(gpu: &Gpu, hunt: &Hunt, args: &ExtremesArgs) -> Result<(), Stop> {
    let scenes = hunt.scenes() as f64;
    let mut progress = Progress::new("extremes --hunt", scenes, SAMPLE_SHARE * scenes);
    let mut worst = 0.0;
    let rays = hunt.run(gpu, |ray| {
        worst = f64::max(worst, ray.excess);
        let task = format!("the worst ray so far is at {worst:.2} of its tolerance");
        progress.advance(task, 1.0);
    });
    progress.finish();
    let rays = rays.map_err(Stop::failed)?;
    let beyond: usize = rays.iter().map(|ray| ray.beyond).sum();
    let unexplained: usize = rays.iter().map(|ray| ray.unexplained).sum();
    let unanswerable: usize = rays.iter().map(|ray| ray.unanswerable).sum();
    let scenes = rays.iter().filter(|ray| ray.beyond > 0).count();
    say(format_args!(
        "lightfall: {}; rays beyond their tolerance: {beyond}, in {scenes} of the scenes; unexplained: \
         {unexplained}; without an answer in f32, at a ring too narrow for it: {unanswerable}",
        counted(rays.len(), "random scene")
    ));
    let listed = &rays[..rays.len().min(MIN_LISTED.max(scenes))];
    let rows: Vec<HuntRow> = listed.iter().map(WorstRay::row).collect();
    let circumstances = circumstances(
        gpu,
        format!(
            "{} in {}",
            counted(hunt.rays, "ray"),
            counted(hunt.scenes(), "scene")
        ),
        "compute",
    );
    let text = ("txt", &*hunt_text(&circumstances, &rows));
    publish(&args.report, "hunt", &circumstances, &rows, text)?;
    if unexplained > 0 {
        return Err(Stop::failed(format!(
            "rays beyond their tolerance that nothing explains: {unexplained}"
        )));
    }
    Ok(())
}
