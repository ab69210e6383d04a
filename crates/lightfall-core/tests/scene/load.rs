//! What a preset may contain, and the one sentence that refuses everything else.

use crate::journey_faults::without_line;
use lightfall_core::scene::{Method, ObserverKind, Override, Projection, Scene, load};

/// What is said of a preset, without the number of the line, which tests of its own check.
fn preset(text: &str) -> String {
    without_line(&load("my.toml", text, &[]).unwrap_err().to_string())
}

fn with(text: &str, sets: &[&str]) -> Result<Scene, String> {
    let overrides: Result<Vec<_>, _> = sets.iter().map(|set| Override::assignment(set)).collect();
    load(
        "my.toml",
        text,
        &overrides.map_err(|error| error.to_string())?,
    )
    .map_err(|error| error.to_string())
}

fn set(assignment: &str) -> String {
    with("", &[assignment]).unwrap_err()
}

#[test]
fn an_empty_preset_is_the_default_scene() {
    assert_eq!(with("", &[]), Ok(Scene::default()));
}

#[test]
fn fields_that_are_not_mentioned_keep_their_defaults() {
    let scene = with("[camera]\nr = 12.5", &[]).unwrap();
    assert_eq!(scene.camera.r, 12.5);
    assert_eq!(
        Scene {
            camera: Scene::default().camera,
            ..scene
        },
        Scene::default()
    );
}

#[test]
fn a_whole_number_is_accepted_for_a_float() {
    assert_eq!(
        with("camera.r = 12\nobserver.velocity = [0, 0, 0.5]", &[])
            .unwrap()
            .camera
            .r,
        12.0
    );
}

#[test]
fn overrides_replace_the_presets_values_and_the_last_one_wins() {
    let scene = with(
        "camera.r = 12",
        &["camera.r=13", "camera.r = 14", "camera.theta_deg=.5"],
    )
    .unwrap();
    assert_eq!((scene.camera.r, scene.camera.theta_deg), (14.0, 0.5));
}

#[test]
fn overrides_are_read_as_people_type_them() {
    let sets = [
        "method=verlet",
        "observer.kind = \"rain\"",
        "observer.velocity=0, .25 ,1e-1",
        "name=7",
        "title=a=b c",
    ];
    let scene = with(
        "",
        &[&sets[..], &["picture.dither=false", "hole.spin=-.5"]].concat(),
    )
    .unwrap();
    assert_eq!(
        (scene.method, scene.observer.kind),
        (Method::Verlet, ObserverKind::Rain)
    );
    assert_eq!(scene.observer.velocity, [0.0, 0.25, 0.1]);
    assert_eq!((scene.name.as_str(), scene.title.as_str()), ("7", "a=b c"));
    assert_eq!((scene.picture.dither, scene.hole.spin), (false, -0.5));
}

#[test]
fn a_value_out_of_range_is_refused_with_its_origin_and_the_range() {
    for (text, sentence) in [
        (
            "hole.spin = 1",
            "hole.spin = 1 is refused: it must be a number above -1 and below 1",
        ),
        (
            "hole.spin = -1.5",
            "hole.spin = -1.5 is refused: it must be a number above -1 and below 1",
        ),
        (
            "camera.theta_deg = 181",
            "camera.theta_deg = 181 is refused: it must be a number from 0 to 180 degrees",
        ),
        (
            "quality.step_scale = 0",
            "quality.step_scale = 0 is refused: it must be a number above 0 and at most 16",
        ),
        (
            "quality.max_steps = 16385",
            "quality.max_steps = 16385 is refused: it must be an integer from 1 to 16384 steps",
        ),
        (
            "quality.escape_radius = -1",
            "quality.escape_radius = -1 is refused: it must be a number from 0 to 1000000000 r_s",
        ),
        (
            "quality.min_step = 2",
            "quality.min_step = 2 is refused: it must be a number from 0 to 1 r_s",
        ),
        (
            "picture.width = 0",
            "picture.width = 0 is refused: it must be an integer from 1 to 32768 pixels",
        ),
        (
            "picture.width = -5",
            "picture.width = -5 is refused: it must be an integer from 1 to 32768 pixels",
        ),
        (
            "sky.seed = 4294967296",
            "sky.seed = 4294967296 is refused: it must be an integer from 0 to 4294967295",
        ),
        (
            "probe.size = 0.0",
            "probe.size = 0 is refused: it must be a number above 0 and at most 1000 r_s",
        ),
        (
            "camera.yaw_deg = nan",
            "camera.yaw_deg = NaN is refused: it must be a number from -360 to 360 degrees",
        ),
        // The range that holds here, as of any other number.
        (
            "camera.r = nan",
            "camera.r = NaN is refused: it must be a number above 1 and at most 10000000 r_s (outside the horizon at \
             hole.spin = 0; observer rain goes on inside)",
        ),
        (
            "camera.yaw_deg = -inf",
            "camera.yaw_deg = -inf is refused: it must be a number from -360 to 360 degrees",
        ),
        (
            "observer.velocity = [0, 0.6, 0.8]",
            "observer.velocity = [0, 0.6, 0.8] is refused: it must be three numbers, [outward, toward growing theta, \
             toward growing phi], of length below 1 c",
        ),
    ] {
        assert_eq!(preset(text), format!("my.toml: {sentence}"));
    }
}

#[test]
fn a_value_of_the_wrong_type_is_refused_with_the_right_type() {
    for (text, sentence) in [
        (
            "disk.enabled = 1",
            "disk.enabled = 1 is refused: it must be true or false",
        ),
        (
            "hole.spin = \"fast\"",
            "hole.spin = \"fast\" is refused: it must be a number above -1 and below 1",
        ),
        (
            "picture.width = 960.0",
            "picture.width = 960 is refused: it must be an integer from 1 to 32768 pixels",
        ),
        (
            "method = \"euler\"",
            "method = \"euler\" is refused: it must be one of auto, verlet, closed, mino, kerr-schild, reference",
        ),
        (
            "sky.mode = true",
            "sky.mode = true is refused: it must be one of stars, procedural, grid, picture, off",
        ),
        (
            "name = 7",
            "name = 7 is refused: it must be one line of text, at most 200 characters",
        ),
        (
            "name = \"a\\nb\"",
            "name = \"a\\nb\" is refused: it must be one line of text, at most 200 characters",
        ),
        (
            "[camera.r]",
            "camera.r = {...} is refused: it must be a number above 1 and at most 10000000 r_s \
             (outside the horizon at hole.spin = 0; observer rain goes on inside)",
        ),
        (
            "camera = 3",
            "camera = 3 is refused: camera is a table of fields, such as camera.r",
        ),
        (
            "[[camera]]",
            "camera = [{...}] is refused: camera is a table of fields, such as camera.r",
        ),
    ] {
        assert_eq!(preset(text), format!("my.toml: {sentence}"));
    }
}

#[test]
fn an_unknown_field_is_refused_with_the_nearest_name() {
    for (key, hint) in [
        ("hole.spinn", "did you mean hole.spin?"),
        ("spin", "did you mean hole.spin?"),
        ("camera.theta", "did you mean camera.theta_deg?"),
        ("camera.Fov_deg", "did you mean camera.fov_deg?"),
        ("disk.temperature", "did you mean disk.temperature_k?"),
        ("picture.exposure", "did you mean picture.exposure_ev?"),
        ("methd", "did you mean method?"),
        (
            "camera.radius",
            "camera has r, theta_deg, phi_deg, fov_deg, yaw_deg, pitch_deg, roll_deg, tilt_deg, projection, fisheye_deg, circle, shift",
        ),
        ("weather", "`lightfall presets show 2` lists them all"),
    ] {
        assert_eq!(
            preset(&format!("{key} = 1")),
            format!("my.toml: there is no field {key}; {hint}")
        );
        assert_eq!(
            set(&format!("{key}=1")),
            format!("--set: there is no field {key}; {hint}")
        );
    }
}

#[test]
fn a_quoted_key_with_a_dot_is_not_a_field() {
    assert!(preset("\"camera.r\" = 5").starts_with("my.toml: there is no field camera.r"));
}

#[test]
fn another_version_of_the_format_is_reported_before_any_other_fault() {
    assert_eq!(
        preset("schema = 2\nfuture = true"),
        "my.toml: schema = 2 is another version of the preset format; this program reads schema 1"
    );
    assert_eq!(
        set("schema=2"),
        "--set: schema = 2 is refused: it must be 1"
    );
}

#[test]
fn a_fault_of_a_preset_has_the_line_of_its_field() {
    for (text, start) in [
        (
            "schema = 1\n[camera]\ntheta = 90",
            "line 3: there is no field camera.theta; did you mean camera.theta_deg?",
        ),
        ("\n\ncamera.r = 0.5", "line 3: camera.r = 0.5 is refused"),
        (
            "[disk]\nouter = 4\ninner = 5",
            "line 3: disk.inner = 5 is refused",
        ),
        (
            "camera.r = 20\ncamera.fov_deg = \"wide\"",
            "line 2: camera.fov_deg = \"wide\" is",
        ),
        ("\ncamera = 3", "line 2: camera = 3 is refused"),
        (
            "title = \"a\"\nschema = 2",
            "line 2: schema = 2 is another version",
        ),
    ] {
        let said = load("my.toml", text, &[]).unwrap_err().to_string();
        assert!(said.starts_with(&format!("my.toml: {start}")), "{said}");
    }
    // An override stands in no line.
    let (said, start) = (
        set("camera.theta=1"),
        "--set: there is no field camera.theta;",
    );
    assert!(said.starts_with(start), "{said}");
}

#[test]
fn a_decimal_comma_leads_to_the_number_that_was_meant() {
    for (assignment, meant) in [
        ("camera.r=2,5", "2.5"),
        ("hole.spin=-0,5", "-0.5"),
        ("camera.yaw_deg=,5", ".5"),
        ("camera.r=1,000", "1.000 or 1000"),
        ("camera.r=1,000,000", "1000000"),
        ("camera.r=0,125", "0.125"),
        ("disk.waves=24,0", "24"),
        ("quality.max_steps=1,024", "1024"),
        ("quality.max_steps=1,000", "1000"),
        ("observer.velocity=0,5,0,0", "decimal points, as in 0.5,0,0"),
    ] {
        let error = set(assignment);
        let hint = format!("; did you mean {meant}?");
        assert!(error.ends_with(&hint), "{error}");
    }
    for assignment in ["camera.r=2,5,1", "camera.r=a,b", "method=2,5", "title=2,5"] {
        let answer = with("", &[assignment]);
        let is_plain = answer
            .as_ref()
            .err()
            .is_none_or(|error| !error.contains("mean 2"));
        assert!(is_plain, "{answer:?}");
    }
    let error = preset("[camera]\nr = 2,5");
    assert!(error.ends_with("did you mean 2.5?"), "{error}");
}

#[test]
fn a_word_that_is_no_toml_is_answered_by_what_to_write() {
    for word in ["no", "yes", "off  # for now", "True"] {
        let error = preset(&format!("[disk]\nenabled = {word}"));
        assert!(error.contains("write true or false"), "{error}");
    }
    // Where something else is wrong, nothing is suggested.
    let twice = preset("[disk]\nenabled = true\nenabled = true");
    assert!(!twice.contains("write"), "{twice}");
}

#[test]
fn a_preset_of_empty_tables_is_refused() {
    assert_eq!(
        preset("[camera]\n[disk]"),
        "my.toml: no field has a value; a field is a line such as camera.r = 20"
    );
    assert_eq!(
        preset("[[keyframe]]\ntime = 0"),
        "my.toml: there is no field keyframe; this is a journey, which --journey flies"
    );
}

#[test]
fn an_override_needs_a_key_and_an_equals_sign() {
    assert_eq!(
        set("camera.r"),
        "--set: camera.r is not of the form KEY=VALUE, such as camera.r=20"
    );
    assert_eq!(
        set("=3"),
        "--set: =3 is not of the form KEY=VALUE, such as camera.r=20"
    );
    assert_eq!(
        set(""),
        "--set:  is not of the form KEY=VALUE, such as camera.r=20"
    );
    assert_eq!(
        set("camera.r="),
        "--set: camera.r = \"\" is refused: it must be a number above 1 and at most 10000000 r_s \
         (outside the horizon at hole.spin = 0; observer rain goes on inside)"
    );
}

#[test]
fn an_override_cannot_smuggle_in_a_second_field() {
    assert!(
        set("camera.r=20\nhole.spin = 0.5")
            .contains("camera.r = \"20\\nhole.spin = 0.5\" is refused")
    );
}

#[test]
fn a_pair_of_numbers_is_read_as_toml_or_as_people_write_it() {
    let shift = |set: &str| with("", &[set]).unwrap().camera.shift;
    assert_eq!(shift("camera.shift=[0.25, -1]"), [0.25, -1.0]);
    assert_eq!(shift("camera.shift=.25,-1"), [0.25, -1.0]);
    for wrong in ["1", "1,2,3", "11,0", "nan,0", "a,b", "true"] {
        let refusal = set(&format!("camera.shift={wrong}"));
        assert!(
            refusal.contains("two numbers, [to the right, upward], from -10 to 10 picture heights"),
            "{refusal}"
        );
    }
}

#[test]
fn every_projection_is_read_by_its_word_and_no_other_is() {
    for projection in Projection::ALL {
        let scene = with("", &[&format!("camera.projection={}", projection.word())]).unwrap();
        assert_eq!(scene.camera.projection, projection);
        // What a picture holds is read back as the same scene.
        assert_eq!(with(&scene.to_preset(), &[]).unwrap(), scene);
    }
    assert!(
        set("camera.projection=fish")
            .contains("one of perspective, fisheye, equirectangular, cube")
    );
    assert!(set("camera.fisheye_deg=0.5").contains("from 1 to 360 degrees"));
    assert!(set("camera.circle=4.1").contains("from 0.5 to 4"));
}
