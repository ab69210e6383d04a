//! What the window says of a mission.

use crate::app::state::end_card::Way;
use crate::app::state::mission_results::MissionResult;
use lightfall_core::numbers::{four_digits, three_digits};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Attempt, Outcome};
use lightfall_core::scene::mission::{Goal, Mission, Par, Quantity};

/// What the card at the start of a mission says.
pub(super) fn brief(mission: &Mission, units: Units) -> String {
    let goals = mission.goals.iter().enumerate();
    let goals = goals.map(|(index, goal)| format!("\n{}. {}", index + 1, goal_words(goal, units)));
    let goals: String = goals.collect();
    let fuel = match mission.ship.rapidity {
        0.0 => "Your ship has no engine.".into(),
        rapidity => format!("Your tank holds a rapidity of {}.", four_digits(rapidity)),
    };
    format!("{} {fuel}\n{goals}", mission.brief)
}

/// A goal in words, with the time for which it must be held unless its text says the same.
fn goal_words(goal: &Goal, units: Units) -> String {
    let held = format!("for {}", units.time(goal.hold, four_digits));
    if goal.hold == 0.0 || goal.text.contains(&held) {
        goal.text.clone()
    } else {
        format!("{} ({held})", goal.text)
    }
}

/// The keys that the card at the start names.
pub(super) fn first_keys(mission: &Mission) -> Vec<Way> {
    let time = ("motion.faster", "time runs faster");
    let again = ("journey.again", "the mission from its start");
    if mission.ship.rapidity == 0.0 {
        return vec![time, again];
    }
    vec![
        ("fly.forward", "push along the nose"),
        ("fly.face", "turn the nose to a heading"),
        ("fly.orbit", "hold the orbit"),
        ("motion.let_go", "engine off"),
        time,
        again,
    ]
}

/// The keys that the card at the end names.
pub(super) fn ways_on(has_succeeded: bool) -> Vec<Way> {
    let mut ways = vec![
        ("journey.again", "fly it again"),
        ("scene.undo", "back to the last goal, or the start"),
        ("ship.missions", "other missions"),
        ("ship.fly", "leave the ship"),
    ];
    if has_succeeded {
        ways.swap(0, 2);
    }
    ways
}

/// The title and the text of the card at the end.
pub(super) fn end(
    attempt: &Attempt,
    kept: &MissionResult,
    [goals, par, time]: [bool; 3],
    hint: Option<&str>,
    units: Units,
) -> [String; 2] {
    let mission = &attempt.mission;
    let ending = match attempt.outcome() {
        Outcome::Success => &mission.ending.success,
        Outcome::Failed(index) => &mission.fails[index].text,
        Outcome::Ended(_) | Outcome::UnderWay(_) => &mission.ending.failure,
    };
    let hint = hint.map_or_else(String::new, |hint| format!("\n\nHint: {hint}"));
    let title = if goals { "Reached" } else { "Not reached" };
    let lamp = |lit: bool| if lit { "●" } else { "○" };
    let lamps = format!(
        "{} goals   {} par   {} time",
        lamp(goals),
        lamp(par),
        lamp(time)
    );
    let numbers = numbers(mission, kept, units);
    [
        format!("{title}: {}", mission.title),
        format!("{ending}\n\n{lamps}\n{numbers}{hint}"),
    ]
}

/// The numbers of an attempt, in lines.
fn numbers(mission: &Mission, kept: &MissionResult, units: Units) -> String {
    let par = mission.pars.first().map_or_else(String::new, |par| {
        let value = kept
            .par
            .map_or_else(|| "none".into(), |(_, value)| four_digits(value));
        let name = par.quantity.word().replace('_', " ");
        format!("{name} {value}, par {}\n", four_digits(par.value))
    });
    let own = units.time(kept.own_time, four_digits);
    let far = kept.far_time.map_or_else(String::new, |far| {
        format!(", home's {}", units.time(far, four_digits))
    });
    let lowest = units.length(kept.lowest, four_digits);
    // The first par may have said it.
    let is_par = |par: &Par| par.quantity == Quantity::RapidityUsed;
    let rapidity = match mission.pars.first().is_some_and(is_par) {
        true => String::new(),
        false => format!("rapidity {}, ", four_digits(kept.rapidity_used)),
    };
    format!(
        "{par}your clock {own}{far}\n{rapidity}at most {} g\nlowest point {lowest}, error {:.0e}",
        three_digits(kept.peak_g),
        kept.error
    )
}
