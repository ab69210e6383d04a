//! The stops of journeys: how they are read, refused and written, and what they switch.

use crate::journey_faults::without_line;
use crate::random::Random;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::{
    self, Draft, InspectorView, Journey, LESSONS, Shown, SideBySide, Unflyable, load,
};
use lightfall_core::scene::presets::{PRESETS, find};
use lightfall_core::scene::{JudgedAnswer, ObserverKind, Scene, Value, View, typed_number};

const KEYFRAMES: &str = "[[keyframe]]\ntime = 2\nr = 20\n[[keyframe]]\ntime = 12\nr = 10\n";

fn journey_with(stops: &str) -> Journey {
    load("j.toml", &format!("{KEYFRAMES}{stops}")).unwrap()
}

fn fault(stops: &str) -> String {
    let text = format!("{KEYFRAMES}{stops}");
    load("j.toml", &text).unwrap_err().to_string()
}

#[test]
fn a_stop_is_read_with_everything_that_it_may_have() {
    let journey = journey_with(
        "[[stop]]\nat = 3.5\ncaption = \"\"\"\n  One.\r\n\nTwo \"\"\"\neffects.doppler = false\nview = \"redshift\"\n\
         guides = true\nside_by_side = false\ninspector = { at = [0.25, 1] }\n\
         question = { text = \"How large?\", answer = 3, tolerance = 0.1, unit = \"r_s\", hint = \"Count.\" }\n\
         [[stop]]\nat = 12\ninspector = { toward = [-1, 0, 0.5] }\n",
    );
    let [first, second] = journey.stops.as_slice() else {
        panic!("{:?}", journey.stops)
    };
    assert_eq!(first.time, 1.5);
    assert_eq!(first.caption, "One.\n\nTwo");
    let fields = [
        ("effects.doppler", Value::Boolean(false)),
        ("view", Value::Word("redshift")),
    ];
    assert_eq!(first.fields, fields);
    assert_eq!(
        (first.guides, first.side_by_side),
        (Some(true), Some(SideBySide::Off))
    );
    assert_eq!(first.inspector, Some(InspectorView::Place([0.25, 1.0])));
    let question = first.question.as_ref().unwrap();
    let judged = |number: f64, is_right: bool, said: &str| JudgedAnswer {
        number,
        is_right,
        said: said.into(),
    };
    assert_eq!(
        question.judge("2,95 r_s"),
        Ok(judged(2.95, true, "Right: it is 3 r_s"))
    );
    assert_eq!(
        question.judge("4"),
        Ok(judged(4.0, false, "It is not 4. Count."))
    );
    assert_eq!(
        question.judge("large"),
        Err("\"large\" is not a number".into())
    );
    assert_eq!(
        second.inspector,
        Some(InspectorView::Toward([-1.0, 0.0, 0.5]))
    );
    assert_eq!((second.time, second.caption.as_str()), (10.0, ""));
}

#[test]
fn answers_are_read_as_people_write_numbers() {
    for (typed, unit, number) in [
        ("6.25", "", 6.25),
        (" 6,25 ", "", 6.25),
        ("-1,5", "", -1.5),
        ("\u{2212}1.5", "", -1.5),
        ("6.6e7", "km", 6.6e7),
        ("66 million km", "million km", 66.0),
        ("66", "million km", 66.0),
        ("6.25%", "", 0.0625),
        ("6,25 %", "", 0.0625),
        ("6.25 %", "%", 6.25),
        ("1/16", "", 0.0625),
        ("27 / 4", "", 6.75),
        ("2,5/4", "r_s", 0.625),
        ("75.4°", "", 75.4),
        ("75,4 °", "degrees", 75.4),
        ("75.4 degrees", "degrees", 75.4),
        ("75.4°", "°", 75.4),
    ] {
        assert_eq!(typed_number(typed, unit), Some(number), "{typed}");
    }
    for typed in [
        "", " ", "large", "1/0", "0/0", "1/2/3", "/", "1/", "%", "°", "inf", "nan", "1/inf",
        "1 000", "1.234,5", "6.25 %%", "3 km",
    ] {
        assert_eq!(typed_number(typed, "r_s"), None, "{typed}");
    }
}

#[test]
fn faults_of_a_stop_are_reported_with_its_number_and_key_and_unknown_keys_with_their_line() {
    let known = "a stop has at, caption, guides, side_by_side, inspector, question, and fields of the scene such as view \
        or effects.doppler";
    for (stop, sentence) in [
        (
            "",
            "at is missing: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "at = 13",
            "at = 13 is refused: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "at = nan",
            "at = NaN is refused: it must be a number of seconds from 2 to 12, within the journey",
        ),
        (
            "at = 5\n[[stop]]\nat = 5.0",
            "at = 5 is refused: it must be above 5, the time of the stop before",
        ),
        (
            "at = 5\nguides = 1",
            "guides = 1 is refused: it must be true or false",
        ),
        (
            "at = 5\nside_by_side = \"on\"",
            "side_by_side = \"on\" is refused: it must be true, false or \"two-pictures\"",
        ),
        (
            "at = 5\ncaption = 3",
            "caption = 3 is refused: it must be a text of at most 10 lines and 700 characters",
        ),
        (
            "at = 5\nview = \"x-ray\"",
            "view = \"x-ray\" is refused: it must be one of colour, unfinished,",
        ),
        (
            "at = 5\neffects.doppler = 0",
            "effects.doppler = 0 is refused: it must be true or false",
        ),
        (
            "at = 5\nsky.brightness = -1",
            "sky.brightness = -1 is refused: it must be a number from 0 to 1000",
        ),
        (
            "at = 5\ninspector = { at = [0.5, 2] }",
            "inspector = {...} is refused: it must be true, false, { at =",
        ),
        (
            "at = 5\ninspector = { toward = [0, 0, 0] }",
            "inspector = {...} is refused: it must be true, false,",
        ),
        (
            "at = 5\nquestion = 3",
            "question = 3 is refused: it must be a table with text, answer and tolerance",
        ),
        (
            "at = 5\nquestion = { text = \"a\", answer = nan, tolerance = 0 }",
            "question.answer = NaN is refused: it must be a finite number",
        ),
        (
            "at = 5\nquestion = { text = \"a\", answer = 1, tolerance = -1 }",
            "question.tolerance = -1 is refused: it must be a finite number above 0",
        ),
        (
            "at = 5\nquestion = { text = \"a\", answer = 1, tolerance = 0 }",
            "question.tolerance = 0 is refused: it must be a finite number above 0",
        ),
        (
            "at = 5\nquestion = { answer = 1, tolerance = 1 }",
            "question.text is missing: it must be one line of text, from 1 to 400 characters long",
        ),
        (
            "at = 5\nquestion = { text = \"a\", answer = 1, tolerance = 1, hint = 2 }",
            "question.hint = 2 is refused: it must be one line of text, from 1 to 400 characters long",
        ),
    ] {
        let said = without_line(&fault(&format!("[[stop]]\n{stop}")));
        let number = 1 + stop.matches("[[stop]]").count();
        let start = format!("j.toml: stop {number}: {sentence}");
        assert!(said.starts_with(&start), "{said}\n{start}");
    }
    // The keyframes take six lines, and the header of the stop one more.
    for (stop, line, sentence) in [
        ("at = 5\nhold = 3", 9, "there is no hold; "),
        (
            "at = 5\n\neffects.dopler = false",
            10,
            "there is no effects.dopler; did you mean effects.doppler?; ",
        ),
        (
            "camera.r = 5\nat = 5",
            8,
            "there is no camera.r; no stop switches it; keyframes lead the camera",
        ),
        (
            "at = 5\ndisk.time = 0",
            9,
            "there is no disk.time; no stop switches it",
        ),
        (
            "at = 5\n[stop.question]\ntext = \"a\"\nanswer = 1\ntolerance = 1\nhelp = \"b\"",
            13,
            "there is no question.help; ",
        ),
    ] {
        let said = fault(&format!("[[stop]]\n{stop}"));
        let start = format!("j.toml: line {line}: stop 1: {sentence}");
        assert!(said.starts_with(&start), "{said}\n{start}");
        assert!(said.ends_with(known), "{said}");
    }
    // A stop without any key has the line of its own header.
    let empty = fault("[[stop]]\nat = 5\n\n[[stop]]\n\n[[stop]]\nat = 6");
    assert!(
        empty.starts_with("j.toml: line 10: stop 2: at is missing"),
        "{empty}"
    );
    let comma = fault(
        "[[stop]]\nat = 5\nquestion = { text = \"Is v = 1,5?\", answer = 0,8165, tolerance = 0.1 }",
    );
    assert!(
        comma.starts_with("j.toml: line 9: `0,8165` has a comma")
            && comma.ends_with("did you mean 0.8165?"),
        "{comma}"
    );
    let many = "[[stop]]\nat = 5\n".repeat(201);
    assert_eq!(
        fault(&many),
        "j.toml: a journey has at most 200 tables [[stop]], and this one has 201"
    );
    let long = format!("[[stop]]\nat = 5\ncaption = \"{}\"", "é".repeat(701));
    assert!(fault(&long).contains("it must be a text of at most 10 lines and 700 characters"));
    let lines = format!("[[stop]]\nat = 5\ncaption = '''{}'''", "a\n".repeat(11));
    assert!(fault(&lines).contains("it must be a text of at most 10 lines"));
}

/// What a stop switches holds until another one switches it, whether the journey is flown forward or
/// shown at once, as a rendered sequence does.
#[test]
fn what_a_stop_switches_holds_until_a_later_stop_changes_it() {
    let journey = journey_with(
        "[[stop]]\nat = 4\neffects.doppler = false\nguides = true\n[[stop]]\nat = 6\nview = \"classes\"\nside_by_side = true\n\
         disk.enabled = false\n[[stop]]\nat = 8\neffects.doppler = true\nguides = false\nside_by_side = false\n",
    );
    let plain = find("above").unwrap().plain_scene();
    let at = |time: f64| {
        let mut scene = plain.clone();
        journey.apply(time, &mut scene);
        (scene.effects.doppler, scene.view, scene.disk.enabled)
    };
    assert_eq!(at(1.99), (true, View::Colour, true));
    assert_eq!(at(2.0), (false, View::Colour, true));
    assert_eq!(at(5.0), (false, View::Classes, false));
    assert_eq!(at(6.0), (true, View::Classes, false));
    assert_eq!(at(1e9), (true, View::Classes, false));
    let [none, one, two, three] = [0, 1, 2, 3].map(|stops| journey.switches_of(stops));
    assert_eq!((none.guides, none.beside.as_ref()), (None, None));
    assert_eq!(one.guides, Some(true));
    // Beside the second stop is shown what the first one led to.
    assert_eq!(two.beside.as_ref(), Some(&one.fields));
    assert_eq!((three.guides, three.beside.as_ref()), (Some(false), None));
    assert_eq!(
        (one.side_by_side, three.side_by_side),
        (None, Some(SideBySide::Off))
    );
    // Back to a stop from a later one: every field that any stop switches is as that stop has it.
    let mut scene = plain.clone();
    journey.apply(10.0, &mut scene);
    journey.switch(&one.fields, plain, &mut scene);
    assert_eq!(
        (scene.effects.doppler, scene.view, scene.disk.enabled),
        (false, View::Colour, true)
    );
    journey.switch(&none.fields, plain, &mut scene);
    let differences: Vec<_> = scene
        .differences(plain)
        .into_iter()
        .map(|(key, _)| key)
        .collect();
    assert!(
        differences.iter().all(|key| key.starts_with("camera.")),
        "{differences:?}"
    );
}

#[test]
fn a_stop_that_cannot_be_drawn_is_named() {
    let journey = journey_with("[[stop]]\nat = 4.5\ndisk.inner = 9\ndisk.outer = 8\n");
    let scene = Scene::default();
    let Unflyable { place, .. } = journey.check(&scene, 0.0, Drawable::new).unwrap_err();
    // The keyframe at the end is looked at first, and has the same values.
    assert_eq!(place, "keyframe 2 (time = 12)");
    let twice =
        "[[stop]]\nat = 4.5\ndisk.inner = 9\ndisk.outer = 8\n[[stop]]\nat = 5\ndisk.outer = 11\n";
    let Unflyable { place, .. } = journey_with(twice)
        .check(&scene, 0.0, Drawable::new)
        .unwrap_err();
    assert_eq!(place, "stop 1 (at = 4.5)");
}

fn comes_back(journey: &Journey) {
    let text = journey.to_toml();
    let again = load("again.toml", &text);
    assert_eq!(again.as_ref(), Ok(journey), "{text}");
    assert_eq!(again.unwrap().to_toml(), text);
}

#[test]
fn every_journey_that_is_written_is_read_back_as_the_same() {
    comes_back(&load("default.toml", journey::DEFAULT).unwrap());
    for (name, text) in LESSONS {
        comes_back(&load(name, text).unwrap());
    }
    // Texts with every kind of character, and times that no fraction of two is.
    comes_back(
        &load(
            "j.toml",
            "title = \"A \\\"quoted\\\" title \\\\\"\nending = \"Ünde, 光\"\nteaches = \"What's this?\"\n\
             [[keyframe]]\ntime = 0.1\nr = 20\nvelocity = [0.1, 0.2, -0.3]\nrain = { r = 3, yaw_deg = 1e-7 }\n\
             [[keyframe]]\ntime = 1e3\nobserver = \"rain\"\ndisk_time = -3\n\
             [[caption]]\ntime = 0.3\ntext = \"it's \\\"so\\\"\"\n\
             [[stop]]\nat = 0.7\ncaption = \"\"\"\nTwo 'lines' of \\\"text\\\",\n\\\\ and ''' and \\\"\\\"\\\" too\"\"\"\n\
             inspector = { at = [0.1, 0.7] }\nquestion = { text = \"\\\"?\\\"\", answer = 1e22, tolerance = 0.1 }\n",
        )
        .unwrap(),
    );
}

/// Times after a late beginning: their differences are rounded, and the file's own come back.
#[test]
fn random_times_of_a_journey_are_written_as_they_were_read() {
    let mut random = Random::new();
    for _ in 0..200 {
        let start = random.between(0.1, 50.0);
        let [a, b] = [0.3, 0.6].map(|share| start + share * 10.0 / 3.0);
        comes_back(
            &load(
                "j.toml",
                &format!(
                    "[[keyframe]]\ntime = {start:?}\n[[keyframe]]\ntime = {:?}\n[[caption]]\ntime = {a:?}\ntext = \"a\"\n\
                     [[stop]]\nat = {b:?}\n",
                    start + 10.0
                ),
            )
            .unwrap(),
        );
    }
}

fn shown(scene: Scene) -> Shown {
    Shown {
        scene,
        caption: String::new(),
        guides: false,
        side_by_side: SideBySide::Off,
        inspector: InspectorView::Closed,
    }
}

/// The scenes of stops that were chosen come back at the stops of the lesson, in every field that a
/// journey leads or switches.
#[test]
fn a_lesson_that_is_made_of_scenes_shows_each_of_them_at_its_stop() {
    let mut scenes: Vec<Scene> = PRESETS[..9]
        .iter()
        .map(|preset| preset.plain_scene().clone())
        .collect();
    // Inside the horizon of a hole that spins, and out again.
    let mut inside = find("falling").unwrap().plain_scene().clone();
    (inside.hole.spin, inside.camera.r, inside.camera.phi_deg) = (0.9, 0.5, 170.0);
    let mut outside = inside.clone();
    (outside.camera.r, outside.observer.kind) = (12.0, ObserverKind::Static);
    outside.camera.phi_deg = -175.0;
    scenes.extend([inside.clone(), outside, inside]);
    let mut draft = Draft::default();
    for scene in &scenes {
        draft.add(shown(scene.clone())).unwrap();
    }
    let journey = draft.journey().unwrap();
    comes_back(&journey);
    assert_eq!(journey.stops.len(), scenes.len());
    let plain = journey.preset.unwrap().plain_scene();
    assert_eq!(journey.check(plain, 0.0, Drawable::new), Ok(()));
    for (stop, scene) in journey.stops.iter().zip(&scenes) {
        let mut there = plain.clone();
        journey.apply(stop.time, &mut there);
        for (key, value) in scene.differences(&there) {
            let ignored = [
                "name",
                "title",
                "disk.time",
                "picture.exposure_ev",
                "picture.bypass",
            ];
            let now = lightfall_core::scene::field(key).unwrap().get(&there);
            let close = value.number().zip(now.number()).is_some_and(|(a, b)| {
                // Radii go through their logarithm, and angles through whole turns.
                (a - b).abs() < 1e-9 || (a - b).abs() == 360.0
            });
            assert!(
                close || ignored.contains(&key),
                "{}: {key}: {value} and not {now}",
                scene.name
            );
        }
    }
}

#[test]
fn a_stop_to_which_no_journey_leads_is_refused_and_the_lesson_is_as_before() {
    let mut draft = Draft::default();
    let mut fast = find("above").unwrap().plain_scene().clone();
    fast.observer.velocity = [0.8, 0.0, 0.0];
    draft.add(shown(fast.clone())).unwrap();
    let before = draft.clone();
    fast.observer.velocity = [0.0, 0.8, 0.0];
    let fault = draft.add(shown(fast)).unwrap_err().to_string();
    assert!(
        fault.starts_with("the lesson: keyframe 2: velocity"),
        "{fault}"
    );
    assert_eq!(draft, before);
}

/// Whatever the text is, it is read or refused in one sentence.
#[test]
fn a_randomly_garbled_lesson_is_a_journey_or_is_refused_in_one_sentence() {
    let mut random = Random::new();
    let mut below = |count: usize| random.integer(0, count as u32 - 1) as usize;
    let pieces = [
        "\"", "'''", "[", "]]", "{", "=", ".", ",", "\n", "\0", "-", "nan", "1e999", "true",
        "stop", "at", "\\u12",
    ];
    for round in 0..3000 {
        let mut text: Vec<char> = LESSONS[round % LESSONS.len()].1.chars().collect();
        for _ in 0..=below(4) {
            let at = below(text.len());
            let length = below(5).min(text.len() - at);
            text.splice(at..at + length, pieces[below(pieces.len())].chars());
        }
        let text: String = text.into_iter().collect();
        if let Err(error) = load("my.toml", &text) {
            let error = error.to_string();
            let is_sentence = error.starts_with("my.toml: ") && !error.contains('\n');
            assert!(is_sentence && error.len() < 1000, "{error:?} of {text:?}");
        }
    }
}
