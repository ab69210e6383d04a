//! Journeys that are refused: faults of the file, and places where the observer cannot exist.

use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey;
use lightfall_core::scene::{Hole, Method, Observer, ObserverKind, Scene, presets};

fn preset() -> Scene {
    presets::find("above").unwrap().scene(&[]).unwrap()
}

#[test]
fn faults_of_a_journey_are_reported_with_their_keyframe() {
    let two = "[[keyframe]]\ntime = 0\n[[keyframe]]\n";
    let fault = |text: &str| journey::load("j.toml", text).unwrap_err().to_string();
    for (text, sentence) in [
        (String::new(), "j.toml: a journey has from 2 to 1000 tables [[keyframe]], and this one has 0"),
        ("[[keyframe]]\ntime = 1".into(), "j.toml: a journey has from 2 to 1000 tables [[keyframe]], and this one has 1"),
        (
            "schema = 2".into(),
            "j.toml: schema = 2 is another version of the preset format; this program reads schema 1",
        ),
        (
            "speed = 3".into(),
            "j.toml: speed = 3 is refused: a journey has schema = 1, title, teaches, ending, preset, and tables [[keyframe]], [[caption]] and [[stop]]",
        ),
        (
            "title = \"a\"\n[camera]\nr = 3".into(),
            "j.toml: camera belongs to a preset, and this must be a journey, which has schema = 1, title, teaches, ending, preset, and tables [[keyframe]], [[caption]] and [[stop]]",
        ),
        (
            "ending = 3".into(),
            "j.toml: ending = 3 is refused: it must be one line of text, from 1 to 160 characters long",
        ),
        (
            "keyframe = 3".into(),
            "j.toml: keyframe = 3 is refused: a journey has schema = 1, title, teaches, ending, preset, and tables [[keyframe]], [[caption]] and [[stop]]",
        ),
        (
            "preset = \"nowhere\"".into(),
            "j.toml: preset = \"nowhere\" is refused: it must be the name or the number of a built-in preset: \
             1 telescope, 2 edge-on, 3 above, 4 close, 5 einstein-ring, 6 probe, 7 limit, 8 extremal, 9 falling, \
             10 article, 11 flare, 12 ring, 13 orion, 14 thick, 15 torus, 16 close-thick, 17 lanes, 18 jet",
        ),
        (
            two.into(),
            "j.toml: keyframe 2: time = nothing is refused: it must be a number of seconds above 0, the time of the keyframe \
             before",
        ),
        (
            format!("{two}time = 0.0"),
            "j.toml: keyframe 2: time = 0 is refused: it must be a number of seconds above 0, the time of the keyframe before",
        ),
        (
            format!("{two}time = inf"),
            "j.toml: keyframe 2: time = inf is refused: it must be a number of seconds from 0 to 86400",
        ),
        (
            format!("{two}time = 1\nradius = 3"),
            "j.toml: keyframe 2: there is no radius; a keyframe has time, any of r, theta_deg, phi_deg, yaw_deg, \
             pitch_deg, roll_deg, fov_deg, observer, velocity, disk_tilt_deg, disk_node_deg, disk_rate, disk_time, and a \
             table rain of those but the observer and the disk's own, for an observer that falls from rest at infinity",
        ),
        (
            format!("{two}time = 1\nrain.theta_deg = 200"),
            "j.toml: keyframe 2: theta_deg = 200 is refused: it must be a number from 0 to 180 degrees",
        ),
        (
            format!("{two}time = 1\ntheta_deg = 181"),
            "j.toml: keyframe 2: theta_deg = 181 is refused: it must be a number from 0 to 180 degrees",
        ),
        (
            format!("{two}time = 1\nr = \"near\""),
            "j.toml: keyframe 2: r = \"near\" is refused: it must be a number from 0.1 to 10000000 r_s",
        ),
        (
            format!("{two}time = 1\nyaw_deg = nan"),
            "j.toml: keyframe 2: yaw_deg = NaN is refused: it must be a number of degrees",
        ),
        (
            format!("{two}time = 1\nobserver = \"fast\""),
            "j.toml: keyframe 2: observer = \"fast\" is refused: it must be one of static, zamo, orbit, rain",
        ),
        (
            "[[keyframe]]\ntime = 0\nvelocity = [0.8, 0, 0]\n[[keyframe]]\ntime = 1\nvelocity = [0, 0.8, 0]".into(),
            "j.toml: keyframe 2: velocity = [0, 0.8, 0] is refused: it must be nearer to that of the keyframe before, \
             [0.8, 0, 0]: on the way there it would reach 1 c",
        ),
    ] {
        assert_eq!(fault(&text), sentence);
    }
    for faulty in ["preset = 0", "preset = 2.0", "preset = [\"edge-on\"]"] {
        let sentence = fault(faulty);
        assert!(
            sentence.contains("it must be the name or the number of a built-in preset"),
            "{sentence}"
        );
    }
    for faulty in ["rain = 3", "rain.observer = \"rain\"", "rain.time = 3"] {
        let sentence = fault(&format!("{two}time = 1\n{faulty}"));
        assert!(
            sentence.starts_with("j.toml: keyframe 2: there is no "),
            "{sentence}"
        );
    }
    assert!(fault("[[keyframe]\n").starts_with("j.toml: line 1, column "));
}

fn fault_of(text: &str, scene: &Scene, from: f64) -> Option<String> {
    let checked = journey::load("j.toml", text)
        .unwrap()
        .check(scene, from, Drawable::new);
    checked.err().map(|fault| fault.to_string())
}

#[test]
fn faults_of_a_caption_are_reported_with_its_number_and_key() {
    let keyframes = "[[keyframe]]\ntime = 2\n[[keyframe]]\ntime = 12\n[[caption]]\n";
    let fault = |caption: &str| {
        journey::load("j.toml", &format!("{keyframes}{caption}"))
            .unwrap_err()
            .to_string()
    };
    for (caption, sentence) in [
        (
            "text = \"A\"".to_owned(),
            "time = nothing is refused: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "time = 1\ntext = \"A\"".into(),
            "time = 1 is refused: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "time = 12.5\ntext = \"A\"".into(),
            "time = 12.5 is refused: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "time = nan\ntext = \"A\"".into(),
            "time = NaN is refused: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "time = 3".into(),
            "text = nothing is refused: it must be one line of text, from 1 to 160 characters long",
        ),
        (
            "time = 3\ntext = \"  \"".into(),
            "text = \"  \" is refused: it must be one line of text, from 1 to 160 characters long",
        ),
        (
            "time = 3\ntext = 7".into(),
            "text = 7 is refused: it must be one line of text, from 1 to 160 characters long",
        ),
        (
            "time = 3\ntext = \"two\\nlines\"".into(),
            "text = \"two\\nlines\" is refused: it must be one line of text, from 1 to 160 characters long",
        ),
        (
            "time = 3\nseconds = 0.5\ntext = \"A\"".into(),
            "seconds = 0.5 is refused: it must be a number of seconds from 1 to 60",
        ),
        (
            "time = 3\nseconds = \"long\"\ntext = \"A\"".into(),
            "seconds = \"long\" is refused: it must be a number of seconds from 1 to 60",
        ),
    ] {
        assert_eq!(fault(&caption), format!("j.toml: caption 1: {sentence}"));
    }
    assert_eq!(
        fault("time = 3\ntext = \"A\"\ncolour = 3"),
        "j.toml: caption 1: there is no colour; a caption has time, seconds and text"
    );
    assert_eq!(
        fault("time = 3\ntext = \"A\"\n[[caption]]\ntime = 3\ntext = \"B\""),
        "j.toml: caption 2: time = 3 is refused: it must be above 3, the time of the caption before"
    );
    let long = "a".repeat(161);
    assert!(
        fault(&format!("time = 3\ntext = \"{long}\"")).starts_with("j.toml: caption 1: text = ")
    );
    let many = "time = 3\ntext = \"A\"\n".to_owned() + &"[[caption]]\n".repeat(1000);
    assert_eq!(
        fault(&many),
        "j.toml: a journey has at most 1000 tables [[caption]], and this one has 1001"
    );
    assert!(fault("").starts_with("j.toml: caption 1: time = nothing"));
}

#[test]
fn a_journey_is_refused_where_its_observer_cannot_exist() {
    let at = |spin| Scene {
        hole: Hole { spin },
        ..preset()
    };
    assert_eq!(fault_of(journey::DEFAULT, &preset(), 0.0), None);
    // Each end can be, and on the way the radius falls faster than the ergosphere shrinks toward
    // the axis.
    let dive = "[[keyframe]]\ntime = 1\nr = 1.02\ntheta_deg = 90\n[[keyframe]]\ntime = 5\nr = 0.73\ntheta_deg = 1";
    let sentence = fault_of(dive, &at(0.9), 0.0).unwrap();
    assert!(
        sentence.starts_with("between keyframes 1 and 2 (time = "),
        "{sentence}"
    );
    assert!(
        sentence.contains(" is refused: it must be a number above 0.9"),
        "{sentence}"
    );
    // The observer changes at the keyframe: just before it is still the old one.
    let late = "[[keyframe]]\ntime = 0\nr = 2\nobserver = \"static\"\n[[keyframe]]\ntime = 1\nr = 0.999\nobserver = \"rain\"";
    let sentence = fault_of(late, &at(0.0), 0.0).unwrap();
    assert!(
        sentence.starts_with("between keyframes 1 and 2 (time = "),
        "{sentence}"
    );
    let early = "[[keyframe]]\ntime = 0\nr = 0.5\nobserver = \"rain\"\n[[keyframe]]\ntime = 1\nobserver = \"zamo\"\n\
                 [[keyframe]]\ntime = 2\nr = 1.1";
    assert!(
        fault_of(early, &at(0.0), 0.0)
            .unwrap()
            .starts_with("keyframe 2 (time = 1): camera.r = ")
    );
    assert_eq!(
        fault_of(early, &at(0.0), 1.9),
        None,
        "what has been flown already is not asked again"
    );
    // Other rules than of places: a circular orbit off the plane, and a method that cannot begin
    // inside.
    let orbit = "[[keyframe]]\ntime = 0\nr = 5\nobserver = \"orbit\"\n[[keyframe]]\ntime = 1\ntheta_deg = 80";
    assert!(
        fault_of(orbit, &at(0.0), 0.0)
            .unwrap()
            .contains("it must be 90, the plane of the disk")
    );
    let rain = Observer {
        kind: ObserverKind::Rain,
        ..preset().observer
    };
    let verlet = Scene {
        method: Method::Verlet,
        observer: rain,
        ..preset()
    };
    assert!(
        fault_of(journey::DEFAULT, &verlet, 0.0)
            .unwrap()
            .contains("methods verlet and kerr-schild cannot start a ray")
    );
}
