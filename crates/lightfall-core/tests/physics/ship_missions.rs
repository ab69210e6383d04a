//! The built-in missions: their solutions reach their goals, and do not without their last burn.

use lightfall_core::geometry::timelike::Limit;
use lightfall_core::optics::ship::{
    Apsides, Attempt, Event, Heading, Hold, Orders, Outcome, Records, SolutionError, Thrust, fly,
};
use lightfall_core::scene::mission::{
    Burn, Caption, Comparison, Condition, Course, MISSIONS, Mission, Push, Quantity, Until, load,
};

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
        let voyage = attempt.scored();
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

/// A burn, half a turn in fast time past the lowest point, and a hold. The lowest point is also known
/// from the roots of the radial motion, and the tide there from its formula without spin.
#[test]
fn the_extremes_of_a_flight_do_not_depend_on_the_rate_of_frames() {
    let all = missions();
    let mission = all.iter().find(|mission| mission.name == "two-burns");
    let flights = [7, 30, 144].map(|frames_a_second| {
        let mut attempt = Attempt::new(mission.unwrap()).unwrap();
        let fly = |attempt: &mut Attempt, thrust, seconds: u32, rate: f64| {
            attempt.order(Orders {
                thrust,
                ..Orders::COAST
            });
            for _ in 0..seconds * frames_a_second {
                attempt.advance(rate / f64::from(frames_a_second)).unwrap();
            }
        };
        fly(
            &mut attempt,
            Thrust::Along(Heading::Retrograde, 0.01),
            1,
            3.0,
        );
        let ship = &attempt.voyage().flight.ship;
        let lowest = Apsides::of(ship).periapsis.unwrap();
        let across = ship.constants().angular_momentum / lowest;
        let tide = 0.5 / lowest.powi(3) * (2.0 + 3.0 * across * across);
        fly(&mut attempt, Thrust::Off, 5, 48.0);
        let passed = *attempt.voyage().records();
        // The maxima are taken for ends of pieces where they lie within a hundred-thousandth of one.
        assert!((passed.lowest / lowest - 1.0).abs() < 1e-9, "{passed:?}");
        assert!((passed.tide / tide - 1.0).abs() < 1e-9, "{passed:?}");
        assert!((passed.acceleration - 0.01).abs() < 1e-15, "{passed:?}");
        fly(&mut attempt, Thrust::Hold(Hold::Hover(8.0), 0.3), 1, 3.0);
        *attempt.voyage().records()
    });
    for records in &flights {
        assert!(records.acceleration > 0.015, "the hold pushes: {records:?}");
        for of in [
            |records: &Records| records.acceleration,
            |records: &Records| records.tide,
            |records: &Records| records.lowest,
        ] {
            let differs = of(records) / of(&flights[0]) - 1.0;
            assert!(differs.abs() < 1e-9, "{flights:?}");
        }
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
        let scored = *attempt.scored();
        let later = attempt.advance(1.0).unwrap();
        assert_eq!(later, outcome, "an attempt that is over stays as it is");
        assert_eq!(*attempt.scored(), scored);
        if expected {
            // The moment of the failure, and not of the frame in which it happened.
            assert!((scored.flight.ship.place().r - 1.02).abs() < 1e-9);
            assert!((scored.records().lowest - 1.02).abs() < 1e-9);
        }
    }
}

/// Each phase of the solution, and what a player may meet in it, has its caption and no other one.
#[test]
fn the_captions_of_ten_years_belong_to_the_phases_of_its_flight() {
    let mission = missions()
        .into_iter()
        .find(|mission| mission.name == "ten-years")
        .unwrap();
    let check = |attempt: &Attempt, start: &str| {
        let captions = mission.captions.iter();
        let due: Vec<&str> = captions
            .filter(|caption| !caption.when.is_empty() && attempt.voyage().meets(&caption.when))
            .map(|caption| caption.text.as_str())
            .collect();
        assert!(
            due.len() == 1 && due[0].starts_with(start),
            "{start}: {due:?}"
        );
    };
    let coast = |time| Burn {
        push: Push::Off,
        acceleration: 0.0,
        until: Until::Passed(time),
    };
    let hold = |r| Orders {
        thrust: Thrust::Hold(Hold::Orbit(r), 3.0),
        ..Orders::COAST
    };
    let parts = &mission.solution;
    let mut attempt = Attempt::new(&mission).unwrap();
    fly(&mut attempt, &parts[..1]).unwrap();
    check(&attempt, "Low enough");
    let mut lower = attempt.clone();
    lower.order(Orders {
        thrust: Thrust::Along(Heading::Retrograde, 0.1),
        ..Orders::COAST
    });
    // 0.01 of rapidity is 0.13 r_s of the lowest point.
    lower.advance(0.1).unwrap();
    check(&lower, "Too low");
    fly(&mut attempt, &parts[1..2]).unwrap();
    check(&attempt, "Press {fly.orbit}");
    fly(&mut attempt, &parts[2..4]).unwrap();
    check(&attempt, "Now wait");
    let mut held = attempt.clone();
    held.order(hold(0.6225));
    held.advance(0.05).unwrap();
    check(&held, "The engine holds");
    let mut higher = attempt.clone();
    higher.order(hold(0.635));
    higher.advance(3.0).unwrap();
    higher.order(Orders::COAST);
    let too_high = |caption: &&Caption| caption.text.starts_with("This circle is too high");
    let caption = mission.captions.iter().find(too_high).unwrap();
    assert!(higher.voyage().meets(&caption.when));
    fly(&mut attempt, &[coast(2500.0)]).unwrap();
    check(&attempt, "Eight years");
    fly(&mut attempt, &[coast(575.0)]).unwrap();
    check(&attempt, "Ten years");
    fly(&mut attempt, &parts[5..6]).unwrap();
    check(&attempt, "High enough");
    fly(&mut attempt, &parts[6..]).unwrap();
    assert_eq!(attempt.outcome(), Outcome::Success);
}

#[test]
fn faults_of_a_mission_are_named_with_their_line_or_key() {
    let (name, text) = MISSIONS[3];
    let said = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        load(name, &text.replace(from, to)).unwrap_err().to_string()
    };
    let before = text.find("brief =").unwrap();
    let line = format!("line {}: ", 1 + text[..before].matches('\n').count());
    for (from, to, words) in [
        (
            "brief =",
            "breif =",
            [
                line.as_str(),
                "unknown field `breif`; did you mean `brief`?",
            ],
        ),
        (
            "\"r <= 1.6\"",
            "\"radius <= 1.6\"",
            ["names no quantity of a flight", "periapsis"],
        ),
        (
            "\"r <= 1.6\"",
            "\"apoapsys <= 1.6\"",
            ["names no quantity of a flight", "did you mean apoapsis?"],
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
            [
                "observer = \"still\" is refused",
                "it must be one of static, zamo,",
            ],
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
            "face = \"hole\"",
            "face = \"hole\", star_deg = [30.0, 0.0]",
            ["start.star_deg is refused", "face is \"hole\""],
        ),
        (
            "face = \"hole\"",
            "face = \"star\", star_deg = [180.5, 0.0]",
            ["start.star_deg: theta = 180.5", "from 0 to 180 degrees"],
        ),
        (
            "face = \"hole\"",
            "face = \"star\", star_deg = [30.0, inf]",
            ["start.star_deg: phi = inf", "a finite number"],
        ),
        (
            "\"fly.left\"",
            "\"fly.lefft\"",
            ["\"fly.lefft\" is refused", "did you mean fly.left?"],
        ),
        (
            "\"fly.left\"",
            "\"fly.forward\"",
            ["keys lists \"fly.forward\" twice", "once"],
        ),
        (
            "\"fly.left\"",
            "\"fly.up\", \"fly.down\", \"ship.map\", \"motion.pause\"",
            ["number of keys = 11", "at most 10"],
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

/// A part that waits for what never happens says so, and whether the tank is empty.
#[test]
fn a_solution_that_runs_dry_says_that_the_tank_is_empty() {
    let mut mission = missions().swap_remove(0);
    assert_eq!(mission.name, "two-burns");
    let never = Condition {
        quantity: Quantity::R,
        comparison: Comparison::AtMost,
        value: 1.0,
    };
    // The whole tank along the motion is more than the speed of escape.
    for (push, expected) in [
        (Push::Along(Course::Prograde), SolutionError::Empty(1)),
        (Push::Off, SolutionError::NeverEnds(1)),
    ] {
        mission.solution = vec![Burn {
            push,
            acceleration: 0.02,
            until: Until::Holds(never),
        }];
        let mut attempt = Attempt::new(&mission).unwrap();
        let outcome = fly(&mut attempt, &mission.solution);
        assert_eq!(outcome, Err(expected));
    }
    let said = SolutionError::Empty(1).to_string();
    assert!(said.ends_with("because the tank is empty"), "{said}");
}
