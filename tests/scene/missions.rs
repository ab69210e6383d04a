//! Missions in the window: flown frame by frame as a player does, their lamps, and what is kept.

use glam::DVec3;
use lightfall::app::{
    Bindings, FlightStep, HoldKind, MissionResult, MissionResults, ShipFlight, ShipFrame, Stick,
    Wanted, control_named, first_choice, instruments, lamps, map_half_width, next_not_reached,
    outside_horizon, solution_time, unknown_controls, wanted,
};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Apsides, Heading, Outcome, path_ahead};
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::{self, LESSONS};
use lightfall_core::scene::mission::{self, MISSIONS, Mission, MissionKey, Quantity};

/// A frame of a slow machine.
const FRAME: f64 = 0.05;

/// A player at the controls, who looks at the instruments after every frame.
struct Player {
    ship: ShipFlight,
    scene: Scene,
}

impl Player {
    fn begin(name: &str) -> Self {
        Self::of(&mission::built_in(name).unwrap())
    }

    fn of(mission: &Mission) -> Self {
        let scene = mission.scene().clone();
        let mut ship = ShipFlight::default();
        ship.start(mission, &scene).unwrap();
        Self { ship, scene }
    }

    #[track_caller]
    fn pass(&mut self, thrust: f64) {
        self.pass_in(FRAME, thrust);
    }

    /// A frame in which so many seconds pass for the ship, none of them in a pause.
    #[track_caller]
    fn pass_in(&mut self, seconds: f64, thrust: f64) {
        let frame = ShipFrame {
            seconds,
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

    /// A quantity that is known where the ship is.
    fn value(&self, quantity: Quantity) -> f64 {
        self.ship.voyage().unwrap().quantity(quantity).unwrap()
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

/// A straight plunge passes the radius of the first goal, and leads into the hole.
#[test]
fn a_plunge_past_the_photon_sphere_reaches_no_goal_of_the_graze() {
    let mut player = Player::begin("graze");
    player.until(1.0, |player| matches!(player.outcome(), Outcome::Failed(_)));
    let attempt = player.ship.attempt().unwrap();
    assert!(attempt.scored().records().lowest < 1.5);
    assert!(attempt.reached().is_empty());
}

/// As its captions say, by keys alone, and no more skill than frames of a twentieth of a second allow.
#[test]
fn ten_years_in_one_are_flown_as_its_captions_say() {
    let mut player = Player::begin("ten-years");
    let rate = |player: &Player| player.value(Quantity::Rate);
    let years = |player: &Player| player.value(Quantity::TYears);
    player.until(0.25, |player| player.apsides()[0] <= 0.61);
    player.pass(0.0);
    // Faster time ends by itself at the goal's radius, and near the horizon.
    while player.scene.camera.r > 0.64 {
        player.ship.change_pace(4);
        player.until(0.0, |player| player.ship.pace() == 1.0);
    }
    player.until(0.0, |player| player.scene.camera.r <= 0.622);
    assert_eq!(player.ship.switch_hold(HoldKind::Orbit), Ok(true));
    player.until(0.0, |player| {
        let [low, high] = player.apsides();
        high - low < 1e-3
    });
    player.ship.engine_off();
    player.pass(0.0);
    player.ship.change_pace(10);
    assert_eq!(player.ship.pace(), 1024.0);
    player.until(0.0, |player| years(player) >= 8.0);
    assert!(rate(&player) > 10.25, "{}", rate(&player));
    player.ship.change_pace(-2);
    player.until(0.0, |player| years(player) >= 9.7);
    player.ship.change_pace(-2);
    player.until(0.0, |player| years(player) >= 10.0);
    assert_eq!(player.ship.face_back(), Some(Heading::Prograde));
    for _ in 0..60 {
        player.pass_in(0.0, 0.0);
    }
    player.until(1.0, |player| player.apsides()[1] > 5.0);
    player.pass(0.0);
    player.ship.change_pace(4);
    player.until(0.0, |player| player.ship.attempt().unwrap().is_over());
    assert_eq!(player.outcome(), Outcome::Success);
}

/// The graze with the goal of a radius alone, which a straight plunge passes on the way into the hole, and
/// with fuel for it.
#[test]
fn going_back_restores_the_pilot_and_a_second_time_without_thrust_leads_to_the_start() {
    let (_, text) = MISSIONS
        .into_iter()
        .find(|(name, _)| *name == "graze")
        .unwrap();
    let text = text
        .replace("\"periapsis >= 1.5\"", "\"r >= 1.5\"")
        .replace("rapidity = 1.6", "rapidity = 5.0");
    let mission = mission::load("graze", &text).unwrap();
    let plunge = || {
        let mut player = Player::of(&mission);
        player.until(1.0, |player| player.outcome() == Outcome::UnderWay(1));
        player.ship.engine_off();
        assert_eq!(player.ship.heading(), None);
        player.until(0.0, |player| matches!(player.outcome(), Outcome::Failed(_)));
        player
    };
    let used = |player: &Player| player.ship.voyage().unwrap().flight.rocket.used();
    let mut player = plunge();
    assert!(player.ship.go_back());
    player.pass(0.0);
    assert_eq!(player.outcome(), Outcome::UnderWay(1));
    // The nose points where it did at the goal.
    assert_eq!(player.ship.heading(), Some(Heading::Hole));
    assert!(used(&player) > 0.0);
    player.until(0.0, |player| matches!(player.outcome(), Outcome::Failed(_)));
    assert!(!player.ship.go_back());
    player.pass(0.0);
    assert_eq!(player.outcome(), Outcome::UnderWay(0));
    assert_eq!(used(&player), 0.0);
    assert!((player.scene.camera.r - 20.0).abs() < 1e-3);
    // With a push the path is another one.
    let mut player = plunge();
    assert!(player.ship.go_back());
    player.until(1.0, |player| matches!(player.outcome(), Outcome::Failed(_)));
    assert!(player.ship.go_back());
}

#[test]
fn a_path_that_only_leads_into_the_hole_has_no_highest_point() {
    let mut player = Player::begin("graze");
    let labels = |player: &Player| -> Vec<&'static str> {
        let mass = player.ship.mass().unwrap();
        let all = instruments(&player.ship, mass, Units::Hole);
        all.iter().map(|row| row.label).collect()
    };
    assert!(labels(&player).contains(&"highest point"));
    player.until(1.0, |player| {
        player.ship.voyage().unwrap().flight.ship.constants().energy > 1.1
    });
    let shown = labels(&player);
    assert!(shown.contains(&"lowest point"), "{shown:?}");
    assert!(!shown.contains(&"highest point"), "{shown:?}");
}

#[test]
fn the_map_draws_a_path_to_the_horizon_and_not_inside() {
    let outside = [DVec3::new(3.0, 0.0, 0.0), DVec3::new(0.0, 2.0, 0.0)];
    assert_eq!(outside_horizon(1.0, &outside), outside);
    let path = [
        outside[1],
        DVec3::new(0.0, 0.5, 0.0),
        DVec3::new(0.7, 0.0, 0.0),
    ];
    let drawn = outside_horizon(1.0, &path);
    assert!(drawn.len() == 2 && drawn[0] == outside[1], "{drawn:?}");
    assert!((drawn[1] - DVec3::Y).length() < 1e-15, "{drawn:?}");
    assert!(outside_horizon(1.0, &path[1..]).is_empty());
}

/// The radii of its goal are those of the lowest and the highest point.
#[test]
fn the_map_has_a_ring_for_each_radius_of_a_goal() {
    assert_eq!(Player::begin("two-burns").ship.goal_radii(), [5.9, 6.1]);
    assert_eq!(Player::begin("weight").ship.goal_radii(), [2.9, 3.1]);
    assert!(Player::begin("gyroscope").ship.goal_radii().is_empty());
}

#[test]
fn a_ship_without_an_engine_and_one_without_fuel_cannot_push() {
    let player = Player::begin("gyroscope");
    assert!(!player.ship.has_engine() && !player.ship.is_empty() && !player.ship.can_push());
    let mut player = Player::begin("two-burns");
    assert!(player.ship.can_push());
    player.until(1.0, |player| player.ship.is_empty());
    assert!(player.ship.has_engine() && !player.ship.can_push());
    // A thrust key that pushes nothing leaves faster time as it is.
    let mut player = Player::begin("gyroscope");
    player.ship.change_pace(2);
    player.pass(1.0);
    assert_eq!(player.ship.pace(), 4.0);
}

/// The value of an instrument.
fn shown(player: &Player, label: &str, units: Units) -> String {
    let all = instruments(&player.ship, player.ship.mass().unwrap(), units);
    let row = all.into_iter().find(|row| row.label == label);
    row.unwrap_or_else(|| panic!("no {label}")).value
}

#[test]
fn fuel_is_shown_in_per_cent_of_the_tank_before_its_rapidity() {
    let fuel = |player: &Player, units| shown(player, "fuel", units);
    let mut player = Player::begin("two-burns");
    let everyday = Units::Everyday(player.ship.mass().unwrap());
    assert_eq!(
        fuel(&player, Units::Hole),
        "100 % (rapidity 0.1000) · mass 100 %"
    );
    assert_eq!(fuel(&player, everyday), "100 % (rapidity 0.1000)");
    // A frame takes a six hundredth of the tank.
    player.until(1.0, |player| player.value(Quantity::RapidityUsed) > 0.0499);
    let half = fuel(&player, everyday);
    assert!(half.starts_with("50 % (rapidity 0.0"), "{half}");
    player.until(1.0, |player| player.ship.is_empty());
    assert_eq!(fuel(&player, everyday), "the tank is empty");
    let player = Player::begin("gyroscope");
    assert_eq!(fuel(&player, Units::Hole), "no engine");
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

/// The view from the side is 0.55 as high as it is wide.
#[test]
fn the_map_shows_the_whole_horizon_and_the_whole_path_from_above_and_from_the_side() {
    for places in [
        vec![],
        vec![DVec3::new(1.02, 0.0, 0.0)],
        vec![DVec3::new(0.0, 0.0, 3.0)],
        vec![DVec3::new(20.0, 5.0, -1.0), DVec3::new(0.0, 2.0, 0.5)],
    ] {
        let half_width = map_half_width(1.0, places.iter());
        let half_height = 0.55 * half_width;
        assert!(half_height > 1.0, "{places:?}");
        for place in &places {
            assert!(place.length() < half_width, "{places:?}");
            assert!(place.z.abs() < half_height, "{places:?}");
        }
    }
}

/// What the goals show beside each other: what is, and what is wanted.
fn shown_goals(player: &Player) -> Vec<Wanted> {
    wanted(player.ship.attempt().unwrap(), Units::Hole)
}

/// Labels and values of the instruments that the smallest window shows.
fn needed(player: &Player) -> Vec<(&'static str, String)> {
    let mass = player.ship.mass().unwrap();
    let all = instruments(&player.ship, mass, Units::Hole);
    let needed = all.into_iter().filter(|row| row.is_needed);
    needed.map(|row| (row.label, row.value)).collect()
}

#[test]
fn the_goals_show_each_quantity_with_what_is_wanted_of_it() {
    let player = Player::begin("graze");
    let radius = Wanted {
        label: "radius",
        value: "20.00 r_s".into(),
        wanted: "≤ 1.6 r_s".into(),
        is_met: false,
    };
    let lowest = Wanted {
        label: "lowest point",
        value: "in the hole".into(),
        wanted: "≥ 1.5 r_s".into(),
        is_met: false,
    };
    assert_eq!(shown_goals(&player), [radius, lowest]);
    // What ends the mission is said near it only.
    let mut near = Player::begin("graze");
    near.until(1.0, |player| player.scene.camera.r < 1.53);
    let rows = shown_goals(&near);
    assert!(rows[0].wanted.ends_with("not < 1.02 r_s"), "{rows:?}");
    let rows = shown_goals(&Player::begin("gyroscope"));
    let [turns, turned] = &rows[..] else {
        panic!("{rows:?}");
    };
    assert_eq!((turns.label, turns.wanted.as_str()), ("turns", "≥ 3"));
    assert_eq!(turns.value, "0.000");
    assert_eq!(turned.wanted, "= 0°, not > 0°");
    assert!(turned.is_met && !turns.is_met);
}

/// The hole of this mission has the mass of M87*, where one c^2/r_s is 477.43 g.
#[test]
fn the_thrust_of_a_goal_is_off_or_has_g_beside_its_own_unit_and_is_never_rounded_to_zero() {
    let mut player = Player::begin("two-burns");
    let thrust = |player: &Player, units| {
        let rows = wanted(player.ship.attempt().unwrap(), units);
        let row = rows.into_iter().find(|row| row.label == "thrust").unwrap();
        assert_eq!(row.wanted, "engine off");
        row.value
    };
    let everyday = Units::Everyday(player.ship.mass().unwrap());
    assert_eq!(thrust(&player, Units::Hole), "off");
    player.pass(1.0);
    assert_eq!(thrust(&player, Units::Hole), "0.02 c²/r_s · 9.55 g");
    assert_eq!(thrust(&player, everyday), "9.55 g");
    // A five hundredth of it, which is the least that the wheel sets.
    player.ship.change_thrust(-100.0);
    player.pass(1.0);
    assert_eq!(thrust(&player, Units::Hole), "4.00e-5 c²/r_s · 0.0191 g");
    assert_eq!(thrust(&player, everyday), "0.0191 g");
}

/// A frame of a twentieth of a second at 5 r_s is 0.0559 r_s/c, of 9851 s.
#[test]
fn times_in_years_are_shown_in_the_unit_that_fits_them() {
    let mut player = Player::begin("ten-years");
    player.pass(0.0);
    let rows = shown_goals(&player);
    let of = |label: &str| rows.iter().find(|row| row.label == label).unwrap();
    assert_eq!(of("home's time").wanted, "≥ 10 years");
    let own = of("your time");
    assert_eq!((&*own.value, &*own.wanted), ("9.18 minutes", "≤ 1 year"));
}

/// A caption, a hint or a condition that names a quantity leaves no pilot without it, however small the
/// window is.
#[test]
fn what_a_mission_names_is_shown_in_the_smallest_window() {
    let has = |player: &Player, label: &str| {
        let rows = needed(player);
        assert!(
            rows.iter().any(|row| row.0 == label),
            "no {label} in {rows:?}"
        );
    };
    let cases: [(&str, &[&str]); 7] = [
        ("two-burns", &["lowest point", "highest point", "thrust"]),
        ("graze", &["radius, speed", "fuel", "lowest point", "E"]),
        ("sample", &["speed in gas", "lowest point"]),
        ("penrose", &["energy ratio"]),
        ("longest", &["life inside", "fuel"]),
        ("ten-years", &["home's time", "your time"]),
        ("gyroscope", &["turns", "ship turned by"]),
    ];
    for (name, labels) in cases {
        let player = Player::begin(name);
        for label in labels {
            has(&player, label);
        }
    }
    let mut player = Player::begin("longest");
    player.until(0.0, |player| player.scene.camera.r < 1.0);
    has(&player, "life left");
    // Without a mission, where the ship is and where it goes.
    let mut free = Player::begin("graze");
    free.ship
        .board(&free.scene, HoleMass::of_suns(1e9))
        .unwrap();
    let all = instruments(&free.ship, HoleMass::of_suns(1e9), Units::Hole);
    let count = all.iter().filter(|row| row.is_needed).count();
    assert_eq!(count, 6, "{all:?}");
}

/// A name in braces stands for a key.
#[test]
fn texts_of_missions_and_lessons_name_controls_that_exist() {
    let check = |name: &str, text: &str| {
        for part in text.split('{').skip(1) {
            let (id, _) = part
                .split_once('}')
                .unwrap_or_else(|| panic!("{name}: {text}"));
            assert!(control_named(id).is_some(), "{name}: {id}");
        }
    };
    for (name, text) in MISSIONS {
        let mission = mission::load(name, text).unwrap();
        mission.texts().iter().for_each(|text| check(name, text));
    }
    for (name, text) in LESSONS {
        let lesson = journey::load(name, text).unwrap();
        lesson.texts().iter().for_each(|text| check(name, text));
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

#[test]
fn names_in_braces_that_no_control_has_are_told_with_what_was_probably_meant() {
    let text = "Press {inspector}, {fly.left}, {fly.lefft} or {nothing like it}".to_owned();
    let there_is_no = |name: &str, rest: &str| {
        format!("there is no control {{{name}}}, and the text keeps its braces{rest}")
    };
    assert_eq!(
        unknown_controls([&text]),
        [
            there_is_no("inspector", "; did you mean {window.inspector}?"),
            there_is_no("fly.lefft", "; did you mean {fly.left}?"),
            there_is_no("nothing like it", ""),
        ]
    );
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
        time: "2026-03-01T09:05:00Z".into(),
        pupil: "Lovelace, \"Ada\"".into(),
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
    // More lamps, then less rapidity; and a failure is no better than anything.
    assert!(rows[2].is_better_than(&rows[1]) && rows[3].is_better_than(&rows[2]));
    assert!(!rows[3].is_better_than(&rows[3]) && !rows[0].is_better_than(&rows[1]));
}

/// The columns of earlier versions keep their places, and a name is no formula.
#[test]
fn the_last_cells_of_a_result_are_its_time_and_its_pupil() {
    let flown = MissionResult {
        pupil: "=1+1, Ada".into(),
        ..result("graze", true, 3, 1.0)
    };
    let row = flown.row();
    assert!(
        row.ends_with(",3.5e-14,,,2026-03-01T09:05:00Z,\"'=1+1, Ada\""),
        "{row}"
    );
    assert_eq!(MissionResult::read(&row).unwrap().row(), row);
    // A row of an earlier version has none of both.
    let old = MissionResult::read("sample,reached,3,1,1,1,1,,,1,1,2,1e-12,42,true").unwrap();
    assert_eq!((old.time.as_str(), old.pupil.as_str()), ("", ""));
    assert_eq!((old.answer, old.is_right), (Some(42.0), Some(true)));
}

/// A path that comes away has no highest point, and a table has no word for infinity.
#[test]
fn numbers_of_a_result_that_are_not_finite_are_empty_cells_and_the_row_is_read_again() {
    let missed = MissionResult {
        par: Some((Quantity::Apoapsis, f64::INFINITY)),
        peak_tide: f64::INFINITY,
        ..result("graze", false, 0, 0.5)
    };
    let row = missed.row();
    assert!(row.contains(",apoapsis,,9.5,,5.99,"), "{row}");
    let read = MissionResult::read(&row).unwrap();
    assert_eq!(read.row(), row);
    assert_eq!(
        read.par.map(|(quantity, _)| quantity),
        Some(Quantity::Apoapsis)
    );
}

/// Going back to the last goal goes on with the same attempt: its row is the better end of it, and of two
/// misses the later one.
#[test]
fn an_attempt_that_is_gone_on_with_has_one_row_and_keeps_its_better_end() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("results.csv");
    let mut results = MissionResults::load(Some(file.clone()));
    let rows = || -> Vec<String> {
        let text = std::fs::read_to_string(&file).unwrap();
        text.lines().skip(1).map(str::to_owned).collect()
    };
    let missed = result("graze", false, 0, 0.5);
    let (kept, written) = results.keep(None, missed.clone());
    assert_eq!((kept, written), (missed.clone(), Ok(())));
    // Of two misses the later one stays, whatever was spent.
    let again = result("graze", false, 0, 0.7);
    let (kept, _) = results.keep(Some(missed), again.clone());
    assert_eq!(kept, again);
    assert_eq!(rows(), [again.row()]);
    let reached = result("graze", true, 2, 1.2);
    let (kept, _) = results.keep(Some(again), reached.clone());
    assert_eq!(kept, reached);
    assert_eq!(rows(), [reached.row()]);
    // An answer may have been given since.
    let answered = MissionResult {
        answer: Some(42.0),
        is_right: Some(false),
        ..reached.clone()
    };
    results.correct_last(answered.clone()).unwrap();
    let (kept, _) = results.keep(Some(reached.clone()), result("graze", true, 1, 1.0));
    assert_eq!(kept, reached);
    assert_eq!(rows(), [answered.row()]);
    let better = result("graze", true, 3, 1.1);
    let (kept, _) = results.keep(Some(reached), better.clone());
    assert_eq!(kept, better);
    assert_eq!(rows(), [better.row()]);
    assert_eq!(results.best("graze"), Some(&better));
}

#[test]
fn the_nearest_miss_is_the_failed_attempt_with_the_most_of_its_par() {
    let mut results = MissionResults::default();
    for row in [
        result("longest", false, 0, 0.78),
        result("longest", false, 0, 0.98),
        result("longest", false, 0, 0.5),
        result("longest", true, 1, 1.2),
        result("graze", false, 0, 3.0),
    ] {
        results.add(row).unwrap();
    }
    let nearest = |quantity| {
        let nearest = results.nearest_miss("longest", quantity);
        nearest.and_then(|row| row.par).map(|(_, value)| value)
    };
    assert_eq!(nearest(Quantity::RapidityUsed), Some(0.98));
    assert_eq!(nearest(Quantity::LifeInside), None);
}

/// A table for a class has no digits of rounding.
#[test]
fn the_numbers_of_a_result_are_short_and_small_ones_have_an_exponent() {
    let row = MissionResult {
        own_time: 0.1 + 0.2,
        peak_tide: 5.0519e-13 * 1.000_000_000_001,
        ..result("graze", true, 3, 1.0 / 3.0)
    }
    .row();
    let cells: Vec<&str> = row.split(',').collect();
    assert_eq!(cells[4..7], ["0.3", "", "0.3333333333"], "{row}");
    assert_eq!(
        cells[9..13],
        ["9.5", "5.0519e-13", "5.99", "3.5e-14"],
        "{row}"
    );
}

#[test]
fn the_next_mission_is_the_first_one_after_this_that_was_not_reached_or_one_before_it() {
    let list: Vec<_> = MISSIONS
        .iter()
        .map(|(name, text)| mission::load(name, text).unwrap())
        .collect();
    let next = |name: &str, reached: &[&str]| {
        let next = next_not_reached(&list, name, |name| reached.contains(&name));
        next.map(|mission| mission.name.clone())
    };
    assert_eq!(next("two-burns", &[]).as_deref(), Some("weight"));
    assert_eq!(next("two-burns", &["weight"]).as_deref(), Some("gyroscope"));
    assert_eq!(next("longest", &["two-burns"]).as_deref(), Some("weight"));
    // A mission of one's own is in no list.
    assert_eq!(next("mine", &[]).as_deref(), Some("two-burns"));
    let others: Vec<&str> = MISSIONS.iter().map(|(name, _)| *name).skip(1).collect();
    assert_eq!(next("two-burns", &others), None);
}

#[test]
fn the_list_of_missions_begins_where_the_player_was_or_at_the_next_one_that_was_not_reached() {
    let list: Vec<_> = MISSIONS
        .iter()
        .map(|(name, text)| mission::load(name, text).unwrap())
        .collect();
    let choice = |flown, reached: &[&str]| {
        let place = first_choice(&list, flown, |name| reached.contains(&name));
        place.map(|place| list[place].name.as_str())
    };
    // At the start of the program, and after a mission that is not in the list.
    assert_eq!(choice(None, &[]), Some("two-burns"));
    assert_eq!(choice(None, &["two-burns"]), Some("weight"));
    assert_eq!(choice(Some(("mine", true)), &["two-burns"]), Some("weight"));
    // A mission that was not reached this time stays, though it was before.
    assert_eq!(choice(Some(("graze", false)), &[]), Some("graze"));
    assert_eq!(choice(Some(("graze", false)), &["graze"]), Some("graze"));
    assert_eq!(
        choice(Some(("graze", true)), &["graze", "ten-years"]),
        Some("sample")
    );
    let all: Vec<&str> = MISSIONS.iter().map(|(name, _)| *name).collect();
    assert_eq!(choice(None, &all), None);
    assert_eq!(choice(Some(("graze", true)), &all), Some("graze"));
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
    assert!(
        text.lines()
            .next()
            .unwrap()
            .ends_with(",answer,is_right,time,pupil"),
        "{text}"
    );
    assert_eq!(lines()[0], "sample,reached,3,1,1,1,1,,,1,1,2,1e-12,");
    assert_eq!(
        MissionResults::load(Some(file.clone()))
            .best("sample")
            .unwrap()
            .is_right,
        None
    );
    // A file that is gone is begun again, with its header.
    std::fs::remove_file(&file).unwrap();
    results.correct_last(answered.clone()).unwrap();
    assert_eq!(lines(), [answered.row()]);
}
