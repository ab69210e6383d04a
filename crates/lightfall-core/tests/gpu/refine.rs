//! The series by which the article's methods are refined: each reduces the error that it is about.

use crate::bench_rows::circumstances;
use crate::gpu;
use lightfall_core::scene::Method;
use lightfall_lab::bench::{Plan, RefinementMeasurement, Study, refinement_table, scenes};
use lightfall_lab::export::csv;
use lightfall_lab::import::Report;

/// A plan for few rays of the scenes edge-on, without and with spin.
fn plan(methods: &[Method]) -> Plan {
    let mut scenes = scenes();
    scenes.retain(|scene| scene.name.starts_with("edge-on"));
    Plan {
        scenes,
        methods: methods.to_vec(),
        rays: 64,
        ..Plan::new(true)
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn each_series_reduces_the_error_that_it_is_about() {
    let rows = plan(&[Method::Closed, Method::Verlet])
        .run_refinements(gpu(), &[], |_| {})
        .unwrap();
    // Only verlet is refined, and only without spin.
    assert!(
        rows.iter()
            .all(|row| row.scene == "edge-on" && row.method == "verlet")
    );
    let ends = |study: Study| -> [&RefinementMeasurement; 2] {
        let mut own = rows.iter().filter(|row| row.study == study);
        let first = own.next().unwrap();
        [first, own.next_back().unwrap()]
    };
    // Of second order: 2^7 times shorter steps would place hits 2^14 times better, were it not for
    // ten bisections and f32; and 768 steps are not enough for them.
    let [long, short] = ends(Study::StepScale);
    assert!(short.hit_r_p50 < 0.1 * long.hit_r_p50, "{short:?}");
    assert!(long.unfinished == 0 && short.unfinished == 64, "{short:?}");
    let [small, large] = ends(Study::Budget);
    assert!(small.unfinished == 64 && large.unfinished == 0, "{large:?}");
    // The bending that is left out falls with the fourth power of the radius.
    let [near, far] = ends(Study::EscapeRadius);
    assert!(far.sky_p50 < 0.2 * near.sky_p50, "{near:?} {far:?}");
    assert!((far.escape_radius / near.escape_radius - 64.0).abs() < 1e-9);
    let [large, small] = ends(Study::LeastStep);
    assert!(small.backward_p99 < 0.5 * large.backward_p99, "{small:?}");
    assert!(small.steps_mean > 1.2 * large.steps_mean, "{small:?}");

    let text = csv(&circumstances(), &rows);
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.count(), 1 + rows.len());

    // A run that was stopped goes on after its rows, and one that was complete measures nothing.
    let plan = plan(&[Method::Verlet]);
    assert_eq!(plan.refinement_rows(), rows.len());
    let known = Report::<RefinementMeasurement>::read(&text).unwrap().rows;
    let mut measured = 0;
    let all = plan.run_refinements(gpu(), &known[..rows.len() - 2], |_| measured += 1);
    assert_eq!(measured, 2);
    assert_eq!(csv(&circumstances(), &all.unwrap()), text);
    let none = plan.run_refinements(gpu(), &known, |row| panic!("{row:?} is known"));
    assert_eq!(csv(&circumstances(), &none.unwrap()), text);
    assert_eq!(refinement_table(&rows).lines().count(), 2 + rows.len());
}

#[test]
fn only_the_articles_methods_are_refined_and_only_where_they_can_trace() {
    let plan = plan(&Method::on_gpu());
    let refinable = |name: &str| {
        let found = plan.scenes.iter().find(|scene| scene.name == name);
        let methods = plan.refinable(&found.unwrap().scene);
        methods.collect::<Vec<_>>()
    };
    assert_eq!(refinable("edge-on"), [Method::Verlet, Method::KerrSchild]);
    assert_eq!(refinable("edge-on-spinning"), [Method::KerrSchild]);
}
