//! `lightfall bench`.

use super::circumstances::circumstances;
use super::cli::{BenchArgs, EntryArg};
use super::output::{create_report_folder, print, write_report};
use super::progress::progress;
use super::stop::Stop;
use crate::picture;
use glam::UVec2;
use lightfall_core::gpu::Gpu;
use lightfall_core::reports::bench::{
    Circumstances, Measured, Plan, auto_margin, csv, json, markdown, plot,
};
use lightfall_core::scene::{Method, Scene};

/// Frames that a whole frame's time is the median of.
const FRAMES: usize = 9;

/// Measures, prints and writes.
pub fn bench(args: &BenchArgs) -> Result<(), Stop> {
    create_report_folder(args.out.as_deref())?;
    let gpu = Gpu::headless().map_err(Stop::without_device)?;
    let plan = args.plan();
    if plan.is_empty() {
        return Err(Stop::refused(
            "no method of --methods can trace a scene of --scenes: verlet and closed need hole.spin = 0",
        ));
    }
    let bar = progress(plan.len());
    let measured = plan.run(&gpu, |row| {
        bar.set_message(format!("{}, {}", row.scene, row.label()));
        bar.inc(1);
    });
    let mut rows = measured.map_err(Stop::failed)?;
    if args.frames {
        bar.set_message("whole frames");
        time_frames(&plan, &mut rows)?;
    }
    bar.finish_and_clear();

    let entry = match args.entry {
        EntryArg::Compute => "compute",
        EntryArg::Fragment => "fragment",
    };
    let circumstances = Circumstances {
        floor_ms: Some(plan.floor(&gpu).map_err(Stop::failed)?),
        ..circumstances(&gpu, format!("{}x{}", plan.size.x, plan.size.y), entry)
    };
    let (json, markdown) = (json(&circumstances, &rows), markdown(&circumstances, &rows));
    if let Some(folder) = &args.out {
        write_report(folder, "bench.csv", &csv(&circumstances, &rows))?;
        write_report(folder, "bench.json", &json)?;
        write_report(folder, "bench.md", &markdown)?;
        for subject in &plan.subjects {
            let about = format!("{}, {}", circumstances.size, circumstances.adapter);
            if let Some(svg) = plot(&subject.name, &about, &rows).map_err(Stop::failed)? {
                write_report(folder, &format!("{}.svg", subject.name), &svg)?;
            }
        }
    }
    for margin in plan
        .subjects
        .iter()
        .filter_map(|subject| auto_margin(&rows, &subject.name))
    {
        let ahead = |ratio: f64, what: &str| {
            if ratio.is_finite() {
                format!("{ratio:.1} times as {what}")
            } else {
                format!("alone to be so {what}")
            }
        };
        let verdict = if margin.holds() {
            "on the front"
        } else {
            "NOT on the front"
        };
        eprintln!(
            "{}: auto is {verdict}; beside other methods {} for its error, {} for its time",
            margin.scene,
            ahead(margin.faster, "fast"),
            ahead(margin.more_exact, "exact")
        );
    }
    print(if args.json { &json } else { &markdown })
}

/// Times the frame of each method at the scene's own setting, as the sum of its passes.
fn time_frames(plan: &Plan, rows: &mut [Measured]) -> Result<(), Stop> {
    for row in rows.iter_mut().filter(|row| row.own_setting) {
        let subject = plan
            .subjects
            .iter()
            .find(|subject| subject.name == row.scene);
        let Some((subject, method)) = subject.zip(Method::from_word(&row.method)) else {
            continue;
        };
        let scene = Scene {
            method,
            ..subject.scene.clone()
        };
        let size = UVec2::new(scene.picture.width, scene.picture.height);
        let (_, passes) = picture::render_timed(&scene, size, FRAMES).map_err(Stop::failed)?;
        row.frame_ms = (!passes.is_empty()).then(|| passes.iter().map(|pass| pass.median_ms).sum());
    }
    Ok(())
}
