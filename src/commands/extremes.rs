//! `lightfall extremes`.

use super::circumstances::circumstances;
use super::cli::ExtremesArgs;
use super::output::{create_report_folder, print, write_report};
use super::progress::progress;
use super::stop::Stop;
use lightfall_core::gpu::Gpu;
use lightfall_core::reports::bench::{csv, json};
use lightfall_core::reports::extremes::{Found, Hunt, cells, grid, markdown, run, verdicts};
use lightfall_core::scene::Method;

/// The worst rays of a hunt that are told, whether they are within their bar or not.
const TOLD: usize = 10;

/// Measures the matrix, or hunts; prints and writes.
pub fn extremes(args: &ExtremesArgs) -> Result<(), Stop> {
    create_report_folder(args.out.as_deref())?;
    let gpu = Gpu::headless().map_err(Stop::without_device)?;
    if let Some(rays) = args.hunt {
        return hunt(
            &gpu,
            &Hunt {
                rays: rays as usize,
                seed: args.seed,
            },
            args.json,
        );
    }
    let methods = if args.methods.is_empty() {
        Method::on_gpu()
    } else {
        args.methods.clone()
    };
    let bar = progress(1);
    bar.set_message("looking for the shadows' edges");
    bar.tick();
    let cells = if args.grid { grid } else { cells }(args.rays as usize);
    bar.set_length(verdicts(&cells, &methods) as u64);
    let measured = run(&gpu, &cells, &methods, |verdict| {
        bar.set_message(format!(
            "{}: {}, {}",
            verdict.group, verdict.cell, verdict.method
        ));
        bar.inc(1);
    });
    let verdicts = measured.map_err(Stop::failed)?;
    bar.finish_and_clear();

    let circumstances = circumstances(&gpu, format!("{} rays a cell", args.rays), "compute");
    let (json, markdown) = (json(&circumstances, &verdicts), markdown(&verdicts));
    if let Some(folder) = &args.out {
        write_report(folder, "extremes.csv", &csv(&circumstances, &verdicts))?;
        write_report(folder, "extremes.json", &json)?;
        write_report(folder, "extremes.md", &markdown)?;
    }
    print(if args.json { &json } else { &markdown })?;
    let solved = |method: &str| {
        let word = method.split(',').next().unwrap_or_default();
        Method::from_word(word).is_some_and(|method| method.properties().answers_every_ray)
    };
    let failing = verdicts
        .iter()
        .filter(|verdict| solved(verdict.method) && !verdict.holds)
        .count();
    let own = verdicts
        .iter()
        .filter(|verdict| solved(verdict.method))
        .count();
    eprintln!(
        "lightfall: closed and mino hold {} of their {own} cells",
        own - failing
    );
    if failing > 0 {
        Err(Stop::failed(format!(
            "cells that do not hold: {failing}; see the table"
        )))
    } else {
        Ok(())
    }
}

fn hunt(gpu: &Gpu, hunt: &Hunt, as_json: bool) -> Result<(), Stop> {
    let bar = progress(hunt.scenes());
    let mut worst = 0.0;
    let found = hunt.run(gpu, |found| {
        worst = f64::max(worst, found.excess);
        bar.set_message(format!("the worst ray so far is at {worst:.2} of its bar"));
        bar.inc(1);
    });
    let found = found.map_err(Stop::failed)?;
    bar.finish_and_clear();
    let beyond: usize = found.iter().map(|found| found.beyond).sum();
    let unexplained: usize = found.iter().map(|found| found.unexplained).sum();
    let scenes = found.iter().filter(|found| found.beyond > 0).count();
    eprintln!(
        "lightfall: {} random scenes; rays beyond their bar: {beyond}, in {scenes} of the scenes; unexplained: {unexplained}",
        found.len()
    );
    let told = &found[..found.len().min(TOLD.max(scenes))];
    if as_json {
        let rows = told.iter().map(|found| {
            serde_json::json!({
                "backward": found.backward,
                "excess": found.excess,
                "verdict": found.verdict(),
                "rays_beyond": found.beyond,
                "rays_unexplained": found.unexplained,
                "command": found.command(),
            })
        });
        print(&format!("{:#}\n", serde_json::Value::Array(rows.collect())))?;
    } else {
        let line = |found: &Found| format!("# {}\n{}\n", found.verdict(), found.command());
        print(&told.iter().map(line).collect::<String>())?;
    }
    if unexplained > 0 {
        Err(Stop::failed(format!(
            "rays beyond their bar that nothing explains: {unexplained}"
        )))
    } else {
        Ok(())
    }
}
