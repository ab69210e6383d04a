//! The comparison of methods at equal error, with rows that are written by hand.

use lightfall_core::scene::Method;
use lightfall_lab::bench::{Measurement, Plan, Ranking, at_equal_error, auto_margin, markdown};
use lightfall_lab::circumstances::{Circumstances, date};
use lightfall_lab::export::csv;
use lightfall_lab::import::Report;
use std::time::Duration;

/// What a report says of the machine and of the run.
pub fn circumstances() -> Circumstances {
    let text = String::from;
    Circumstances {
        adapter: text("an adapter"),
        driver: text("its driver"),
        backend: text("vulkan"),
        size: text("160x90"),
        entry: text("compute"),
        commit: text("0123"),
        date: text("2026-02-28"),
        floor_ms: Some(0.025),
        command: text("lightfall bench --quick"),
    }
}

/// A row of a method: its time, and its backward error. The other numbers do not matter here.
fn row(method: &str, trace_ms: f64, backward_p99: f64) -> Measurement {
    Measurement {
        scene: "edge-on".into(),
        method: method.into(),
        setting: None,
        value: None,
        own_setting: true,
        auto: method == "closed",
        trace_ms,
        trace_spread_ms: 0.1,
        clock: "wall".into(),
        frame_ms: None,
        rays: 64,
        unfinished: 0,
        not_finite: 0,
        misclassified: 0,
        sky_as: [32, 0, 0],
        captured_as: [0, 32, 0],
        sky_p50: 1e-7,
        sky_p99: 1e-6,
        hit_r_p50: 1e-7,
        hit_r_p99: 1e-6,
        hit_g_p50: 1e-7,
        hit_g_p99: 1e-6,
        backward_p50: 0.1 * backward_p99,
        backward_p99,
        backward_max: 10.0 * backward_p99,
        backward_p50_px: 100.0 * backward_p99,
        backward_p99_px: 1000.0 * backward_p99,
        steps_mean: 10.0,
        steps_max: 20.0,
        residual: 1e-6,
        quality: None,
        max_steps: None,
    }
}

#[test]
fn methods_are_compared_by_their_fastest_settings_at_equal_error() {
    let rows = [
        row("closed", 2.0, 1e-7),
        row("verlet", 5.0, 1e-3),
        // Slower and less exact than the row before: it adds no error level of its own.
        row("verlet", 9.0, 2e-3),
        row("verlet", 21.0, 1e-5),
        // An error without a bound gives no level.
        row("verlet", 99.0, f64::INFINITY),
    ];
    let found = at_equal_error(&rows, "edge-on", "closed", "verlet", Some(1.0)).unwrap();
    assert_eq!(
        (found.ratio, found.net_ratio, found.best),
        ([2.5, 10.5], Some([4.0, 20.0]), [1e-7, 1e-5])
    );
    // Verlet reaches none of the errors of closed.
    assert_eq!(
        at_equal_error(&rows, "edge-on", "verlet", "closed", None),
        None
    );
    let text = markdown(&circumstances(), &rows);
    assert!(text.contains("2.5 to 10 |"), "{text}");
}

#[test]
fn methods_are_ranked_only_where_the_spread_of_their_times_allows_it() {
    let ranking = |closed_ms: f64, verlet_ms: f64, verlet_error: f64, spread: f64| {
        let mut rows = [
            row("closed", closed_ms, 1e-7),
            row("verlet", verlet_ms, verlet_error),
        ];
        for row in &mut rows {
            row.trace_spread_ms = spread * row.trace_ms;
        }
        auto_margin(&rows, "edge-on").unwrap().ranking
    };
    // Half a spread of 20 % on each side of 2 and 3 ms leaves 2.2 below 2.7 ms,
    assert_eq!(ranking(2.0, 3.0, 1e-7, 0.2), Ranking::OnFront);
    assert_eq!(ranking(3.0, 2.0, 1e-7, 0.2), Ranking::NotOnFront);
    // and of 300 % nothing.
    for (closed, verlet) in [(2.0, 3.0), (3.0, 2.0)] {
        assert_eq!(
            ranking(closed, verlet, 1e-7, 3.0),
            Ranking::Undecided { spread: 1.5 }
        );
    }
    // No time makes a less exact method as good.
    assert_eq!(ranking(3.0, 2.0, 1e-3, 3.0), Ranking::OnFront);
}

#[test]
fn rows_are_read_back_from_a_report_as_they_were() {
    let mut rows = vec![
        // Numbers that differ in the last digit of f64.
        row("closed", 0.1 + 0.2, 1.0 / 3.0 * 1e-7),
        row("verlet", 0.3, f64::INFINITY),
    ];
    rows[1].setting = Some("quality.step_scale".into());
    rows[1].value = Some(0.85);
    rows[1].frame_ms = Some(5.0);
    let text = csv(&circumstances(), &rows);
    let report = Report::<Measurement>::read(&text).unwrap();
    assert_eq!(report.rows, rows);
    assert_eq!(csv(&circumstances(), &report.rows), text);
    assert_eq!(report.head.floor_ms(), Some(0.025));
    // A number that nothing has is NaN.
    rows[0].sky_p50 = f64::NAN;
    let report = Report::<Measurement>::read(&csv(&circumstances(), &rows)).unwrap();
    assert!(report.rows[0].sky_p50.is_nan());
    let error = Report::<Measurement>::read(&text.replace("0.85", "fast")).unwrap_err();
    assert!(error.starts_with("line "), "{error}");
}

#[test]
fn rows_belong_to_a_run_of_the_same_machine_program_and_command_on_any_day() {
    let head = Report::<Measurement>::read(&csv(&circumstances(), &[row("closed", 1.0, 1e-7)]))
        .unwrap()
        .head;
    let later = Circumstances {
        date: "2026-03-01".into(),
        floor_ms: None,
        ..circumstances()
    };
    assert_eq!(head.difference(&later), None);
    for other in [
        Circumstances {
            adapter: "another".into(),
            ..later.clone()
        },
        Circumstances {
            commit: "4567".into(),
            ..later.clone()
        },
        Circumstances {
            command: "lightfall bench".into(),
            ..later.clone()
        },
    ] {
        assert!(head.difference(&other).is_some(), "{other:?}");
    }
    let sentence = "adapter was an adapter and is another";
    let other = Circumstances {
        adapter: "another".into(),
        ..later
    };
    assert_eq!(head.difference(&other).as_deref(), Some(sentence));
}

#[test]
fn known_rows_are_no_work() {
    let mut plan = Plan::new(true);
    plan.scenes.retain(|scene| scene.name == "edge-on");
    plan.methods = vec![Method::Closed, Method::Verlet];
    let all = plan.work(&[])[0];
    let known = row("closed", 1.0, 1e-7);
    let left = plan.work(std::slice::from_ref(&known))[0];
    // Closed has one setting, of one unit of work.
    assert_eq!(all - left, 1.0);
    let elsewhere = Measurement {
        scene: "above".into(),
        ..known
    };
    assert_eq!(plan.work(&[elsewhere])[0], all);
}

#[test]
fn a_day_is_written_as_the_calendar_has_it() {
    // Days since 1970, among them leap days and the days about them, from a published calendar.
    for (day, expected) in [
        (0, "1970-01-01"),
        (58, "1970-02-28"),
        (59, "1970-03-01"),
        (789, "1972-02-29"),
        (11_016, "2000-02-29"),
        (20_512, "2026-02-28"),
        (47_540, "2100-02-28"),
        (47_541, "2100-03-01"),
    ] {
        let seconds = 86_400 * day;
        assert_eq!(date(Duration::from_secs(seconds)), expected);
        assert_eq!(date(Duration::from_secs(seconds + 86_399)), expected);
    }
}
