//! Missions in the window: flown frame by frame as a player does.

mod results;
mod shown;
mod texts;

use glam::DVec3;
use lightfall::app::{FlightStep, HoldKind, ShipFlight, ShipFrame, Stick, lamps, solution_time};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::optics::ship::{Apsides, Heading, Outcome};
use lightfall_core::scene::Scene;
use lightfall_core::scene::mission::{self, MISSIONS, Mission, Quantity};

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

#[test]
fn the_nose_of_a_mission_that_counts_turns_is_held_by_the_gyroscopes() {
    let mut player = Player::begin("gyroscope");
    assert_eq!(player.ship.heading(), None);
    player.ship.change_pace(4);
    player.until(0.0, |player| player.outcome() == Outcome::Success);
    assert_eq!(player.ship.voyage().unwrap().flight.turned(), 0.0);
}
