//! The program's own measurements, held against what it promises.

use crate::gpu;
use lightfall::report::bench::{Circumstances, settings};
use lightfall::report::bench::{Plan, auto_margin, csv, markdown, plot, subjects};
use lightfall::report::extremes::{Hunt, Verdict, cells, run};
use lightfall::scene::Method;

fn circumstances() -> Circumstances {
    let text = String::from;
    Circumstances {
        adapter: text("an adapter"),
        driver: text("its driver"),
        backend: text("vulkan"),
        size: text("160x90"),
        entry: text("compute"),
        commit: text("0123"),
        command: text("lightfall bench --quick"),
    }
}

#[test]
fn auto_is_on_the_pareto_front_of_every_scene_of_a_quick_run() {
    let Some(gpu) = gpu() else { return };
    let plan = Plan { rays: 256, ..Plan::new(true) };
    let rows = plan.run(gpu, |_| {}).unwrap();
    assert_eq!(rows.len(), plan.len());
    for subject in &plan.subjects {
        let margin = auto_margin(&rows, &subject.name).expect("auto's method is among those measured");
        println!("{margin:?}");
        // Times wobble, by less than this while a machine does nothing else; the true ratios are 1.7 and more.
        let in_time = margin.faster > 0.9;
        assert!(in_time && margin.more_exact > 1.0, "{margin:?}: another method is better in time and error");
        let svg = plot(&subject.name, "a test", &rows).unwrap().expect("there is something to draw");
        assert!(svg.starts_with("<svg") && svg.contains("closed") | svg.contains("mino"), "{svg}");
    }
    let text = csv(&circumstances(), &rows);
    let mut lines = text.lines().skip_while(|line| line.starts_with('#'));
    let columns = lines.next().unwrap().split(',').count();
    assert!(lines.clone().count() == rows.len() && lines.all(|line| line.split(',').count() == columns));
    assert!(markdown(&circumstances(), &rows).contains("| edge-on | **closed** * |"));
}

#[test]
fn every_scene_is_measured_by_every_method_that_can_trace_it_and_by_auto_s_first() {
    for subject in subjects() {
        let spinning = subject.scene.hole.spin != 0.0;
        let auto = if spinning { Method::Mino } else { Method::Closed };
        let all = settings(&subject.scene, auto, false);
        assert!(all[0].auto && all[0].own && all[1..].iter().all(|setting| !setting.auto), "{}", subject.name);
    }
}

#[test]
fn closed_and_mino_hold_every_extreme_cell() {
    let Some(gpu) = gpu() else { return };
    // As many rays as the command takes by default.
    let cells = cells(96);
    let verdicts = run(gpu, &cells, &[Method::Closed, Method::Mino], |_| {}).unwrap();
    let failing: Vec<&Verdict> = verdicts.iter().filter(|verdict| !verdict.holds).collect();
    assert!(failing.is_empty(), "{} of {}: {failing:#?}", failing.len(), verdicts.len());
    assert!(verdicts.len() > 250 && verdicts.iter().all(|verdict| verdict.rays >= 32));
}

/// Where azimuths are hardest: in the throats of almost extremal holes, where hundreds of radians of dragging are the
/// difference that counts, and for a camera next to the horizon. As many rays as docs/EXTREMES.md is of.
#[test]
fn every_ray_next_to_a_spinning_horizon_is_within_the_tightest_bar() {
    let Some(gpu) = gpu() else { return };
    let mut cells = cells(512);
    let named = |name: &str| name.contains("0.9999, from") || name == "chi 0.9, 1.0001 r_+, falling";
    cells.retain(|cell| named(&cell.name));
    let verdicts = run(gpu, &cells, &[Method::Mino], |_| {}).unwrap();
    assert_eq!(verdicts.len(), 6, "both signs of 0.9999 and the camera at the horizon, at two settings each");
    for verdict in verdicts {
        println!("{} by {}: {:e} rad", verdict.cell, verdict.method, verdict.backward_max);
        assert!(verdict.holds, "{verdict:#?}");
    }
}

#[test]
fn a_hunt_from_the_same_seed_finds_the_same_ray_and_tells_how_to_see_it_again() {
    let Some(gpu) = gpu() else { return };
    let hunt = Hunt { rays: 4000, seed: 7 };
    let found = hunt.run(gpu, |_| {}).unwrap();
    assert_eq!(found.len(), hunt.scenes());
    assert_eq!(found, hunt.run(gpu, |_| {}).unwrap());
    assert!(found[0].command().starts_with("echo ") && found[0].command().contains("lightfall trace --rays -"));
    assert!(found.windows(2).all(|two| two[0].excess >= two[1].excess), "the worst comes first");
}
