//! A quick run of `lightfall bench`, and what it measures.

use crate::bench_rows::circumstances;
use crate::gpu;
use lightfall_core::scene::{ArticleQuality, Method};
use lightfall_lab::bench::{
    Measurement, Plan, auto_margin, markdown, methods_for, plot, scenes, settings,
};
use lightfall_lab::export::csv;
use std::collections::BTreeSet;

/// Whether a method is as exact as another one does not depend on the number of rays: their errors
/// are a hundred times apart.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_quick_run_reports_every_setting_and_auto_is_on_the_pareto_front_of_every_scene() {
    let gpu = gpu();
    let plan = Plan {
        rays: 64,
        ..Plan::new(true)
    };
    let measured = || plan.run(gpu, &[], |_| {}).unwrap();
    let is_fast = |rows: &[Measurement]| {
        plan.scenes
            .iter()
            .all(|scene| auto_margin(rows, &scene.name).is_some_and(|margin| margin.faster > 0.9))
    };
    // Other work on the machine can only lengthen a time. A busy machine measures again, and the
    // shorter time of each row counts.
    let mut rows = measured();
    for _ in 0..3 {
        if !is_fast(&rows) {
            for (row, again) in rows.iter_mut().zip(measured()) {
                row.trace_ms = row.trace_ms.min(again.trace_ms);
            }
        }
    }
    for scene in &plan.scenes {
        let margin = auto_margin(&rows, &scene.name).expect("auto's method is among the rows");
        println!("{margin:?}");
        // Times fluctuate by less than this; the true ratios are 1.7 and more. Where no other
        // method is as exact in the same time, none is both faster and more exact.
        assert!(
            margin.faster > 0.9,
            "{margin:?}: another method is as exact in less time"
        );
    }
    assert_eq!(rows.len(), plan.len());
    for scene in &plan.scenes {
        let svg = plot(&scene.name, "a test", &rows)
            .unwrap()
            .expect("there is something to draw");
        assert!(svg.starts_with("<svg") && labels_apart(&svg), "{svg}");
        let of_scene = rows.iter().filter(|row| row.scene == scene.name);
        for row in of_scene {
            assert!(svg.contains(&row.method), "{} is not in {svg}", row.method);
        }
    }
    let text = csv(&circumstances(), &rows);
    let mut lines = text.lines().skip_while(|line| line.starts_with('#'));
    let columns = lines.next().unwrap().split(',').count();
    assert_eq!(lines.clone().count(), rows.len());
    for line in lines {
        assert_eq!(line.split(',').count(), columns, "{line}");
    }
    assert!(markdown(&circumstances(), &rows).contains("| edge-on | **closed** * |"));
}

#[test]
fn the_first_setting_of_every_scene_is_its_own_and_the_only_one_of_auto() {
    for subject in scenes() {
        let scene = &subject.scene;
        let auto = Method::BEST;
        let all = settings(scene, auto, false);
        assert!(
            all[0].auto && all[0].own && all[1..].iter().all(|setting| !setting.auto),
            "{}",
            subject.name
        );
        let others = Method::on_gpu()
            .into_iter()
            .filter(|method| *method != auto);
        for method in others {
            let all = settings(scene, method, false);
            assert!(
                !all.is_empty() && all.iter().all(|setting| !setting.auto),
                "{}: {method:?}",
                subject.name
            );
        }
    }
}

#[test]
fn the_articles_methods_are_measured_at_its_qualities_with_their_budgets() {
    let subject = &scenes()[0].scene;
    for method in [Method::Verlet, Method::KerrSchild] {
        for few in [false, true] {
            let all = settings(subject, method, few);
            assert!(all[0].own && all[1..].iter().all(|setting| !setting.own));
            for named in ArticleQuality::ALL {
                let found = all.iter().find(|setting| setting.quality == Some(named));
                let setting = found.unwrap();
                let quality = setting.scene.quality;
                assert_eq!(
                    (quality.step_scale, quality.max_steps),
                    (named.step_scale(), named.max_steps())
                );
                assert_eq!(
                    setting.label(),
                    format!("{} {}", method.word(), named.word())
                );
            }
        }
    }
}

#[test]
fn every_scene_is_measured_by_every_method_that_can_trace_it() {
    for subject in scenes() {
        // Without lensing, times of methods would be those of one and the same code.
        assert!(subject.scene.effects.lensing, "{}", subject.name);
        // The article's own method is Schwarzschild's; the others trace holes with any spin.
        let mut methods = vec![Method::Closed, Method::KerrSchild, Method::Mino];
        if subject.scene.hole.spin == 0.0 {
            methods.push(Method::Verlet);
        }
        let found = methods_for(&subject.scene);
        assert_eq!(
            BTreeSet::from_iter(found.iter().map(|method| method.word())),
            BTreeSet::from_iter(methods.iter().map(|method| method.word())),
            "{}",
            subject.name
        );
    }
}

/// Whether no two labels of points overlap. A point's label has the colour of its method.
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
