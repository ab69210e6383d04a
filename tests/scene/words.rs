//! The words on the window: what keys say, read-outs, and numbers for people.

use lightfall::app::{
    Action, CONTROLS, ReadOut, change_words, control_named, edited, physics_off, read_outs,
    reading_time, statement,
};
use lightfall_core::numbers::{
    four_digits, percent, spin_digits, steady_digits, three_digits, with_short_numbers,
};
use lightfall_core::optics::readout::si::MASSES;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::{Effects, ObserverKind, Scene, presets};

fn preset(name: &str) -> Scene {
    presets::find(name).unwrap().scene(&[]).unwrap()
}

/// What a control says in a scene, and the scene that it leads to.
fn said(scene: &Scene, id: &str) -> (String, Scene) {
    let control = control_named(id).unwrap();
    let after = edited(control, scene, scene).unwrap();
    (statement(control, &after).unwrap(), after)
}

#[test]
fn a_switch_says_its_state_each_time_it_is_used() {
    let scene = preset("above");
    for (id, first, second) in [
        ("scene.disk", "Disk: off", "Disk: on"),
        (
            "scene.isco",
            "Disk from the innermost stable orbit: on",
            "Disk from the innermost stable orbit: off",
        ),
        ("scene.sky", "Sky: off", "Sky: stars"),
        ("scene.sky_mode", "Sky: the article's stars", "Sky: grid"),
        ("scene.spin", "Spin: 0.9", "Spin: 0"),
        ("light.lensing", "Lensing: off", "Lensing: on"),
        ("light.doppler", "Doppler shift: off", "Doppler shift: on"),
        ("light.beaming", "Beaming: off", "Beaming: on"),
        (
            "light.gravitational_shift",
            "Gravitational shift: off",
            "Gravitational shift: on",
        ),
        ("view.redshift", "View: redshift g", "View: light"),
        (
            "view.delay",
            "View: delay of the disk's light",
            "View: light",
        ),
        ("view.error", "View: backward error", "View: light"),
        ("picture.bloom", "Bloom: off", "Bloom: on"),
        ("picture.dither", "Dither: off", "Dither: on"),
        ("picture.levels", "Tones: all", "Tones: 48 a channel"),
        (
            "picture.antialias",
            "Smooth edges of the probe: on",
            "Smooth edges of the probe: off",
        ),
    ] {
        let (once, after) = said(&scene, id);
        let control = control_named(id).unwrap();
        let twice = statement(control, &edited(control, &after, &scene).unwrap());
        assert_eq!((once.as_str(), twice.as_deref()), (first, Some(second)));
    }
}

#[test]
fn the_exposure_says_who_chooses_it() {
    let mut scene = preset("edge-on");
    (scene.picture.exposure_ev, scene.picture.automatic_exposure) = (-1.2, true);
    for (id, words) in [
        ("picture.brighter", "Exposure: -0.95 EV, by hand"),
        ("picture.darker", "Exposure: -1.45 EV, by hand"),
        ("picture.automatic_exposure", "Exposure: -1.20 EV, by hand"),
    ] {
        assert_eq!(said(&scene, id).0, words);
    }
    scene.picture.automatic_exposure = false;
    assert_eq!(
        said(&scene, "picture.automatic_exposure").0,
        "Exposure: automatic (-1.2 EV)"
    );
    // The light meter's choice after another change is not what that change was.
    let mut spinning = scene.clone();
    scene.picture.automatic_exposure = true;
    spinning.picture.automatic_exposure = true;
    (spinning.hole.spin, spinning.picture.exposure_ev) = (0.5, 3.0);
    assert_eq!(change_words(&scene, &spinning), "spin");
}

#[test]
fn every_control_that_edits_the_scene_says_so_in_a_few_words() {
    for preset in presets::PRESETS {
        let scene = preset.scene(&[]).unwrap();
        for control in CONTROLS
            .iter()
            .filter(|control| matches!(control.action, Action::Edit(_)))
        {
            let (words, _) = said(&scene, control.id);
            assert!(
                words.contains(": ") && words.len() < 64 && !words.replace("r_s", "").contains('_'),
                "{}: {words}",
                control.id
            );
        }
    }
}

#[test]
fn the_probe_says_where_it_is() {
    // In preset 2 the camera is at r 20 too, next to where the probe hovers.
    let (words, _) = said(&preset("edge-on"), "scene.probe");
    assert!(
        words.starts_with("Probe: on, ") && words.ends_with("at r 20 r_s"),
        "{words}"
    );
    // In the probe's own preset it is in view, and the key takes it away and brings it back.
    let (words, without) = said(&preset("probe"), "scene.probe");
    assert_eq!(words, "Probe: off");
    assert_eq!(said(&without, "scene.probe").0, "Probe: on, in view");
    // Turned round, it is behind.
    let mut away = without;
    away.camera.yaw_deg += 180.0;
    let (words, _) = said(&away, "scene.probe");
    assert!(words.starts_with("Probe: on, behind you"), "{words}");
}

#[test]
fn an_undone_change_is_named() {
    let scene = preset("edge-on");
    for (change, words) in [
        ((|scene| scene.hole.spin = 0.5) as fn(&mut Scene), "spin"),
        (|scene| scene.disk.enabled = false, "disk"),
        (|scene| scene.camera.r = 30.0, "the flight"),
        (
            |scene| {
                scene.camera.r = 30.0;
                scene.observer.kind = ObserverKind::Rain;
            },
            "the flight",
        ),
        (|scene| scene.observer.kind = ObserverKind::Rain, "observer"),
        (|scene| scene.name = "other".into(), "preset other"),
    ] {
        let mut changed = scene.clone();
        change(&mut changed);
        assert_eq!(change_words(&changed, &scene), words);
    }
}

#[test]
fn what_is_switched_off_in_the_physics_is_named() {
    let mut scene = Scene::default();
    assert_eq!(physics_off(&scene), None);
    (scene.effects.doppler, scene.effects.beaming) = (false, false);
    assert_eq!(
        physics_off(&scene).as_deref(),
        Some("Physics off: Doppler shift, beaming")
    );
    // No switch is missing from the line.
    scene.effects = Effects {
        lensing: false,
        doppler: false,
        beaming: false,
        gravitational_shift: false,
        aberration: false,
    };
    assert_eq!(physics_off(&scene).unwrap().split(", ").count(), 5);
}

#[test]
fn simple_words_give_kilometres_and_minutes_and_no_angles_of_the_hole() {
    // r_s of Sgr A* is 12.7 million km, and r_s/c is 42.36 s.
    let units = Units::Everyday(MASSES[0]);
    let lines = read_outs(&preset("edge-on"), 1.0, units);
    let place: Vec<_> = lines[0].iter().map(|it| (it.label, &*it.value)).collect();
    assert_eq!(
        place,
        [("distance", "254 million km"), ("", "7.0° above the disk")]
    );
    assert_eq!(units.time(4.0, steady_digits), "2.82 minutes");
    assert_eq!(Units::Hole.time(4.0, steady_digits), "4.000 r_s/c");
}

#[test]
fn texts_of_missions_have_their_lengths_and_times_in_kilometres_and_minutes() {
    let units = Units::Everyday(MASSES[0]);
    let texts = [
        (
            "Below 3 r_s, for 4 r_s/c.",
            format!(
                "Below {}, for 2.82 minutes.",
                units.length(3.0, four_digits)
            ),
        ),
        (
            "Stand still between 2.9 and 3.1 r_s",
            format!(
                "Stand still between {} and {}",
                units.length(2.9, four_digits),
                units.length(3.1, four_digits)
            ),
        ),
        (
            "Down (1.6 r_s), ~2 r_s, then 2/3 r_s.",
            format!(
                "Down ({}), ~{}, then {}.",
                units.length(1.6, four_digits),
                units.length(2.0, four_digits),
                units.length(2.0 / 3.0, four_digits)
            ),
        ),
        (
            "At 2.9, 3.0 and 3.1 r_s, or at 4 to 5 r_s",
            format!(
                "At {}, {} and {}, or at {} to {}",
                units.length(2.9, four_digits),
                units.length(3.0, four_digits),
                units.length(3.1, four_digits),
                units.length(4.0, four_digits),
                units.length(5.0, four_digits)
            ),
        ),
        // What has no number, and what is no length, stays.
        (
            "pi/2 r_s/c, 2 and r_s, 0.3 c^2/r_s, 5 r_sx, E of 1.7",
            "pi/2 r_s/c, 2 and r_s, 0.3 c^2/r_s, 5 r_sx, E of 1.7".into(),
        ),
        ("r_s", "r_s".into()),
        ("", String::new()),
    ];
    for (text, expected) in texts {
        assert_eq!(units.in_text(text), expected);
        assert_eq!(Units::Hole.in_text(text), text);
    }
}

#[test]
fn read_outs_use_words_and_keep_their_width() {
    let text = |scene: &Scene| {
        read_outs(scene, 1.0, Units::Hole).map(|line| {
            line.iter()
                .map(|ReadOut { label, value, .. }| format!("{label} {value}").trim().to_owned())
                .collect::<Vec<_>>()
                .join("   ")
        })
    };
    assert_eq!(
        text(&preset("edge-on")),
        [
            "r 20.00 r_s   7.0° above the disk   theta 83.0°   azimuth 0.0°",
            "hovering at rest   clock 0.9747 of home's   spin 0.9   flying speed 1.00×   automatic exposure"
        ]
    );
    let mut below = preset("edge-on");
    below.camera.theta_deg = 100.0;
    assert!(text(&below)[0].contains("10.0° below the disk"));
    below.camera.theta_deg = 90.0;
    assert!(text(&below)[0].contains("in the disk's plane"));
    // From 0.1 to 9999 r_s the radius has at most five characters.
    for r in [0.1, 0.912, 1.12, 9.9996, 20.0, 99.996, 160.0, 9999.4] {
        assert!(steady_digits(r).len() <= 5, "{}", steady_digits(r));
    }
}

#[test]
fn numbers_for_people_have_at_most_four_digits() {
    for (number, short, steady) in [
        (0.0, "0", "0.000"),
        (20.0, "20", "20.00"),
        (1.12, "1.12", "1.120"),
        (0.325_645, "0.3256", "0.326"),
        (9.9996, "10", "10.00"),
        (160.0, "160", "160.0"),
        (12_345.6, "12350", "12350"),
        (4.472_135_9, "4.472", "4.472"),
        (-7.123_45, "-7.123", "-7.123"),
        (1.234_56e-5, "1.23e-5", "1.23e-5"),
        (9_999_999.0, "1.00e7", "1.00e7"),
    ] {
        assert_eq!(
            (four_digits(number).as_str(), steady_digits(number).as_str()),
            (short, steady)
        );
    }
    assert_eq!(
        [190.4, 0.084, 12_345.0].map(three_digits),
        ["190", "0.084", "12300"]
    );
    assert_eq!(
        [0.0, 1e-9, 0.0099, 0.01, 0.7249, 1.0].map(percent),
        [
            "0 %",
            "less than 1 %",
            "less than 1 %",
            "1 %",
            "72 %",
            "100 %"
        ]
    );
    assert_eq!(
        [0.0, 0.9, 0.998, 0.99999].map(spin_digits),
        ["0", "0.9", "0.998", "0.99999"]
    );
}

#[test]
fn numbers_in_a_sentence_are_rounded_to_the_side_that_is_allowed() {
    for (long, short) in [
        (
            "a number from 0.3256451 to 10000000 r_s",
            "a number from 0.3257 to 10000000 r_s",
        ),
        (
            "at most 0.3256451, above 1.23456",
            "at most 0.3256, above 1.235",
        ),
        ("camera.r = 0.1473994654915289 is", "camera.r = 0.1474 is"),
        (
            "schema = 1, 480 x 270, 1440x810",
            "schema = 1, 480 x 270, 1440x810",
        ),
        (
            "lightfall-edge-on-0001.png (0.123456)",
            "lightfall-edge-on-0001.png (0.1235)",
        ),
    ] {
        assert_eq!(with_short_numbers(long), short);
    }
}

#[test]
fn a_short_message_stays_for_two_seconds_and_a_long_one_as_long_as_it_takes_to_read() {
    assert_eq!(reading_time("Doppler shift: off").as_secs_f64(), 2.0);
    let long = "a".repeat(100);
    assert!((7.0..9.0).contains(&reading_time(&long).as_secs_f64()));
    assert_eq!(reading_time(&"a".repeat(1000)).as_secs_f64(), 15.0);
}
