//! The limits of fields that depend on others, and which of two conflicting fields is blamed.

use crate::journey_faults::without_line;
use lightfall_core::scene::{Override, Scene, SceneError, load};

fn with(text: &str, sets: &[&str]) -> Result<Scene, SceneError> {
    let sets: Vec<Override> = sets
        .iter()
        .map(|set| Override::assignment(set).unwrap())
        .collect();
    load("my.toml", text, &sets)
}

/// What is said of a preset, without the number of the line.
fn preset(text: &str) -> String {
    without_line(&with(text, &[]).unwrap_err().to_string())
}

#[test]
fn a_refusal_names_the_other_fields_that_limit_the_field() {
    for (text, sentence) in [
        (
            "camera.r = 1",
            "camera.r = 1 is refused: it must be a number above 1 and at most 10000000 r_s (outside the horizon at \
             hole.spin = 0; observer rain goes on inside)",
        ),
        (
            // The horizon of chi = 0.6 lies at (1 + 0.8)/2, and there the static limit touches it
            // on the axis.
            "hole.spin = 0.6\ncamera.r = 0.9\nobserver.kind = \"zamo\"",
            "camera.r = 0.9 is refused: it must be a number above 0.9 and at most 10000000 r_s (outside the horizon \
             at hole.spin = 0.6; observer rain goes on inside)",
        ),
        (
            // In the disk's plane the ergosphere reaches as far as a hole without spin, whatever
            // this one's.
            "hole.spin = 0.6\ncamera.r = 0.95\ncamera.theta_deg = 90",
            "camera.r = 0.95 is refused: it must be a number above 1 and at most 10000000 r_s (nothing is at rest in the \
             ergosphere, which reaches this far at hole.spin = 0.6 and camera.theta_deg = 90; observers zamo and rain go \
             deeper)",
        ),
        (
            "camera.r = 0.5\nobserver.kind = \"rain\"\n[effects]\ndoppler = false\naberration = false",
            "camera.r = 0.5 is refused: it must be a number above 1 and at most 10000000 r_s (outside the horizon at hole.spin \
             = 0, where effects.doppler, effects.aberration is false)",
        ),
        (
            // Free fall goes on inside.
            "camera.r = 0.09\nobserver.kind = \"rain\"",
            "camera.r = 0.09 is refused: it must be a number from 0.1 to 10000000 r_s (nine tenths of the way between \
             the horizons at hole.spin = 0)",
        ),
        (
            "disk.inner = 11",
            "disk.inner = 11 is refused: it must be a number above 0 and below 11 r_s (disk.outer is 11)",
        ),
        (
            "disk.inner = 5\ndisk.outer = 4",
            "disk.inner = 5 is refused: it must be a number above 0 and below 4 r_s (disk.outer is 4)",
        ),
        (
            // No inner edge makes this outer edge possible.
            "disk.outer = 2.5",
            "disk.outer = 2.5 is refused: it must be a number above 3 and at most 1000000 r_s (the innermost stable circular \
             orbit at hole.spin = 0)",
        ),
        (
            // 6M: Bardeen, Press & Teukolsky 1972 eq. 2.21.
            "disk.outer = 2\ndisk.inner = 1",
            "disk.outer = 2 is refused: it must be a number above 3 and at most 1000000 r_s (the innermost stable circular \
             orbit at hole.spin = 0)",
        ),
        (
            "disk.inner = 4\nhot_spot.kind = \"rigid\"\nhot_spot.r = 3.5",
            "hot_spot.r = 3.5 is refused: it must be a number from 4 to 11 r_s (between the edges of the disk)",
        ),
        (
            "hole.spin = 0.5\ndisk.tilt_deg = 30",
            "disk.tilt_deg = 30 is refused: it must be 0 degrees (a thin disk around a hole that spins, here with hole.spin = 0.5, \
             is steady in the equator only)",
        ),
        (
            "disk.period = 1.5",
            "disk.period = 1.5 is refused: it must be a number from 2 to 1000000 r_s/c (0 for a structure that never \
             repeats)",
        ),
        (
            "disk.period = -1",
            "disk.period = -1 is refused: it must be a number from 0 to 1000000 r_s/c",
        ),
        (
            "picture.grid_height = 541",
            "picture.grid_height = 541 is refused: it must be an integer from 9 to 540 cells (picture.height is 540)",
        ),
    ] {
        assert_eq!(preset(text), format!("my.toml: {sentence}"));
    }
    // Bardeen, Press & Teukolsky 1972 eq. 2.18 at chi = -0.5: M (2 + 2 cos(2 pi / 9)) =
    // 1.76604444311897804, rounded up to six digits, so that the stated limit is allowed.
    let orbit = preset(
        "hole.spin = -0.5\ncamera.r = 1.7\ncamera.theta_deg = 90\nobserver.kind = \"orbit\"",
    );
    assert!(
        orbit.starts_with(
            "my.toml: camera.r = 1.7 is refused: it must be a number above 1.76605 and"
        ),
        "{orbit}"
    );
    assert!(
        orbit.ends_with(" (outside the prograde photon orbit at hole.spin = -0.5)"),
        "{orbit}"
    );
    assert!(
        with(
            "hole.spin = 0.6\ncamera.r = 0.9000001\nobserver.kind = \"zamo\"",
            &[]
        )
        .is_ok()
    );
    assert!(
        with(
            "hole.spin = 0.6\ncamera.r = 0.9000001\ncamera.theta_deg = 0",
            &[]
        )
        .is_ok()
    );
}

#[test]
fn the_value_that_was_set_last_is_blamed() {
    let from = |text, sets: &[&str]| {
        with(text, sets)
            .unwrap_err()
            .to_string()
            .split(": ")
            .next()
            .unwrap()
            .to_owned()
    };
    assert_eq!(
        from("camera.r = 0.9\nhole.spin = 0.1", &["disk.outer=20"]),
        "my.toml"
    );
    assert_eq!(from("hole.spin = 0.1", &["camera.r=0.9"]), "--set");
    // Of two that conflict the one that was set last, whichever has the range.
    let sentence = |sets: &[&str]| {
        with("camera.r = 0.8\nobserver.kind = \"rain\"", sets)
            .unwrap_err()
            .to_string()
    };
    let refused_with = "is refused together with camera.r = 0.8, which must then be a number above 1 and at most 10000000 r_s (outside the \
                  horizon at hole.spin = 0; observer rain goes on inside)";
    assert_eq!(
        sentence(&["observer.kind=zamo"]),
        format!("--set: observer.kind = \"zamo\" {refused_with}")
    );
    assert_eq!(
        sentence(&["observer.kind=zamo", "hole.spin=0"]),
        format!("--set: hole.spin = 0 {refused_with}")
    );
    assert_eq!(
        sentence(&["observer.kind=zamo", "hole.spin=0", "camera.r=0.8"])
            .split(" (")
            .next()
            .unwrap(),
        {
            "--set: camera.r = 0.8 is refused: it must be a number above 1 and at most 10000000 r_s"
        }
    );
    assert_eq!(
        sentence(&["disk.inner=5", "disk.outer=4"]),
        "--set: disk.outer = 4 is refused together with disk.inner = 5, which must then be a number above 0 and below 4 r_s"
    );
    // The edge that follows the innermost stable orbit does not need disk.inner, which is 3.
    let near = ["hole.spin=0.9", "disk.follow_isco=true", "disk.outer=2"];
    assert_eq!(with("", &near).unwrap().disk.outer, 2.0);
    assert_eq!(
        with("disk.follow_isco = true", &["disk.outer=0.5"])
            .unwrap_err()
            .to_string(),
        "--set: disk.outer = 0.5 is refused: it must be a number above 3 and at most 1000000 r_s (the innermost stable \
         circular orbit at hole.spin = 0)"
    );
    assert_eq!(
        with("", &[&near[..], &["disk.follow_isco=false"]].concat())
            .unwrap_err()
            .to_string(),
        "--set: disk.follow_isco = false is refused together with disk.inner = 3, which must then be a number above 0 and \
         below 2 r_s (disk.outer is 2)"
    );
    let tilted = with("disk.tilt_deg = 30", &["hole.spin=0.9"]).unwrap_err();
    assert_eq!(
        tilted.to_string(),
        "--set: hole.spin = 0.9 is refused together with disk.tilt_deg = 30, which must then be 0 degrees (a thin disk around \
         a hole that spins, here with hole.spin = 0.9, is steady in the equator only)"
    );
    let spin = load("my.toml", "", &[Override::new("--spin", "hole.spin", "2")])
        .unwrap_err()
        .to_string();
    assert_eq!(
        spin,
        "--spin: hole.spin = 2 is refused: it must be a number above -1 and below 1"
    );
}

#[test]
fn changing_one_field_of_a_scene_blames_that_field() {
    let scene = Scene::default();
    let refused =
        |key: &str, value: f64| scene.with([(key, value.into())]).unwrap_err().to_string();
    assert_eq!(
        refused("disk.outer", 2.0),
        "disk.outer = 2 is refused: it must be a number above 3 and at most 1000000 r_s (the innermost stable circular \
         orbit at hole.spin = 0)"
    );
    let wide = scene.with([("disk.inner", 5.0.into())]).unwrap();
    assert_eq!(
        wide.with([("disk.outer", 4.0.into())])
            .unwrap_err()
            .to_string(),
        "disk.outer = 4 is refused together with disk.inner = 5, which must then be a number above 0 and below 4 r_s"
    );
    assert_eq!(
        refused("disk.inner", 12.0),
        "disk.inner = 12 is refused: it must be a number above 0 and below 11 r_s (disk.outer is 11)"
    );
}
