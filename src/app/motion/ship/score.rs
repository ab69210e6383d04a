//! How good an attempt at a mission was, in physical quantities only.

use lightfall_core::optics::ship::{Attempt, Outcome, Voyage, fly};
use lightfall_core::scene::mission::{Better, Mission, Par};

/// How near a par, and how near the time of the solution, a good flight comes.
const NEAR: f64 = 1.1;

/// The lamps that a mission lights: its goals are reached, its first par nearly, and the own time of its
/// solution nearly. Without a par or a solution the goals light its lamp.
#[must_use]
pub fn lamps(attempt: &Attempt, solution_time: Option<f64>) -> [bool; 3] {
    let reached = attempt.outcome() == Outcome::Success;
    let flown = attempt.scored();
    let par = attempt.mission.pars.first();
    let is_near = par.is_none_or(|par| is_near_par(par, flown));
    let own_time = flown.flight.ship.proper_time();
    let is_quick = solution_time.is_none_or(|time| own_time <= time_limit(time));
    [reached, reached && is_near, reached && is_quick]
}

fn is_near_par(par: &Par, flown: &Voyage) -> bool {
    flown
        .quantity(par.quantity)
        .is_some_and(|value| match par.better {
            Better::Less => value <= par_limit(par),
            Better::More => value >= par_limit(par),
        })
}

/// What lights the lamp of a par: at most or, where more is better, at least so much.
pub(super) fn par_limit(par: &Par) -> f64 {
    match par.better {
        Better::Less => NEAR * par.value,
        Better::More => par.value / NEAR,
    }
}

/// The longest own time that lights the lamp of the time, from that of the solution.
pub(super) fn time_limit(solution_time: f64) -> f64 {
    NEAR * solution_time
}

/// The own time in which a mission's solution reaches the goals. `None` if it does not, or if there is
/// none.
#[must_use]
pub fn solution_time(mission: &Mission) -> Option<f64> {
    let mut attempt = Attempt::new(mission).ok()?;
    let outcome = fly(&mut attempt, &mission.solution).ok()?;
    (outcome == Outcome::Success).then(|| attempt.scored().flight.ship.proper_time())
}
