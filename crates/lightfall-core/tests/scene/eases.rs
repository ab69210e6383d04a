//! Eases of keyframes.

use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::{self, Journey, Track};

pub(crate) fn scene_at(journey: &Journey, time: f64) -> Scene {
    let mut scene = Scene::default();
    journey.apply(time, &mut scene);
    scene
}

/// Shares of a stretch after a quarter of its time: the cubic from rest to rest, 3t^2 - 2t^3, the line t, the
/// parabolas t^2 and 1 - (1-t)^2.
#[test]
fn an_ease_is_the_course_of_everything_that_its_keyframe_names() {
    for (ease, share) in [
        ("ease = \"smooth\"", 0.15625),
        ("", 0.15625),
        ("ease = \"linear\"", 0.25),
        ("ease = \"hold\"", 0.0),
        ("ease = \"in\"", 0.0625),
        ("ease = \"out\"", 0.4375),
    ] {
        let text = format!(
            "[[keyframe]]\ntime = 10\ntheta_deg = 40\nr = 1\nset = {{ \"hole.spin\" = 0.1, camera.shift = [0, 1] }}\n\
             {ease}\n[[keyframe]]\ntime = 12\nfov_deg = 30\n\
             [[keyframe]]\ntime = 14\ntheta_deg = 80\nr = 16\nset = {{ \"hole.spin\" = 0.5, camera.shift = [1, 0] }}"
        );
        let journey = journey::load("j.toml", &text).unwrap();
        let [start, quarter, end] = [0.0, 1.0, 4.0].map(|time| scene_at(&journey, time));
        assert_eq!(start.camera.theta_deg, 40.0, "{ease}");
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{ease}: {a} {b}");
        near(quarter.camera.theta_deg, 40.0 + 40.0 * share);
        near(quarter.camera.r.log2(), 4.0 * share);
        near(quarter.hole.spin, 0.1 + 0.4 * share);
        near(quarter.camera.shift[0], share);
        near(quarter.camera.shift[1], 1.0 - share);
        assert_eq!(end.camera.theta_deg, 80.0, "{ease}");
        assert_eq!(end.hole.spin, 0.5, "{ease}");
        // The keyframe in between does not name them, so it changes nothing for them.
        assert_eq!(end.camera.fov_deg, 30.0);
    }
}

#[test]
fn a_held_value_changes_at_once_and_not_before() {
    let text = "[[keyframe]]\ntime = 0\ntheta_deg = 40\nease = \"hold\"\n[[keyframe]]\ntime = 4\ntheta_deg = 80";
    let journey = journey::load("j.toml", text).unwrap();
    assert_eq!(
        scene_at(&journey, 4.0_f64.next_down()).camera.theta_deg,
        40.0
    );
    assert_eq!(scene_at(&journey, 4.0).camera.theta_deg, 80.0);
}

/// Central differences of a millisecond on both sides of a joint: the smooth stretch takes over the speed of
/// its neighbour, up to three times its own mean, where it would overshoot.
#[test]
fn a_smooth_stretch_has_the_speed_of_its_neighbours_and_does_not_overshoot() {
    let journey = |first: &str, last: f64| {
        let text = format!(
            "[[keyframe]]\ntime = 0\ntheta_deg = 20\nease = \"{first}\"\n[[keyframe]]\ntime = 2\ntheta_deg = 40\n\
             [[keyframe]]\ntime = 4\ntheta_deg = {last:?}\nease = \"linear\"\n[[keyframe]]\ntime = 6\ntheta_deg = 100"
        );
        journey::load("j.toml", &text).unwrap()
    };
    let theta = |journey: &Journey, time: f64| scene_at(journey, time).camera.theta_deg;
    let speed =
        |journey: &Journey, time: f64| (theta(journey, time + 1e-6) - theta(journey, time)) / 1e-6;
    for (first, arrives) in [("linear", 10.0), ("in", 20.0), ("out", 0.0)] {
        let journey = journey(first, 70.0);
        let [before, after] = [2.0 - 2e-6, 2.0].map(|time| speed(&journey, time));
        assert!(
            (before - arrives).abs() < 1e-3 && (after - arrives).abs() < 1e-3,
            "{first}: {before} {after}"
        );
        let [before, after] = [4.0 - 2e-6, 4.0].map(|time| speed(&journey, time));
        assert!(
            (before - 15.0).abs() < 1e-3 && (after - 15.0).abs() < 1e-3,
            "{first}: {before} {after}"
        );
    }
    // From 40 to 41 degrees in 2 s the mean speed is 0.5: it begins with 1.5 and not with 10.
    let slow = journey("linear", 41.0);
    assert!((speed(&slow, 2.0) - 1.5).abs() < 1e-3);
    let mut last = 40.0;
    for step in 0..=1000 {
        let now = theta(&slow, 2.0 + f64::from(step) / 500.0);
        assert!((40.0..=41.0).contains(&now) && now >= last - 1e-12);
        last = now;
    }
}

/// The cubic as it was before there were eases, written out once more: slopes by Fritsch & Butland 1984.
fn cubic_of_old(points: &[(f64, f64)], time: f64) -> f64 {
    let secant = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
    let slope = |i: usize| {
        if i == 0 || i + 1 == points.len() || secant(i - 1) * secant(i) <= 0.0 {
            return 0.0;
        }
        let (left, right) = (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
        let (w1, w2) = (2.0 * right + left, right + 2.0 * left);
        (w1 + w2) / (w1 / secant(i - 1) + w2 / secant(i))
    };
    let i = points.iter().rposition(|(from, _)| *from <= time).unwrap();
    let length = points[i + 1].0 - points[i].0;
    let t = (time - points[i].0) / length;
    let rest = 1.0 - t;
    points[i].1 * (1.0 + 2.0 * t) * rest * rest
        + points[i + 1].1 * (1.0 + 2.0 * rest) * t * t
        + length * t * rest * (slope(i) * rest - slope(i + 1) * t)
}

#[test]
fn a_journey_without_eases_goes_where_it_went_before_to_the_last_bit() {
    let points = [
        (0.0, 60.0),
        (8.0, 61.5),
        (9.0, 75.0),
        (31.0, 76.0),
        (40.0, 30.0),
        (41.5, 29.0),
    ];
    let text: String = points
        .iter()
        .map(|(time, theta)| format!("[[keyframe]]\ntime = {time:?}\ntheta_deg = {theta:?}\n"))
        .collect();
    let journey = journey::load("j.toml", &text).unwrap();
    let track = Track::through(&points).unwrap();
    for step in 0..830 {
        let time = f64::from(step) / 20.0;
        let expected = cubic_of_old(&points, time);
        assert_eq!(
            scene_at(&journey, time).camera.theta_deg.to_bits(),
            expected.to_bits()
        );
        assert_eq!(track.at(time).to_bits(), expected.to_bits());
    }
}
