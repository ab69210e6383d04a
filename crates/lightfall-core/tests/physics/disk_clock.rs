//! The disk's clock along worldlines.

use crate::assert_close;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::disk::inner_period;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::worldline::Worldline;
use lightfall_core::scene::{HotSpotKind, ObserverKind, Scene};

fn living(kind: ObserverKind, r: f64, spin: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hot_spot.kind = HotSpotKind::Rigid;
    scene.hole.spin = spin;
    scene.observer.kind = kind;
    (scene.camera.r, scene.camera.theta_deg) = (r, 90.0);
    scene
}

/// Rain without spin has closed forms: with Gullstrand and Painleve's time T, which is its proper
/// time, t = T - 2 sqrt(r) - ln((sqrt(r) - 1)/(sqrt(r) + 1)) outside, and inside
/// v = t + r* = T + r - 2 sqrt(r) + 2 ln(1 + sqrt(r)).
#[test]
fn the_clock_of_a_fall_is_boyer_lindquists_outside_and_the_ingoing_time_inside() {
    let mut scene = living(ObserverKind::Rain, 5.0, 0.0);
    scene.disk.time = 100.0;
    let t_of = |painleve: f64, r: f64| {
        let root = r.sqrt();
        painleve - 2.0 * root - ((root - 1.0) / (root + 1.0)).ln()
    };
    let start = 100.0 - t_of(0.0, 5.0);
    let mut worldline = Worldline::start(&scene).unwrap();
    let (mut outside, mut inside) = (0, 0);
    for _ in 0..150 {
        worldline.advance(0.05, &mut scene);
        let (painleve, r) = (start + worldline.proper_time(), scene.camera.r);
        // The fall's own series are right to about 1e-12; 1e-4 away from the horizon t has lost
        // four digits of them.
        if r > 1.0001 {
            assert_close(
                format!("t at {r}"),
                scene.disk.time,
                t_of(painleve, r),
                1e-10,
            );
            outside += 1;
        } else if r <= 1.0 {
            let v = painleve + r - 2.0 * r.sqrt() + 2.0 * (1.0 + r.sqrt()).ln();
            assert_close(format!("v at {r}"), scene.disk.time, v, 1e-10);
            inside += 1;
        }
    }
    assert!(outside > 100 && inside > 5, "{outside} {inside}");
}

/// When the light that is seen left the disk, with the reference's lag of the ray, through the
/// horizon. Outside, the clock and the lag both grow without limit; inside, both are finite; the
/// time of emission goes on steadily, with its rate. The direction is fixed on the observer's axes
/// and meets another place of the disk in every moment, so that this rate is not g.
#[test]
fn what_a_falling_observer_sees_goes_on_steadily_through_the_horizon() {
    for spin in [0.0, 0.7] {
        let horizon = Kerr { spin }.horizon();
        // Above the plane, looking outward and down, so that the middle of the disk is hit.
        let slopes = || (0..80).map(|i| DVec3::new(1.0, -2.0 + 0.05 * f64::from(i), 0.1));
        let mut looking = None;
        let mut scene = living(ObserverKind::Rain, 4.0, spin);
        scene.camera.theta_deg = 70.0;
        let mut worldline = Worldline::start(&scene).unwrap();
        let mut seen = Vec::new();
        for above in [1e-2, 1e-5, 1e-9, -1e-9, -1e-5, -1e-2] {
            let target = horizon * (1.0 + above);
            // Bisection for the proper time at which the target is reached.
            let (mut low, mut high) = (0.0, 5.0);
            for _ in 0..60 {
                let middle: f64 = 0.5 * (low + high);
                let (mut ahead, mut then) = (worldline.clone(), scene.clone());
                ahead.advance(middle, &mut then);
                if then.camera.r > target {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            worldline.advance(high, &mut scene);
            let reference = Reference::new(&scene).unwrap();
            let hits_middle = |direction: &DVec3| {
                let hit = reference.trace(*direction).hits[0];
                hit.is_some_and(|hit| (5.0..8.0).contains(&hit.r))
            };
            let direction = *looking.get_or_insert_with(|| slopes().find(hits_middle).unwrap());
            let trace = reference.trace_with_lags(direction);
            let hit = trace.hits[0].expect("the ray meets the disk");
            let emitted = scene.disk.time - hit.delay.expect("its lag is known");
            seen.push((worldline.proper_time(), emitted, scene.disk.time));
        }
        assert!(seen[2].2 - seen[0].2 > 10.0, "the clock diverges: {seen:?}");
        let rate =
            |from: usize, to: usize| (seen[to].1 - seen[from].1) / (seen[to].0 - seen[from].0);
        // Between the two middle places 2e-9 of proper time passes.
        let across = seen[3].1 - seen[2].1;
        assert!(across.abs() < 1e-7, "spin {spin}: a leap of {across}");
        // A sixth: the rate changes by a tenth between the two hundredths.
        let (outside, inside) = (rate(0, 2), rate(3, 5));
        assert!(
            (inside / outside - 1.0).abs() < 1.0 / 6.0,
            "spin {spin}: {outside} outside, {inside} inside"
        );
    }
}

#[test]
fn the_clock_of_an_orbit_is_far_away_time() {
    let mut scene = living(ObserverKind::Orbit, 4.5, 0.0);
    let mut worldline = Worldline::start(&scene).unwrap();
    for _ in 0..10 {
        worldline.advance(3.0, &mut scene);
    }
    // u^t = 1/sqrt(1 - 3 M/r) = sqrt(3/2).
    assert_close(
        "30 of proper time",
        scene.disk.time,
        30.0 * 1.5_f64.sqrt(),
        1e-14,
    );
    let mut smooth = Scene::default();
    let mut worldline = Worldline::start(&smooth).unwrap();
    worldline.advance(3.0, &mut smooth);
    assert_eq!(smooth.disk.time, 0.0, "nothing moves there");
}

/// 2 pi sqrt(r^3/M) without spin: 46.17 r_s/c at 3 r_s.
#[test]
fn the_period_of_the_inner_edge_is_keplers() {
    let scene = living(ObserverKind::Static, 20.0, 0.0);
    let period = std::f64::consts::TAU * 54.0_f64.sqrt();
    assert_close("period", inner_period(&scene).unwrap(), period, 1e-14);
}
