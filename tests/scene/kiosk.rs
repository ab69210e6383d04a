//! A window for visitors: what they may do, the round of its journeys, its options, and its monitor.

use bevy::math::IVec2;
use bevy::window::Monitor;
use lightfall::app::{
    CONTROLS, END_PAUSE, JourneyNow, KioskRound, RoundStep, VisitorInput, is_for_visitors,
    numbered_monitor, stop_reading_time,
};
use lightfall::commands::cli::{self, Command, FlyArgs};
use lightfall::commands::{check_options, shows};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Every control that visitors may use. Whoever adds a control decides whether it belongs here.
const FOR_VISITORS: [&str; 38] = [
    "fly.forward",
    "fly.left",
    "fly.backward",
    "fly.right",
    "fly.up",
    "fly.down",
    "fly.look_left",
    "fly.look_right",
    "fly.look_up",
    "fly.look_down",
    "fly.roll_left",
    "fly.roll_right",
    "fly.faster",
    "fly.slower",
    "fly.face",
    "fly.face_back",
    "fly.orbit",
    "fly.narrower",
    "fly.wider",
    "fly.mouse",
    "fly.escape",
    "journey.fly",
    "journey.again",
    "journey.back",
    "journey.ahead",
    "motion.pause",
    "motion.let_go",
    "motion.slower",
    "motion.faster",
    "ship.fly",
    "ship.map",
    "scene.undo",
    "light.lensing",
    "light.doppler",
    "light.beaming",
    "light.gravitational_shift",
    "window.guides",
    "window.star_names",
];

const IDLE: Duration = Duration::from_secs(60);

fn seconds(seconds: u64) -> Duration {
    Duration::from_secs(seconds)
}

/// A round of so many journeys, of which the first one flies after a second.
fn begun(journeys: usize) -> KioskRound {
    let mut round = KioskRound::new(journeys, IDLE);
    round.step(seconds(0), VisitorInput::Nothing, JourneyNow::Rests);
    round.step(seconds(1), VisitorInput::Nothing, JourneyNow::Flies);
    round
}

fn fly(line: &str) -> FlyArgs {
    match cli::read(line.split(' ')).unwrap() {
        Command::Fly(args) => args,
        other => panic!("{line}: {other:?}"),
    }
}

#[test]
fn visitors_may_use_these_controls_and_no_others() {
    let allowed: BTreeSet<&str> = CONTROLS
        .iter()
        .filter(|control| is_for_visitors(control.action))
        .map(|control| control.id)
        .collect();
    assert_eq!(allowed, BTreeSet::from(FOR_VISITORS));
}

#[test]
fn the_journeys_are_flown_in_their_order_again_and_again() {
    let mut round = KioskRound::new(3, IDLE);
    let mut now = Duration::ZERO;
    let mut step = |round: &mut KioskRound, after: Duration, journey| {
        now += after;
        round.step(now, VisitorInput::Nothing, journey)
    };
    let begun = step(&mut round, Duration::ZERO, JourneyNow::Rests);
    assert_eq!(begun, RoundStep::Begin(0));
    for next in [1, 2, 0, 1] {
        let flies = step(&mut round, seconds(500), JourneyNow::Flies);
        assert_eq!(flies, RoundStep::Stay);
        let ended = step(&mut round, seconds(1), JourneyNow::Rests);
        assert_eq!(ended, RoundStep::Stay);
        let almost = END_PAUSE - seconds(1);
        assert_eq!(step(&mut round, almost, JourneyNow::Rests), RoundStep::Stay);
        let later = step(&mut round, seconds(1), JourneyNow::Rests);
        assert_eq!(later, RoundStep::Begin(next));
    }
}

#[test]
fn a_visitor_has_the_window_until_a_minute_has_passed_without_any_input() {
    let nothing = VisitorInput::Nothing;
    let mut round = begun(2);
    // The mouse alone may be a table that shakes.
    round.step(seconds(2), VisitorInput::Moves, JourneyNow::Flies);
    assert!(!round.has_visitor());
    let acts = round.step(seconds(10), VisitorInput::Acts, JourneyNow::Flies);
    assert_eq!((acts, round.has_visitor()), (RoundStep::Stay, true));
    // Flying by hand leaves the journey, and the mouse that moves keeps the window.
    for now in [20, 75, 134] {
        let step = round.step(seconds(now), VisitorInput::Moves, JourneyNow::Rests);
        assert_eq!(step, RoundStep::Stay, "{now}");
    }
    let step = round.step(seconds(193), nothing, JourneyNow::Rests);
    assert_eq!(step, RoundStep::Stay);
    let step = round.step(seconds(194), nothing, JourneyNow::Rests);
    assert_eq!((step, round.has_visitor()), (RoundStep::Begin(0), false));
}

#[test]
fn the_start_returns_from_a_paused_journey_and_from_a_stop_as_well() {
    for left in [JourneyNow::Flies, JourneyNow::Waits(seconds(7))] {
        let mut round = begun(1);
        round.step(seconds(2), VisitorInput::Acts, left);
        let step = round.step(seconds(61), VisitorInput::Nothing, left);
        assert_eq!(step, RoundStep::Stay, "{left:?}");
        let step = round.step(seconds(62), VisitorInput::Nothing, left);
        assert_eq!(step, RoundStep::Begin(0), "{left:?}");
    }
}

#[test]
fn a_journey_that_a_visitor_begins_is_flown_to_its_end() {
    let nothing = VisitorInput::Nothing;
    let mut round = begun(2);
    round.step(seconds(5), VisitorInput::Acts, JourneyNow::Rests);
    // The key of the journey, which flies from the next frame on.
    round.step(seconds(9), VisitorInput::Acts, JourneyNow::Rests);
    for now in [10, 69, 200] {
        let step = round.step(seconds(now), nothing, JourneyNow::Flies);
        assert_eq!(step, RoundStep::Stay, "{now}");
    }
    round.step(seconds(201), nothing, JourneyNow::Rests);
    let step = round.step(seconds(201) + END_PAUSE, nothing, JourneyNow::Rests);
    assert_eq!(step, RoundStep::Begin(1));
}

#[test]
fn a_stop_waits_as_long_as_its_caption_is_read_and_then_goes_on() {
    // 150 characters at 15 a second, and five seconds to look.
    let reading = stop_reading_time(&"x".repeat(150));
    assert_eq!(reading, seconds(15));
    let mut round = begun(1);
    let mut at = |now, journey| round.step(seconds(now), VisitorInput::Nothing, journey);
    assert_eq!(at(3, JourneyNow::Waits(reading)), RoundStep::Stay);
    assert_eq!(at(17, JourneyNow::Waits(reading)), RoundStep::Stay);
    assert_eq!(at(18, JourneyNow::Waits(reading)), RoundStep::GoOn);
    // The next stop has a time of its own.
    assert_eq!(at(19, JourneyNow::Flies), RoundStep::Stay);
    assert_eq!(at(30, JourneyNow::Waits(reading)), RoundStep::Stay);
    assert_eq!(at(44, JourneyNow::Waits(reading)), RoundStep::Stay);
    assert_eq!(at(45, JourneyNow::Waits(reading)), RoundStep::GoOn);
}

#[test]
fn the_command_line_of_a_window_for_visitors_is_read() {
    let args = fly("lightfall --kiosk shadow mine.toml --idle 90 --volume 40 --monitor 2");
    let names = ["shadow", "mine.toml"].map(PathBuf::from).to_vec();
    assert_eq!(args.kiosk, Some(names));
    assert_eq!(
        (args.idle, args.volume, args.monitor, args.fullscreen),
        (Some(90), Some(40), Some(2), false)
    );
    assert!(check_options(&args).is_ok());
    let args = fly("lightfall --kiosk --set camera.r=12");
    assert_eq!(args.kiosk, Some(Vec::new()));
    assert_eq!(fly("lightfall --fullscreen").kiosk, None);
    for line in [
        "lightfall --idle 4 --kiosk",
        "lightfall --idle 3601 --kiosk",
        "lightfall --volume 101 --kiosk",
        "lightfall --monitor 0",
        "lightfall --monitor left",
    ] {
        assert_eq!(
            cli::read(line.split(' ')).unwrap_err().exit_code(),
            2,
            "{line}"
        );
    }
}

#[test]
fn options_that_do_not_go_together_are_refused_in_a_sentence_each() {
    for (line, sentence) in [
        ("lightfall --idle 90", "--idle is for --kiosk"),
        ("lightfall --volume 5", "--volume is for --kiosk"),
        (
            "lightfall --journey shadow --kiosk",
            "--journey is for a window without --kiosk",
        ),
        (
            "lightfall --shaders mine --kiosk",
            "--shaders is for work on the shaders",
        ),
    ] {
        let stop = check_options(&fly(line)).unwrap_err();
        assert_eq!(stop.status, 2, "{line}");
        assert!(stop.to_string().starts_with(sentence), "{line}: {stop}");
    }
    for option in ["--fullscreen", "--monitor 2", "--idle 60", "--volume 5"] {
        let line = format!("lightfall {option} doctor");
        let error = cli::read(line.split(' ')).unwrap_err();
        let name = option.split(' ').next().unwrap();
        let sentence = format!("{name} is for flying, without a command");
        assert!(error.to_string().contains(&sentence), "{line}: {error}");
    }
    for (preset, what) in [("graze", "a mission"), ("shadow", "a journey")] {
        let args = fly(&format!("lightfall --preset {preset} --kiosk"));
        let stop = shows(&args.scene, &[]).unwrap_err();
        assert!(stop.to_string().contains(what), "{preset}: {stop}");
    }
}

#[test]
fn every_journey_is_shown_in_its_own_preset_as_the_options_change_it_and_asks_nothing() {
    let args = fly("lightfall --kiosk --set camera.fov_deg=77");
    let shown = shows(&args.scene, &[]).unwrap();
    let scenes: Vec<&str> = shown.iter().map(|show| show.scene.name.as_str()).collect();
    assert_eq!(scenes, ["above", "close-thick"]);
    for show in &shown {
        assert_eq!(show.scene.camera.fov_deg, 77.0);
        assert!(show.journey.preset.is_none());
    }
    // A preset that is named is that of every journey.
    let args = fly("lightfall --preset telescope --kiosk");
    let lesson = shows(&args.scene, &[PathBuf::from("shadow")]).unwrap();
    assert_eq!(lesson.len(), 1);
    assert_eq!(lesson[0].scene.name, "telescope");
    let stops = &lesson[0].journey.stops;
    assert_eq!(stops.len(), 7);
    assert!(stops.iter().all(|stop| stop.question.is_none()));
    let missing = shows(&args.scene, &[Path::new("no-such-journey.toml").into()]).unwrap_err();
    assert_eq!(missing.status, 2);
    assert!(missing.to_string().contains("no-such-journey.toml"));
}

fn monitor(name: &str, [x, y]: [i32; 2]) -> Monitor {
    Monitor {
        name: Some(name.into()),
        physical_height: 1080,
        physical_width: 1920,
        physical_position: IVec2::new(x, y),
        refresh_rate_millihertz: None,
        scale_factor: 1.0,
        video_modes: Vec::new(),
    }
}

#[test]
fn monitors_are_counted_from_the_left_and_one_that_is_missing_is_answered_by_the_list() {
    let monitors = [
        monitor("middle", [0, 0]),
        monitor("right", [1920, 40]),
        monitor("left", [-1920, 0]),
        monitor("below", [0, 1080]),
    ];
    let names: Vec<_> = (1..=4)
        .map(|number| numbered_monitor(number, &monitors).unwrap())
        .map(|place| monitors[place].name.clone().unwrap())
        .collect();
    assert_eq!(names, ["left", "middle", "below", "right"]);
    let two = &monitors[1..3];
    for number in [0, 3] {
        assert_eq!(
            numbered_monitor(number, two).unwrap_err(),
            format!(
                "--monitor {number}: there is no such monitor; counted from the left, there is 1: left, 1920 x 1080; \
                 2: right, 1920 x 1080"
            )
        );
    }
}
