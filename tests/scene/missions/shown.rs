//! What a pilot sees of a mission: instruments, goals and the map.

use super::Player;
use glam::DVec3;
use lightfall::app::{Wanted, instruments, map_half_width, outside_horizon, wanted};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::path_ahead;
use lightfall_core::scene::mission::Quantity;

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
