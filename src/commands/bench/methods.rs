//! `lightfall bench` without another switch: the errors of the methods against their run time.

use crate::commands::circumstances::circumstances_of;
use crate::commands::cli::BenchArgs;
use crate::commands::kept_rows::KeptRows;
use crate::commands::output::write_report;
use crate::commands::progress::Progress;
use crate::commands::stop::Stop;
use glam::UVec2;
use lightfall_core::gpu::Gpu;
use lightfall_core::scene::Method;
use lightfall_lab::bench::{
    AutoMargin, BenchScene, Measurement, Plan, Ranking, auto_margin, markdown, plot,
};
use lightfall_picture::Studio;
use lightfall_platform::log::say;

/// Number of frames that a whole frame's time is the median of.
const TIMED_FRAMES: usize = 9;

/// Measures the errors and times, and prints and writes their report.
pub(super) fn bench_methods(args: &BenchArgs, gpu: &Gpu, plan: &Plan) -> Result<(), Stop> {
    let scenes = match plan.scenes.as_slice() {
        [scene] => format!("in the scene {}", scene.name),
        scenes => format!("in {} scenes", scenes.len()),
    };
    say(format_args!(
        "lightfall: bench: {} measurements {scenes} on {}",
        plan.len(),
        gpu.info.name
    ));
    let mut kept = KeptRows::open(&args.report, "bench", circumstances_of(plan, gpu));
    let mut rows = measure(gpu, plan, &mut kept)?;
    if args.frames {
        time_frames(plan, &mut rows, &mut kept)?;
    }

    let circumstances = &mut kept.circumstances;
    circumstances.floor_ms = Some(plan.floor(gpu).map_err(Stop::failed)?);
    let markdown = markdown(circumstances, &rows);
    if let Some(folder) = &args.report.out {
        let about = circumstances.about();
        for BenchScene { name, .. } in &plan.scenes {
            if let Some(svg) = plot(name, &about, &rows).map_err(Stop::failed)? {
                write_report(folder, &format!("{name}.svg"), &svg)?;
            }
        }
    }
    for scene in &plan.scenes {
        if let Some(margin) = auto_margin(&rows, &scene.name) {
            print_margin(&margin);
        }
    }
    kept.finish(&rows, &markdown)
}

/// Measures what is planned and not known, and shows how far it has come.
fn measure(
    gpu: &Gpu,
    plan: &Plan,
    kept: &mut KeptRows<Measurement>,
) -> Result<Vec<Measurement>, Stop> {
    let known = kept.rows();
    let work = plan.work(&known);
    // All rows of a scene are timed before the error of any is computed, so a whole scene tells how
    // long the rest will take.
    let sample = work.iter().copied().find(|work| *work > 0.0);
    let mut progress = Progress::new("bench", work.iter().sum(), sample.unwrap_or_default());
    let (mut timed, mut complete) = (known.len(), known.len());
    let measured = plan.run(gpu, &known, |step| {
        let what = if let Some(row) = &step.row {
            kept.add(row.clone());
            complete += 1;
            format!("errors of {complete}")
        } else {
            timed += 1;
            format!("times of {timed}")
        };
        let (all, scene, setting) = (plan.len(), &step.scene, &step.setting);
        let task = format!("{what} of {all} measured; {scene}, {setting}");
        progress.advance(task, step.work);
    });
    progress.finish();
    measured.map_err(Stop::failed)
}

/// Times the frame of each method at the scene's own setting, as the sum of its passes.
fn time_frames(
    plan: &Plan,
    rows: &mut [Measurement],
    kept: &mut KeptRows<Measurement>,
) -> Result<(), Stop> {
    let is_left = |row: &Measurement| row.own_setting && row.frame_ms.is_none();
    let left: Vec<usize> = (0..rows.len()).filter(|i| is_left(&rows[*i])).collect();
    let mut progress = Progress::new("bench --frames", left.len() as f64, 1.0);
    for i in left {
        let row = &mut rows[i];
        let task = format!("frames of {}, {}", row.scene, row.label());
        progress.set_task(task.clone());
        let bench_scene = plan.scenes.iter().find(|scene| scene.name == row.scene);
        let Some((bench_scene, method)) = bench_scene.zip(Method::from_word(&row.method)) else {
            continue;
        };
        let scene = bench_scene.scene.with_method(method);
        let size = UVec2::new(scene.picture.width, scene.picture.height);
        let studio = Studio::open(&scene, size);
        let passes = studio.and_then(|mut studio| studio.time(TIMED_FRAMES));
        let passes = passes.map_err(Stop::failed)?;
        row.frame_ms = (!passes.is_empty()).then(|| passes.iter().map(|pass| pass.median_ms).sum());
        kept.replace(rows);
        progress.advance(task, 1.0);
    }
    progress.finish();
    Ok(())
}

/// Says on standard error whether `auto` is on the Pareto front of its scene, or that the times vary
/// too much to tell.
fn print_margin(margin: &AutoMargin) {
    let verdict = match margin.ranking {
        Ranking::OnFront => "on the front",
        Ranking::NotOnFront => "NOT on the front",
        Ranking::Undecided { spread } => {
            say(format_args!(
                "{}: no ranking of auto: the times vary by up to +-{:.0} %, which is too much",
                margin.scene,
                100.0 * spread
            ));
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
    say(format_args!(
        "{}: auto is {verdict}; {speed}; {error}",
        margin.scene
    ));
}
