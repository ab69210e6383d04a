//! The program's own measurements, held against what it promises.

use crate::gpu;
use lightfall_core::reports::bench::{Measurement, at_equal_error, settings};
use lightfall_core::reports::bench::{Plan, auto_margin, markdown, plot, scenes};
use lightfall_core::reports::circumstances::Circumstances;
use lightfall_core::reports::export::csv;
use lightfall_core::reports::extremes::{Hunt, Verdict, WorstRay, cells, measure_matrix};
use lightfall_core::scene::Method;

fn circumstances() -> Circumstances {
    let text = String::from;
    Circumstances {
        adapter: text("an adapter"),
        driver: text("its driver"),
        backend: text("vulkan"),
        size: text("160x90"),
        entry: text("compute"),
        commit: text("0123"),
        floor_ms: Some(0.025),
        command: text("lightfall bench --quick"),
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn auto_is_on_the_pareto_front_of_every_scene_of_a_quick_run() {
    let gpu = gpu();
    let plan = Plan {
        rays: 256,
        ..Plan::new(true)
    };
    let measured = || plan.run(gpu, |_| {}).unwrap();
    let fast = |rows: &[Measurement]| {
        plan.scenes.iter().all(|subject| {
            auto_margin(rows, &subject.name).is_some_and(|margin| margin.faster > 0.9)
        })
    };
    // Other work can but lengthen a time: a machine that is busy is asked again, and the lesser
    // time counts.
    let mut rows = measured();
    for _ in 0..3 {
        if !fast(&rows) {
            for (row, again) in rows.iter_mut().zip(measured()) {
                row.trace_ms = row.trace_ms.min(again.trace_ms);
            }
        }
    }
    assert_eq!(rows.len(), plan.len());
    for subject in &plan.scenes {
        let margin =
            auto_margin(&rows, &subject.name).expect("auto's method is among those measured");
        println!("{margin:?}");
        // Times wobble, by less than this; the true ratios are 1.7 and more. What no other method
        // reaches as fast, none reaches faster and better either.
        assert!(
            margin.faster > 0.9,
            "{margin:?}: another method is as exact in less time"
        );
        let svg = plot(&subject.name, "a test", &rows)
            .unwrap()
            .expect("there is something to draw");
        assert!(labels_apart(&svg), "{svg}");
        assert!(
            svg.starts_with("<svg") && svg.contains("closed") | svg.contains("mino"),
            "{svg}"
        );
    }
    let text = csv(&circumstances(), &rows);
    let mut lines = text.lines().skip_while(|line| line.starts_with('#'));
    let columns = lines.next().unwrap().split(',').count();
    assert!(
        lines.clone().count() == rows.len() && lines.all(|line| line.split(',').count() == columns)
    );
    assert!(markdown(&circumstances(), &rows).contains("| edge-on | **closed** * |"));
}

#[test]
fn every_scene_is_measured_by_every_method_that_can_trace_it_and_by_auto_s_first() {
    for subject in scenes() {
        let spinning = subject.scene.hole.spin != 0.0;
        let auto = if spinning {
            Method::Mino
        } else {
            Method::Closed
        };
        let all = settings(&subject.scene, auto, false);
        assert!(
            all[0].auto && all[0].own && all[1..].iter().all(|setting| !setting.auto),
            "{}",
            subject.name
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn closed_and_mino_hold_every_extreme_cell() {
    let gpu = gpu();
    // As many rays as the command takes by default.
    let cells = cells(96);
    let verdicts = measure_matrix(gpu, &cells, &[Method::Closed, Method::Mino], |_| {}).unwrap();
    let failing: Vec<&Verdict> = verdicts.iter().filter(|verdict| !verdict.holds).collect();
    assert!(
        failing.is_empty(),
        "{} of {}: {failing:#?}",
        failing.len(),
        verdicts.len()
    );
    assert!(verdicts.len() > 250 && verdicts.iter().all(|verdict| verdict.rays >= 32));
}

/// Where azimuths are hardest: in the throats of almost extremal holes, where hundreds of radians
/// of dragging are the difference that counts, and for a camera next to the horizon. As many rays
/// as docs/EXTREMES.md is of.
#[test]
#[ignore = "needs a graphics adapter"]
fn every_ray_next_to_a_spinning_horizon_is_within_the_tightest_bar() {
    let gpu = gpu();
    let mut cells = cells(512);
    let named =
        |name: &str| name.contains("0.9999, from") || name == "chi 0.9, 1.0001 r_+, falling";
    cells.retain(|cell| named(&cell.name));
    let verdicts = measure_matrix(gpu, &cells, &[Method::Mino], |_| {}).unwrap();
    assert_eq!(
        verdicts.len(),
        6,
        "both signs of 0.9999 and the camera at the horizon, at two settings each"
    );
    for verdict in verdicts {
        println!(
            "{} by {}: {:e} rad",
            verdict.cell, verdict.method, verdict.backward_max
        );
        assert!(verdict.holds, "{verdict:#?}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_hunt_from_the_same_seed_finds_the_same_ray_and_tells_how_to_see_it_again() {
    let gpu = gpu();
    let hunt = Hunt {
        rays: 4000,
        seed: 7,
    };
    let found = hunt.run(gpu, |_| {}).unwrap();
    assert_eq!(found.len(), hunt.scenes());
    assert_eq!(found, hunt.run(gpu, |_| {}).unwrap());
    let command = found[0].command();
    assert!(
        command.starts_with("for device in gpu cpu; do echo ")
            && command.contains("lightfall trace --rays -")
    );
    let rank = |ray: &WorstRay| (ray.unexplained > 0, ray.excess);
    assert!(
        found.windows(2).all(|two| rank(&two[0]) >= rank(&two[1])),
        "the worst comes first"
    );
    for found in &found {
        assert!(
            found.unexplained <= found.beyond && (found.excess > 1.0) == (found.beyond > 0),
            "{found:?}"
        );
        assert_eq!(
            found.cause.is_some(),
            found.beyond > 0 && found.unexplained == 0,
            "{found:?}"
        );
    }
}

/// Rows of a scene by hand: ratios are of the cheapest settings of either at each level of the
/// slower.
#[test]
#[ignore = "needs a graphics adapter"]
fn methods_are_compared_where_they_are_equally_exact() {
    let gpu = gpu();
    let plan = Plan {
        scenes: scenes().into_iter().take(1).collect(),
        rays: 64,
        ..Plan::new(true)
    };
    let measured = plan.run(gpu, |_| {}).unwrap();
    let row = |method: &str, trace_ms: f64, backward_p99: f64| Measurement {
        method: method.into(),
        trace_ms,
        backward_p99,
        ..measured[0].clone()
    };
    let scene = measured[0].scene.clone();
    let rows = [
        row("closed", 2.0, 1e-7),
        row("verlet", 5.0, 1e-3),
        // Dearer and worse than the first: it sets no level of its own.
        row("verlet", 9.0, 2e-3),
        row("verlet", 21.0, 1e-5),
        // No bound, no level.
        row("verlet", 99.0, f64::INFINITY),
    ];
    let found = at_equal_error(&rows, &scene, "closed", "verlet", Some(1.0)).unwrap();
    assert_eq!(
        (found.ratio, found.net_ratio, found.best),
        ([2.5, 10.5], Some([4.0, 20.0]), [1e-7, 1e-5])
    );
    // The other way round there is no level that both reach.
    assert_eq!(
        at_equal_error(&rows, &scene, "verlet", "closed", None),
        None
    );
    let text = markdown(&circumstances(), &rows);
    assert!(text.contains("2.5 to 10.5"), "{text}");
}

/// Whether no label of a point, which has the colour of its method, covers another one.
fn labels_apart(svg: &str) -> bool {
    let label = |text: &str| -> Option<[i32; 4]> {
        let attribute = |name: &str| {
            text.split_once(&format!("{name}=\""))?
                .1
                .split_once('"')
                .map(|(value, _)| value)
        };
        let ([x, y], words) = (
            [attribute("x")?, attribute("y")?].map(|at| at.parse().unwrap()),
            text.split_once(">\n")?.1,
        );
        let width = 5 * words.lines().next()?.len() as i32;
        (attribute("fill")? != "#000000").then_some([x, y, x + width, y + 9])
    };
    let labels: Vec<[i32; 4]> = svg.split("<text ").skip(1).filter_map(label).collect();
    let apart =
        |a: &[i32; 4], b: &[i32; 4]| a[0] >= b[2] || b[0] >= a[2] || a[1] >= b[3] || b[1] >= a[3];
    assert!(!labels.is_empty(), "no labels in {svg}");
    labels
        .iter()
        .enumerate()
        .all(|(i, one)| labels[..i].iter().all(|other| apart(one, other)))
}
