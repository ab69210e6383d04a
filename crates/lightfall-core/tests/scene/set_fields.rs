//! The fields of the scene that keyframes set.

use super::eases::scene_at;
use super::journey_faults::without_line;
use lightfall_core::scene::{FIELDS, Kind, Range, Scene, SkyMode, Value, field, journey};
use std::ops::Bound;

fn fault(text: &str) -> String {
    journey::load("j.toml", text).unwrap_err().to_string()
}

/// Two values of a field, at a quarter and at three quarters of its range.
fn quarters(range: Range) -> [f64; 2] {
    let end = |bound: Bound<f64>, otherwise: f64| match bound {
        Bound::Included(end) | Bound::Excluded(end) => end,
        Bound::Unbounded => otherwise,
    };
    let (low, high) = (end(range.low, -1.0), end(range.high, 1.0));
    [0.25, 0.75].map(|share| low + share * (high - low))
}

#[test]
fn keyframes_lead_every_number_of_a_scene() {
    let own = [
        "camera.r",
        "camera.theta_deg",
        "camera.phi_deg",
        "camera.yaw_deg",
        "camera.pitch_deg",
        "camera.roll_deg",
        "camera.fov_deg",
        "disk.tilt_deg",
        "disk.node_deg",
        "disk.rate",
        "disk.time",
    ];
    let mut led = 0;
    for field in FIELDS.iter() {
        let Kind::Float(range) = field.kind else {
            continue;
        };
        let key = field.key;
        let [from, to] = quarters(range);
        let text = format!(
            "[[keyframe]]\ntime = 0\nease = \"linear\"\nset = {{ {key} = {from:?} }}\n[[keyframe]]\ntime = 2\n\
             set = {{ \"{key}\" = {to:?} }}"
        );
        if own.contains(&key) {
            let name = key.replace("camera.", "").replace("disk.", "disk_");
            let sentence = format!(
                "j.toml: line 4: keyframe 1: set.{key} is refused: a keyframe itself names it, as {name}"
            );
            assert_eq!(fault(&text), sentence);
            continue;
        }
        let journey = journey::load("j.toml", &text).unwrap();
        let Value::Float(middle) = field.get(&scene_at(&journey, 1.0)) else {
            panic!("{key} is no number");
        };
        let mean = 0.5 * (from + to);
        assert!(
            (middle - mean).abs() <= 1e-12 * to.abs().max(from.abs()),
            "{key}: {middle} {mean}"
        );
        led += 1;
    }
    assert!(led >= 50, "{led} fields");
}

#[test]
fn what_has_nothing_in_between_changes_at_its_keyframe() {
    let text = "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 2\n[keyframe.set]\ndisk.enabled = true\ndisk.seed = 7\n\
                sky.mode = \"grid\"\n[[keyframe]]\ntime = 4\nset = { disk = { enabled = false, seed = 9 }, \"sky.mode\" = \"stars\" }";
    let journey = journey::load("j.toml", text).unwrap();
    let shown = |time: f64| {
        let scene = scene_at(&journey, time);
        (scene.disk.enabled, scene.disk.seed, scene.sky.mode)
    };
    for time in [0.0, 2.0, 4.0_f64.next_down()] {
        assert_eq!(shown(time), (true, 7, SkyMode::Grid), "{time}");
    }
    for time in [4.0, 100.0] {
        assert_eq!(shown(time), (false, 9, SkyMode::Stars), "{time}");
    }
}

#[test]
fn an_exposure_that_keyframes_set_is_not_metered() {
    let text = "[[keyframe]]\ntime = 0\nset = { picture.exposure_ev = -1 }\n[[keyframe]]\ntime = 1";
    let mut scene = Scene::default();
    scene.picture.automatic_exposure = true;
    journey::load("j.toml", text)
        .unwrap()
        .apply(0.5, &mut scene);
    assert_eq!(
        (scene.picture.automatic_exposure, scene.picture.exposure_ev),
        (false, -1.0)
    );
}

#[test]
fn what_keyframes_cannot_set_is_refused_with_its_line_and_the_reason() {
    let second = |lines: &str| format!("[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 1\n{lines}");
    for (lines, sentence) in [
        (
            "ease = \"slow\"",
            "line 5: keyframe 2: ease = \"slow\" is refused: it must be one of smooth, linear, hold, in, out",
        ),
        (
            "ease = 3",
            "line 5: keyframe 2: ease = 3 is refused: it must be one of smooth, linear, hold, in, out",
        ),
        (
            "set = 3",
            "line 5: keyframe 2: set = 3 is refused: it must be a table of fields of the scene, such as { \"hole.spin\" = 0.5 }",
        ),
        (
            "\n[keyframe.set]\ndisk.inner = 4\n\"hole.spin\" = 2",
            "line 8: keyframe 2: set.hole.spin = 2 is refused: it must be a number above -1 and below 1",
        ),
        (
            "set.disk.seed = 1.5",
            "line 5: keyframe 2: set.disk.seed = 1.5 is refused: it must be an integer from 0 to 4294967295",
        ),
        (
            "set.camera.shift = [1]",
            "line 5: keyframe 2: set.camera.shift = [1] is refused: it must be two numbers, [to the right, upward], from -10 to 10 picture heights",
        ),
        (
            "set.hole.spn = 0.5",
            "line 5: keyframe 2: set.hole.spn is refused: there is no such field; did you mean hole.spin?",
        ),
        (
            "set.observer.kind = \"rain\"",
            "line 5: keyframe 2: set.observer.kind is refused: a keyframe itself names it, as observer",
        ),
        (
            "set.observer.velocity = [0, 0, 0]",
            "line 5: keyframe 2: set.observer.velocity is refused: a keyframe itself names it, as velocity",
        ),
        (
            "set.title = \"New\"",
            "line 5: keyframe 2: set.title is refused: no picture shows it",
        ),
        (
            "set.picture.width = 64",
            "line 5: keyframe 2: set.picture.width is refused: all pictures of a journey have one size and one projection",
        ),
        (
            "set.camera.projection = \"cube\"",
            "line 5: keyframe 2: set.camera.projection is refused: all pictures of a journey have one size and one projection",
        ),
        (
            "set.sky.picture = \"sky.exr\"",
            "line 5: keyframe 2: set.sky.picture is refused: the sky has one picture in the whole journey, that of the scene",
        ),
        (
            "set.picture.bypass = true",
            "line 5: keyframe 2: set.picture.bypass is refused: the window and --cells decide it for the whole journey",
        ),
        (
            "set = { hole = { spin = 0.1 }, \"hole.spin\" = 0.2 }",
            "line 5: keyframe 2: set.hole.spin is refused: it is there twice",
        ),
    ] {
        assert_eq!(fault(&second(lines)), format!("j.toml: {sentence}"));
    }
    let in_rain = fault(&second("rain = { set = { hole.spin = 0.1 } }"));
    assert!(
        without_line(&in_rain).starts_with("j.toml: keyframe 2: there is no rain.set; "),
        "{in_rain}"
    );
    let twice = second("set.hole.spin = 0.1\n[[stop]]\nat = 1\nhole.spin = 0.5");
    let twice = fault(&twice);
    assert!(
        twice.starts_with(
            "j.toml: line 8: stop 1: there is no hole.spin; no stop switches it, because the table set of a [[keyframe]] leads it; "
        ),
        "{twice}"
    );
}

#[test]
fn a_journey_with_eases_and_fields_is_written_and_read_back() {
    let text = "[[keyframe]]\ntime = 0\nr = 30\nease = \"out\"\nset = { hole.spin = 0.2, \"disk.enabled\" = true, disk.seed = 3 }\n\
                [[keyframe]]\ntime = 3\nr = 12\nset = { camera.shift = [0.5, 0], view = \"redshift\" }\n";
    let journey = journey::load("j.toml", text).unwrap();
    let written = journey.to_toml();
    assert_eq!(
        journey::load("again.toml", &written).unwrap(),
        journey,
        "{written}"
    );
    assert!(
        written.contains("ease = \"out\"") && written.contains("set.hole.spin = 0.2"),
        "{written}"
    );
}

#[test]
fn a_field_that_is_set_and_changes_nothing_is_told() {
    let text = "[[keyframe]]\ntime = 0\nset = { disk.inner = 4 }\n[[keyframe]]\ntime = 1";
    let journey = journey::load("j.toml", text).unwrap();
    let mut scene = Scene::default();
    assert!(journey.idle_values(&scene).is_empty());
    let inner = field("disk.follow_isco").unwrap();
    inner.set(&mut scene, Value::Boolean(true)).unwrap();
    let idle = journey.idle_values(&scene);
    assert_eq!(
        idle.iter().map(|(name, _)| *name).collect::<Vec<_>>(),
        ["disk.inner"]
    );
}
