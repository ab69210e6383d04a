//! The program's own measurements, held against what it promises.

use crate::gpu;
use lightfall::report::bench::{Circumstances, settings};
use lightfall::report::bench::{Plan, auto_margin, csv, markdown, plot, subjects};
use lightfall::report::extremes::{Found, Hunt, Verdict, cells, run};
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
    // At its tightest, single rays of mino deep in the throat of a fast hole are beyond the bar on one adapter or another
    // (docs/EXTREMES.md), by no more than this.
    let nearly = |verdict: &&Verdict| verdict.method == "mino, tightest" && verdict.backward_max < 1e-5;
    let sound = |verdict: &Verdict| verdict.unfinished == 0 && verdict.not_finite == 0;
    let passes = |verdict: &&Verdict| verdict.holds || sound(verdict) && nearly(verdict);
    let failing: Vec<_> = verdicts.iter().filter(|verdict| !passes(verdict)).collect();
    assert!(failing.is_empty(), "{} of {}: {failing:#?}", failing.len(), verdicts.len());
    let beyond = verdicts.iter().filter(|verdict| !verdict.holds).count();
    assert!(beyond <= 5, "{beyond} cells have a ray beyond the tightest bar");
    assert!(verdicts.len() > 250 && verdicts.iter().all(|verdict| verdict.rays >= 32));
}

#[test]
fn a_hunt_from_the_same_seed_finds_the_same_ray_and_tells_how_to_see_it_again() {
    let Some(gpu) = gpu() else { return };
    let hunt = Hunt { rays: 4000, seed: 7 };
    let found = hunt.run(gpu, |_| {}).unwrap();
    assert_eq!(found.len(), hunt.scenes());
    assert_eq!(found, hunt.run(gpu, |_| {}).unwrap());
    let command = found[0].command();
    assert!(command.starts_with("for device in gpu cpu; do echo ") && command.contains("lightfall trace --rays -"));
    let rank = |found: &Found| (found.unexplained > 0, found.excess);
    assert!(found.windows(2).all(|two| rank(&two[0]) >= rank(&two[1])), "the worst comes first");
    for found in &found {
        assert!(found.unexplained <= found.beyond && (found.excess > 1.0) == (found.beyond > 0), "{found:?}");
        assert_eq!(found.cause.is_some(), found.beyond > 0 && found.unexplained == 0, "{found:?}");
    }
}
