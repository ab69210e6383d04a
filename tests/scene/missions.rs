//! Missions in the window: flown frame by frame as a player does, their lamps, and what is kept.

use glam::DVec3;
use lightfall::app::{
    Bindings, FlightStep, MissionResult, MissionResults, ShipFlight, ShipFrame, Stick, control_named, lamps,
    solution_time,
};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::optics::ship::{Apsides, Heading, Outcome, path_ahead};
use lightfall_core::scene::Scene;
use lightfall_core::scene::mission::{self, MISSIONS, MissionKey, Quantity};

/// A frame of a slow machine.
const FRAME: f64 = 0.05;

/// A player at the controls, who looks at the instruments after every frame.
struct Player {
    ship: ShipFlight,
    scene: Scene,
}

impl Player {
    fn begin(name: &str) -> Self {
        let mission = mission::built_in(name).unwrap();
        let scene = mission.scene().clone();
        let mut ship = ShipFlight::default();
        ship.start(&mission, &scene).unwrap();
        Self { ship, scene }
    }

    #[track_caller]
    fn pass(&mut self, thrust: f64) {
        let frame = ShipFrame {
            seconds: FRAME,
            turn_seconds: FRAME,
            stick: Stick {
                thrust: thrust * DVec3::X,
                ..Stick::NEUTRAL
            },
            reduced_motion: false,
        };
        match self.ship.advance(&frame, &self.scene).0 {
            FlightStep::Moved(next) | FlightStep::Ended(next) => self.scene = next.into_scene(),
            other => panic!("{other:?}"),
        }
    }

    /// Pushes, or coasts without thrust, until something is so.
    #[track_caller]
    fn until(&mut self, thrust: f64, is_so: impl Fn(&Self) -> bool) {
        for _ in 0..20_000 {
            if is_so(self) {
                return;
            }
            self.pass(thrust);
        }
        panic!("never so: {:?}", self.outcome());
    }

    fn apsides(&self) -> [f64; 2] {
        let apsides = Apsides::of(&self.ship.voyage().unwrap().flight.ship);
        [
            apsides.periapsis.unwrap_or(0.0),
            apsides.apoapsis.unwrap_or(f64::INFINITY),
        ]
    }

    fn outcome(&self) -> Outcome {
        self.ship.attempt().unwrap().outcome()
    }
}

/// The nose of these missions points along the motion, where there is only sky.
#[test]
fn missions_that_begin_with_a_nose_away_from_the_hole_begin_with_the_hole_in_view() {
    for name in ["two-burns", "sample", "ten-years"] {
        let mut player = Player::begin(name);
        player.pass(0.0);
        let hole = ApparentHole::new(&player.scene).unwrap();
        let ahead = player.scene.camera.tetrad_from_camera().z_axis;
        // Around a hole that spins, the ray that comes from the hole is not in the middle of what is
        // black, but it is in it.
        let off = hole.direction.angle_between(ahead);
        assert!(off < hole.radius, "{name}: {off}, {}", hole.radius);
    }
}

/// As the captions of the first mission say, with a key held down and let go, and no more skill than
/// frames of a twentieth of a second allow.
#[test]
fn the_first_mission_is_flown_by_one_key_and_lights_its_lamps() {
    let mut player = Player::begin("two-burns");
    assert_eq!(player.ship.heading(), Some(Heading::Retrograde));
    player.until(1.0, |player| player.apsides()[0] <= 6.02);
    player.pass(0.0);
    player.ship.change_pace(4);
    // Faster time ends at the lowest point by itself.
    player.until(0.0, |player| player.ship.pace() == 1.0);
    assert!((player.scene.camera.r - player.apsides()[0]).abs() < 1e-6);
    player.until(1.0, |player| player.apsides()[1] <= 6.05);
    player.until(0.0, |player| player.outcome() == Outcome::Success);
    let attempt = player.ship.attempt().unwrap();
    let time = solution_time(&attempt.mission);
    assert_eq!(lamps(attempt, time), [true; 3], "{time:?}");
    // The time of a flight twice as slow as the solution is too long.
    assert_eq!(
        lamps(attempt, time.map(|time| 0.5 * time)),
        [true, true, false]
    );
}

#[test]
fn a_mission_that_fails_lights_no_lamp_and_begins_again_with_a_full_tank_and_the_nose_as_at_first()
{
    let mut player = Player::begin("graze");
    player.until(1.0, |player| matches!(player.outcome(), Outcome::Failed(_)));
    let attempt = player.ship.attempt().unwrap();
    assert_eq!(lamps(attempt, None), [false; 3]);
    player.ship.begin_again();
    player.pass(0.0);
    let voyage = player.ship.voyage().unwrap();
    assert_eq!(player.outcome(), Outcome::UnderWay(0));
    assert_eq!(voyage.flight.rocket.used(), 0.0);
    assert_eq!(player.ship.heading(), Some(Heading::Hole));
    assert!((player.scene.camera.r - 20.0).abs() < 1e-3);
}

#[test]
fn a_player_goes_back_to_the_last_goal() {
    let mut player = Player::begin("sample");
    // Back to the start first.
    player.until(1.0, |player| {
        player.ship.voyage().unwrap().flight.rocket.used() > 0.2
    });
    player.ship.go_back();
    player.pass(0.0);
    let used = |player: &Player| player.ship.voyage().unwrap().flight.rocket.used();
    assert_eq!(used(&player), 0.0);
    assert!((player.scene.camera.r - 5.0).abs() < 1e-6);
}

#[test]
fn the_nose_of_a_mission_that_counts_turns_is_held_by_the_gyroscopes() {
    let mut player = Player::begin("gyroscope");
    assert_eq!(player.ship.heading(), None);
    player.ship.change_pace(4);
    player.until(0.0, |player| player.outcome() == Outcome::Success);
    assert_eq!(player.ship.voyage().unwrap().flight.turned(), 0.0);
}

#[test]
fn the_path_ahead_begins_at_the_ship_and_passes_its_turning_points() {
    let mut player = Player::begin("two-burns");
    player.until(1.0, |player| player.apsides()[0] <= 8.0);
    let ship = &player.ship.voyage().unwrap().flight.ship;
    let path = path_ahead(ship, 256);
    let path: Vec<_> = path.into_iter().map(|point| point.place).collect();
    assert!((path[0] - ship.place().r * ship.place().n).length() < 1e-12);
    let lowest = path
        .iter()
        .map(|place| place.length())
        .fold(f64::INFINITY, f64::min);
    let highest = path.iter().map(|place| place.length()).fold(0.0, f64::max);
    let [low, high] = player.apsides();
    // Points lie a twentieth of a radian apart: nearest ones differ by e times the square of a half of it.
    assert!((lowest - low).abs() < 1e-3 && (highest - high).abs() < 1e-3);
    // Two turns and not a jump between two points.
    for pair in path.windows(2) {
        assert!((pair[1] - pair[0]).length() < 0.1 * pair[0].length());
    }
}

/// A name in braces stands for a key.
#[test]
fn captions_name_controls_that_exist() {
    for (name, text) in MISSIONS {
        let mission = mission::load(name, text).unwrap();
        for text in mission.texts() {
            for part in text.split('{').skip(1) {
                let (id, _) = part
                    .split_once('}')
                    .unwrap_or_else(|| panic!("{name}: {text}"));
                assert!(control_named(id).is_some(), "{name}: {id}");
            }
        }
    }
}

/// The card at the start lists controls that exist, and names in braces stand for keys.
#[test]
fn keys_that_a_mission_can_need_are_controls_and_texts_have_their_names() {
    for id in MissionKey::WORDS {
        assert!(control_named(id).is_some(), "{id}");
    }
    for (name, text) in MISSIONS {
        let keys = mission::load(name, text).unwrap().keys;
        assert!(keys.is_some_and(|keys| !keys.is_empty()), "{name}");
    }
    let bindings = Bindings::default();
    for (text, words) in [
        ("Hold {fly.forward}: it brakes.", "Hold W: it brakes."),
        (
            "let go. {motion.faster} lets time run faster",
            "let go. \".\" lets time run faster",
        ),
        ("{fly.left}{fly.right}", "AD"),
        ("{fly.nowhere} and { and {", "{fly.nowhere} and { and {"),
    ] {
        assert_eq!(bindings.with_keys(text), words);
    }
}

fn result(mission: &str, reached: bool, lamps: usize, rapidity_used: f64) -> MissionResult {
    MissionResult {
        mission: mission.into(),
        reached,
        lamps,
        attempt: 1,
        own_time: 117.25,
        far_time: None,
        rapidity_used,
        par: Some((Quantity::RapidityUsed, rapidity_used)),
        peak_g: 9.5,
        peak_tide: 1e-13,
        lowest: 5.99,
        error: 3.5e-14,
        answer: None,
        is_right: None,
    }
}

#[test]
fn results_are_kept_in_a_file_of_rows_that_is_read_again_and_the_best_one_has_the_most_lamps() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("new folder").join("results.csv");
    let mut results = MissionResults::load(Some(file.clone()));
    let rows = [
        result("graze", false, 0, 0.1),
        result("graze", true, 2, 1.2),
        result("graze", true, 3, 1.15),
        result("graze", true, 3, 1.1),
        result("sample", true, 3, 0.7),
    ];
    for row in &rows {
        results.add(row.clone()).unwrap();
        assert_eq!(MissionResult::read(&row.row()).as_ref(), Some(row));
    }
    let text = std::fs::read_to_string(&file).unwrap();
    assert_eq!(text.lines().count(), 6);
    assert!(
        text.starts_with("mission,outcome,lamps,attempt,own_time,"),
        "{text}"
    );
    let read = MissionResults::load(Some(file));
    assert_eq!(read.best("graze"), Some(&rows[3]));
    assert_eq!(read.best("penrose"), None);
}

#[test]
fn a_corrected_result_replaces_its_own_row_whatever_the_file_has_meanwhile() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("results.csv");
    let mut results = MissionResults::load(Some(file.clone()));
    let first = result("graze", true, 2, 1.2);
    results.add(first.clone()).unwrap();
    // Another window writes a row.
    let other = result("sample", true, 3, 0.7);
    let mut other_window = MissionResults::load(Some(file.clone()));
    other_window.add(other.clone()).unwrap();
    let answered = MissionResult {
        answer: Some(42.0),
        is_right: Some(false),
        ..first
    };
    results.correct_last(answered.clone()).unwrap();
    let lines = || -> Vec<String> {
        let text = std::fs::read_to_string(&file).unwrap();
        text.lines().skip(1).map(str::to_owned).collect()
    };
    assert_eq!(lines(), [answered.row(), other.row()]);
    // A file of an earlier version has fewer columns: its header becomes today's, and its rows stay.
    let old = "mission,outcome,lamps\nsample,reached,3,1,1,1,1,,,1,1,2,1e-12,\n";
    std::fs::write(&file, old).unwrap();
    results.correct_last(answered.clone()).unwrap();
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.lines().next().unwrap().ends_with(",answer,is_right"), "{text}");
    assert_eq!(lines()[0], "sample,reached,3,1,1,1,1,,,1,1,2,1e-12,");
    assert_eq!(MissionResults::load(Some(file.clone())).best("sample").unwrap().is_right, None);
    // A file that is gone is begun again, with its header.
    std::fs::remove_file(&file).unwrap();
    results.correct_last(answered.clone()).unwrap();
    assert_eq!(lines(), [answered.row()]);
}
