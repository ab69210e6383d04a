//! Journeys that are refused: faults of the file, and places where the observer cannot exist.

use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey;
use lightfall_core::scene::{Hole, Method, Observer, ObserverKind, Scene, presets};

fn preset() -> Scene {
    presets::find("above").unwrap().scene(&[]).unwrap()
}

/// A sentence about a file without the number of its line, which a test of its own checks.
pub(crate) fn without_line(sentence: &str) -> String {
    let located = sentence.split_once(": line ");
    let located = located.and_then(|(file, rest)| Some((file, rest.split_once(": ")?)));
    match located {
        Some((file, (line, rest))) if line.parse::<u32>().is_ok() => format!("{file}: {rest}"),
        _ => sentence.to_owned(),
    }
}

/// A text with one fault after the other.
const FAULTY: &str = r#"[[keyframe]]
time = 2
r = 20
[[keyframe]]
time = 12
r = "3"
[[stop]]
at = 7
guides = "on"
side_by_side = "both"
[[stop]]
at = 5
effects.dopler = true
question = { text = "How much?", answer = "0,8165" }
[[stop]]
caption = "When?"
[[stop]]
at = 13
[[caption]]
time = 3
text = 7
"#;

#[test]
fn every_fault_of_a_journey_is_told_with_its_line() {
    let sentences = journey::load("j.toml", FAULTY).unwrap_err().sentences();
    let expected = [
        "line 6: keyframe 2: r = \"3\" is refused: it must be a number from 0.1 to 10000000 r_s",
        "line 21: caption 1: text = 7 is refused: it must be one line of text",
        "line 9: stop 1: guides = \"on\" is refused: it must be true or false",
        "line 10: stop 1: side_by_side = \"both\" is refused: it must be true, false or",
        "line 12: stop 2: at = 5 is refused: it must be above 7, the time of the stop before",
        "line 13: stop 2: there is no effects.dopler; did you mean effects.doppler?",
        "line 14: stop 2: question.answer = \"0,8165\" is refused: it must be a finite number",
        "line 14: stop 2: question.tolerance is missing: it must be a finite number above 0",
        "line 15: stop 3: at is missing: it must be a number of seconds from 2 to 12",
        "line 18: stop 4: at = 13 is refused: it must be a number of seconds from 2 to 12, within the journey: the last \
         [[keyframe]] must be as late as the last [[stop]]",
    ];
    assert_eq!(sentences.len(), expected.len(), "{sentences:#?}");
    for (sentence, expected) in sentences.iter().zip(expected) {
        let start = format!("j.toml: {expected}");
        assert!(sentence.starts_with(&start), "{sentence}\n{start}");
    }
    let first = journey::load("j.toml", FAULTY).unwrap_err().to_string();
    assert_eq!(first, sentences[0]);
    // A garbled file is not answered by a page of sentences.
    let many = "[[keyframe]]\nradius = 3\n".repeat(900);
    let sentences = journey::load("j.toml", &many).unwrap_err().sentences();
    assert_eq!(sentences.len(), 20);
}

#[test]
fn the_line_of_a_keyframes_fault_is_that_of_its_key_also_in_its_table_for_rain() {
    let frames = |second: &str| format!("[[keyframe]]\ntime = 0\n[[keyframe]]\n{second}");
    for (second, start) in [
        (
            "time = 1\n\nradius = 3",
            "line 6: keyframe 2: there is no radius",
        ),
        ("time = 1\nrain.r = -1", "line 5: keyframe 2: r = -1"),
        (
            "time = 1\nrain = { r = 2 }\nfov_deg = 0",
            "line 6: keyframe 2: fov_deg = 0",
        ),
        ("rain.r = 2", "line 3: keyframe 2: time is missing"),
        ("r = 2\ntime = 1\nrain.r = -1", "line 3: keyframe 2: r = -1"),
    ] {
        let sentence = journey::load("j.toml", &frames(second))
            .unwrap_err()
            .to_string();
        assert!(
            sentence.starts_with(&format!("j.toml: {start}")),
            "{sentence}"
        );
    }
    let top = journey::load("j.toml", "schema = 1\n\nspeed = 3").unwrap_err();
    assert!(
        top.to_string()
            .starts_with("j.toml: line 3: speed = 3 is refused")
    );
}

#[test]
fn faults_of_a_journey_are_reported_with_their_keyframe() {
    let two = "[[keyframe]]\ntime = 0\n[[keyframe]]\n";
    let fault = |text: &str| without_line(&journey::load("j.toml", text).unwrap_err().to_string());
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
            "j.toml: keyframe 2: time is missing: it must be a number of seconds above 0, the time of the keyframe \
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
            "j.toml: keyframe 2: there is no radius; a keyframe has time, ease, a table set of other fields of the scene, \
             any of r, theta_deg, phi_deg, yaw_deg, pitch_deg, roll_deg, fov_deg, observer, velocity, disk_tilt_deg, \
             disk_node_deg, disk_rate, disk_time, and a table rain of those but the observer and the disk's own, for an \
             observer that falls from rest at infinity",
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
    assert_eq!(
        fault("[[keyframe]\n"),
        "j.toml: `[[keyframe]` is no head of a table: write `[[keyframe]]`"
    );
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
        let fault = journey::load("j.toml", &format!("{keyframes}{caption}")).unwrap_err();
        without_line(&fault.to_string())
    };
    for (caption, sentence) in [
        (
            "text = \"A\"".to_owned(),
            "time is missing: it must be a number of seconds from 2 to 12, within the journey",
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
            "text is missing: it must be one line of text, from 1 to 160 characters long",
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
    assert!(fault("").starts_with("j.toml: caption 1: time is missing"));
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
