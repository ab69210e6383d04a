//! The built-in missions: their solutions reach their goals, and do not without their last burn.

use lightfall_core::optics::ship::{Attempt, Outcome, fly};
use lightfall_core::scene::mission::{Better, Burn, MISSIONS, Mission, Push, Quantity, load};

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
    for mission in missions() {
        let mut attempt = Attempt::new(&mission).unwrap();
        let outcome = fly(&mut attempt, &mission.solution);
        let voyage = attempt.voyage();
        let quantity = |quantity| voyage.quantity(quantity).unwrap_or(f64::NAN);
        eprintln!(
            "{}: {outcome:?} reached {:?} rapidity {:.4} tau {:.4} t {:.4} r {:.4} E {:.4} ratio {:.4} life {:.4} error {:.0e}",
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
        assert_eq!(outcome, Ok(Outcome::Success), "{}", mission.name);
        for par in &mission.pars {
            // Pars have three or four digits.
            let found = quantity(par.quantity);
            let is_near = (found / par.value - 1.0).abs() < 0.01;
            assert!(is_near, "{}: {} {found}", mission.name, par.quantity.word());
            assert!(matches!(par.better, Better::Less | Better::More));
        }
        if let Some(rest) = without_last_burn(&mission.solution) {
            let mut attempt = Attempt::new(&mission).unwrap();
            let outcome = fly(&mut attempt, &rest);
            eprintln!("  without: {outcome:?}");
            assert_ne!(outcome, Ok(Outcome::Success), "{}", mission.name);
        }
    }
}
