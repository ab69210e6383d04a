//! The ray inspector in the window: what it copies is what the reference and the GPU answer.

use crate::WINDOW;
use crate::desktop::Desktop;
use crate::shot::Shot;
use glam::DVec2;
use lightfall_core::accuracy::Ray;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::numbers::four_digits;
use lightfall_core::scene::presets;
use watched::State;

/// Width of the inspector's panel.
const INSPECTOR_WIDTH: f64 = 390.0;
/// Its width, with some room.
const INSPECTOR: usize = 420;

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_click_shows_and_copies_the_ray_of_that_pixel() {
    let desktop = Desktop::open(&["--preset", "2", "--spin", "0.7"]);
    let start = desktop.first_picture();
    desktop.press("i");
    let shows = |shot: &Shot, other: &Shot| shot.changed(other, 0..INSPECTOR, 0..400);
    let empty = desktop.settled("inspector", |shot| shows(shot, &start) > 0.3);
    let scene = presets::find("2").unwrap().scene(&[]).unwrap();
    let mut scene = scene;
    scene.hole.spin = 0.7;
    for (x, y) in [(720, 180), (760, 400), (1000, 440), (1300, 60)] {
        desktop.click_at([x, y]);
        desktop.settled("numbers", |shot| shows(shot, &empty) > 0.02);
        let json = copied(&desktop);
        // Three pixels of the window are two of the picture, which lies beside the inspector.
        let place = DVec2::new(f64::from(x) - INSPECTOR_WIDTH, f64::from(y));
        let pixel = (place * (960.0 / 1440.0)).floor() + 0.5;
        assert_eq!(json["pixel"], serde_json::json!([pixel.x, pixel.y]));
        let ray = Ray::toward(scene.camera.looking(pixel, DVec2::new(700.0, 540.0)));
        let direction = scene.camera.tetrad_from_camera() * ray.direction();
        let expected = Inspected::new(&scene, direction, Some(pixel.to_array()), 120.0)
            .unwrap()
            .numbers;
        let expected = serde_json::to_value(&expected).unwrap();
        for field in [
            "cpu",
            "impact_parameter",
            "lambda",
            "eta",
            "closest_r",
            "half_turns",
            "order",
            "hit1_delay",
        ] {
            same(field, &json[field], &expected[field]);
        }
        assert_eq!(json["difference"]["same_class"], true, "{json}");
        assert_eq!(json["gpu"]["outcome"], json["cpu"]["outcome"]);
        // The error that method mino states.
        assert!(
            json["difference"]["backward"].as_f64().unwrap() < 1e-5,
            "{json}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn the_wheel_over_a_panel_that_has_just_opened_belongs_to_the_panel() {
    let desktop = Desktop::open(&["--preset", "2"]);
    let start = desktop.first_picture();
    let inspector = |a: &Shot, b: &Shot| a.changed(b, 0..INSPECTOR, 0..WINDOW.1);
    // Within the inspector to be. The mouse brings the read-outs, the speed of flight among them.
    desktop.point(200, 300);
    let shown = desktop.wait_for("the speed", |state| speed(state).is_some());
    desktop.press("i");
    let before = desktop.settled("inspector", |shot| inspector(shot, &start) > 0.3);
    desktop.press("i");
    desktop.settled("no inspector", |shot| inspector(shot, &before) > 0.3);
    desktop.press("i");
    (0..3).for_each(|_| desktop.wheel());
    // The wheel zooms the drawing if it is there by then.
    desktop.settled("inspector again", |shot| inspector(shot, &start) > 0.3);
    desktop.point(202, 300);
    let now = desktop.wait_for("the speed", |state| speed(state).is_some());
    assert_eq!(speed(&now), speed(&shown));
}

/// The read-out of the flying speed, while it is shown.
fn speed(state: &State) -> Option<&str> {
    let is_factor = |words: &&str| words.len() > "×".len() && words.ends_with('×');
    state.texts.iter().map(|text| &*text.words).find(is_factor)
}

/// The JSON that is copied once the GPU has answered.
fn copied(desktop: &Desktop) -> serde_json::Value {
    copied_once(desktop, |json| !json["gpu"].is_null())
}

/// The JSON that is copied once it is so.
fn copied_once(desktop: &Desktop, is_so: impl Fn(&serde_json::Value) -> bool) -> serde_json::Value {
    let json = || {
        let text = desktop.clipboard().unwrap_or_default();
        serde_json::from_str::<serde_json::Value>(&text).unwrap_or_default()
    };
    desktop.wait("the GPU's answer", || {
        desktop.click("Copy JSON");
        is_so(&json())
    });
    json()
}

/// Whether two values are the same, numbers but for the last place, which a JSON reader may miss.
fn same(field: &str, a: &serde_json::Value, b: &serde_json::Value) {
    match (a.as_f64(), b.as_f64()) {
        (Some(x), Some(y)) => assert!(
            (x - y).abs() <= 4.0 * f64::EPSILON * y.abs(),
            "{field}: {x} and not {y}"
        ),
        _ if a.is_object() => {
            for (name, value) in a.as_object().unwrap() {
                same(name, value, &b[name]);
            }
        }
        _ => assert_eq!(a, b, "{field}"),
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn of_two_whole_pictures_a_click_traces_the_pixel_of_the_one_that_it_meets() {
    let desktop = Desktop::open(&["--preset", "2", "--set", "picture.bypass=true"]);
    desktop.first_picture();
    for key in ["i", "0", "0"] {
        desktop.press(key);
    }
    desktop.wait_for("two whole pictures", |state| {
        state.comparison == "two pictures"
    });
    let mut scene = presets::find("2").unwrap().scene(&[]).unwrap();
    // Without cells, the picture beside the inspector has the window's pixels.
    (scene.picture.width, scene.picture.height) = (1050, 810);
    let half = scene.widened(2.0, 525);
    for ([x, y], first) in [
        ([600, 300], 0.0),
        ([1130, 300], 525.0),
        ([1300, 500], 525.0),
    ] {
        desktop.click_at([x, y]);
        let place = DVec2::new(f64::from(x) - INSPECTOR_WIDTH, f64::from(y));
        let pixel = place.floor() + 0.5 - DVec2::new(first, 0.0);
        let clicked = serde_json::json!([pixel.x, pixel.y]);
        let json = copied_once(&desktop, |json| json["pixel"] == clicked);
        let ray = Ray::toward(half.camera.looking(pixel, DVec2::new(525.0, 810.0)));
        let direction = half.camera.tetrad_from_camera() * ray.direction();
        let expected = Inspected::new(&half, direction, Some(pixel.to_array()), 120.0);
        let expected = serde_json::to_value(&expected.unwrap().numbers).unwrap();
        for field in ["cpu", "impact_parameter", "order"] {
            same(field, &json[field], &expected[field]);
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn a_handout_of_the_ray_is_a_new_file_and_replaces_none() {
    let desktop = Desktop::open(&["--preset", "2"]);
    desktop.first_picture();
    desktop.press("i");
    desktop.wait_for("the inspector", |state| state.shows("Ray inspector"));
    desktop.click_at([760, 400]);
    let json = copied(&desktop);
    let folder = desktop.home.path().join("Pictures");
    for number in 1..=2 {
        let file = folder.join(format!("lightfall-edge-on-ray-000{number}.svg"));
        desktop.click("Handout");
        desktop.wait("the handout", || file.is_file());
        let page = std::fs::read_to_string(file).unwrap();
        let closest = four_digits(json["closest_r"].as_f64().unwrap());
        assert!(
            page.ends_with("</svg>\n") && page.contains(&closest),
            "{page}"
        );
    }
}
