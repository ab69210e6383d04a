//! The built-in missions: their solutions reach their goals, and do not without their last burn.

use lightfall_core::geometry::timelike::Limit;
use lightfall_core::optics::ship::{Attempt, Event, Hold, Orders, Outcome, Thrust, fly};
use lightfall_core::scene::mission::{Burn, MISSIONS, Mission, Push, Quantity, load};

fn missions() -> Vec<Mission> {
    MISSIONS
        .iter()
        .map(|(name, text)| load(name, text).unwrap_or_else(|error| panic!("{error}")))
        .collect()
}

/// The parts of a solution without its last one with the engine on.
fn without_last_burn(solution: &[Burn]) -> Option<Vec<Burn>> {
    let last = solution.iter().rposition(|burn| burn.push != Push::Off)?;
    let mut rest = solution.to_vec();
    rest.remove(last);
    Some(rest)
}

#[test]
fn solutions_reach_every_goal_and_do_not_without_their_last_burn() {
    let mut faults = Vec::new();
    for mission in missions() {
        let mut attempt = Attempt::new(&mission).unwrap();
        let outcome = fly(&mut attempt, &mission.solution);
        let voyage = attempt.success().unwrap_or(attempt.voyage());
        let quantity = |quantity| voyage.quantity(quantity).unwrap_or(f64::NAN);
        eprintln!(
            "{}: {outcome:?} reached {:.4?} rapidity {:.4} tau {:.4} t {:.4} r {:.4} E {:.4} ratio {:.4} life {:.4} error {:.0e}",
            mission.name,
            attempt.reached(),
            quantity(Quantity::RapidityUsed),
            quantity(Quantity::Tau),
            quantity(Quantity::T),
            quantity(Quantity::R),
            quantity(Quantity::Energy),
            quantity(Quantity::EnergyRatio),
            quantity(Quantity::LifeInside),
            voyage.flight.ship.error().stated(),
        );
        if outcome != Ok(Outcome::Success) {
            faults.push(format!("{}: {outcome:?}", mission.name));
        }
        for par in &mission.pars {
            // Pars are what these solutions need, in three digits.
            let found = quantity(par.quantity);
            let is_near = (found / par.value - 1.0).abs() < 0.005;
            if !is_near {
                faults.push(format!("{}: {} {found}", mission.name, par.quantity.word()));
            }
        }
        if let Some(rest) = without_last_burn(&mission.solution) {
            let mut attempt = Attempt::new(&mission).unwrap();
            let outcome = fly(&mut attempt, &rest);
            eprintln!("  without: {outcome:?}");
            if outcome == Ok(Outcome::Success) {
                faults.push(format!("{}: success without the last burn", mission.name));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// The moments are found by bisection, and holds command in ticks of their own.
#[test]
fn goals_are_reached_at_the_same_moment_in_frames_of_any_length() {
    let all = missions();
    let mission = all.iter().find(|mission| mission.name == "weight").unwrap();
    let moments = [30, 60, 144, 2].map(|frames| {
        let mut attempt = Attempt::new(mission).unwrap();
        for (orders, own) in [
            (Orders::COAST, 12.0),
            (
                Orders {
                    thrust: Thrust::Hold(Hold::Hover(3.0), 0.3),
                    ..Orders::COAST
                },
                30.0,
            ),
        ] {
            attempt.order(orders);
            for _ in 0..frames {
                attempt.advance(own / f64::from(frames)).unwrap();
            }
        }
        assert_eq!(attempt.outcome(), Outcome::Success);
        attempt.reached()[0]
    });
    for moment in moments {
        // The bar of places, 1e-9 r_s, over a speed of 0.02 c near the goal's edge.
        assert!((moment - moments[0]).abs() < 1e-8, "{moments:?}");
    }
}

#[test]
fn attempts_fail_as_their_missions_say_and_end_where_flights_end() {
    for (name, expected) in [("graze", true), ("longest", false)] {
        let mission = missions().into_iter().find(|mission| mission.name == name);
        let mut attempt = Attempt::new(&mission.unwrap()).unwrap();
        let outcome = attempt.advance(500.0).unwrap();
        if expected {
            assert_eq!(outcome, Outcome::Failed(0));
        } else {
            assert_eq!(outcome, Outcome::Ended(Event::Limit(Limit::Inner)));
        }
        let later = attempt.advance(1.0).unwrap();
        assert_eq!(later, outcome, "an attempt that is over stays as it is");
    }
}

#[test]
fn faults_of_a_mission_are_named_with_their_line_or_key() {
    let (name, text) = MISSIONS[3];
    let said = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        load(name, &text.replace(from, to)).unwrap_err().to_string()
    };
    for (from, to, words) in [
        ("brief =", "breif =", ["line 9", "unknown field `breif`"]),
        (
            "\"r <= 1.6\"",
            "\"radius <= 1.6\"",
            ["names no quantity of a flight", "periapsis"],
        ),
        (
            "\"r <= 1.6\"",
            "\"r = 1.6\"",
            ["is not a condition", "line"],
        ),
        (
            "exhaust = 1.0",
            "exhaust = 1.5",
            ["ship.exhaust = 1.5 is refused", "at most 1"],
        ),
        (
            "preset = \"close\"",
            "preset = \"near\"",
            ["preset = \"near\" is refused", "4 close"],
        ),
        (
            "r = 20.0",
            "r = 0.5",
            ["camera.r = 0.5", "outside the horizon"],
        ),
        (
            "observer = \"static\"",
            "observer = \"still\"",
            ["unknown variant `still`", "`static`"],
        ),
        (
            "schema = 1",
            "schema = 2",
            ["schema = 2", "another version"],
        ),
        (
            "name = \"graze\"",
            "name = \"Graze!\"",
            ["name = \"Graze!\"", "small letters"],
        ),
        (
            "until = \"r <= 8\"",
            "until = \"r <= 8\"\nfor = 3",
            ["solution 2 has several", "until and for"],
        ),
    ] {
        let message = said(from, to);
        for word in words {
            assert!(message.contains(word), "{message}");
        }
        assert!(message.starts_with("graze: "), "{message}");
    }
}

#[test]
fn missions_have_their_files_names_and_texts_without_repetition() {
    let missions = missions();
    for (mission, (name, _)) in missions.iter().zip(MISSIONS) {
        assert_eq!(mission.name, name);
        assert!(
            !mission.teaches.is_empty() && !mission.hints.is_empty(),
            "{name}"
        );
        let same = missions.iter().filter(|other| other.title == mission.title);
        assert_eq!(same.count(), 1, "{name}");
    }
}
