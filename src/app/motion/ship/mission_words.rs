//! What the window says of a mission.

use super::quantity_words::{Measures, fuel, quantity_name};
use super::score::{par_limit, time_limit};
use crate::app::state::end_card::{Closes, EndCard, Lamp, LampKind, Way};
use crate::app::state::mission_results::MissionResult;
use lightfall_core::numbers::{counted, four_digits, three_digits};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Attempt, Outcome};
use lightfall_core::scene::mission::{Better, Goal, Mission, MissionKey, Par, Quantity};

/// What the card at the start of a mission says. Names of controls stand in braces.
pub(super) fn brief(mission: &Mission, units: Units) -> String {
    let goals = mission.goals.iter().enumerate();
    let goals = goals.map(|(index, goal)| format!("\n{}. {}", index + 1, goal_words(goal, units)));
    let goals: String = goals.collect();
    let full = match mission.ship.rapidity {
        0.0 => "Your ship has no engine.".into(),
        tank => format!("Your tank is full: fuel {}.", fuel(tank, tank, four_digits)),
    };
    let brief = units.in_text(&mission.brief);
    format!("{brief} {full}\n{goals}\n\nAny flight key, {{journey.again}} or a click begins.")
}

/// A goal in words, with the time for which it must be held unless its text says the same.
fn goal_words(goal: &Goal, units: Units) -> String {
    let text = units.in_text(&goal.text);
    let held = format!("for {}", units.time(goal.hold, four_digits));
    if goal.hold == 0.0 || text.contains(&held) {
        text
    } else {
        format!("{text} ({held})")
    }
}

/// The keys that the card at the start names.
pub(super) fn first_keys(mission: &Mission) -> Vec<Way> {
    let usual: &[MissionKey] = match mission.ship.rapidity {
        0.0 => &[MissionKey::FasterTime, MissionKey::Again],
        _ => &[
            MissionKey::Forward,
            MissionKey::Face,
            MissionKey::Orbit,
            MissionKey::EngineOff,
            MissionKey::FasterTime,
            MissionKey::Again,
        ],
    };
    let keys = mission.keys.as_deref().unwrap_or(usual);
    keys.iter().map(|key| (key.word(), does(*key))).collect()
}

/// What a key does, on the card at the start.
fn does(key: MissionKey) -> &'static str {
    match key {
        MissionKey::Forward => "push along the nose",
        MissionKey::Backward => "push against the nose",
        MissionKey::Left => "push to the left of the nose",
        MissionKey::Right => "push to the right of the nose",
        MissionKey::Up => "push up",
        MissionKey::Down => "push down",
        MissionKey::Slower => "held with it: a quarter of the thrust",
        MissionKey::Face => "turn the nose to a heading",
        MissionKey::Orbit => "hold the orbit",
        MissionKey::Still => "stand still: hold this place",
        MissionKey::Look => "look at the hole, or along the nose",
        MissionKey::EngineOff => "engine off",
        MissionKey::FasterTime => "time runs faster",
        MissionKey::SlowerTime => "time runs slower",
        MissionKey::Pause => "pause, go on",
        MissionKey::Map => "map of the path ahead",
        MissionKey::Again => "the mission from its start",
    }
}

/// The keys that the card at the end names. `has_next` tells whether a mission is left that was not
/// reached.
fn ways_on(has_succeeded: bool, has_next: bool) -> Vec<Way> {
    let next = ("journey.fly", "next mission");
    let again = ("journey.again", "fly it again");
    let back = ("scene.undo", "back to the last goal, or the start");
    let others = ("ship.missions", "other missions");
    let leave = ("ship.fly", "leave the ship");
    let mut ways = if has_succeeded {
        vec![next, others, back, again, leave]
    } else {
        vec![again, back, next, others, leave]
    };
    ways.retain(|way| has_next || *way != next);
    ways
}

/// What the card at the end of an attempt needs to know.
pub(super) struct End<'a> {
    pub(super) attempt: &'a Attempt,
    pub(super) kept: &'a MissionResult,
    /// The best result before this one.
    pub(super) best: Option<&'a MissionResult>,
    /// The failed attempt before this one that came nearest to the par, where one can come nearer.
    pub(super) nearest: Option<&'a MissionResult>,
    pub(super) lit: [bool; 3],
    pub(super) solution_time: Option<f64>,
    pub(super) hint: Option<&'a str>,
    pub(super) has_next: bool,
}

/// The card at the end.
pub(super) fn end(end: &End, units: Units) -> EndCard {
    let mission = &end.attempt.mission;
    let ending = match end.attempt.outcome() {
        Outcome::Success => &mission.ending.success,
        Outcome::Failed(index) => &mission.fails[index].text,
        Outcome::Ended(_) | Outcome::UnderWay(_) => &mission.ending.failure,
    };
    let [reached, ..] = end.lit;
    let title = if reached { "Reached" } else { "Not reached" };
    let hint = end.hint.map_or_else(String::new, |hint| {
        format!("\n\nHint: {}", units.in_text(hint))
    });
    let numbers = numbers(mission, end.kept, units);
    let record = record(end, units);
    EndCard {
        lamps: lamps_shown(end, units),
        details: format!("{numbers}{record}{hint}"),
        ..EndCard::new(
            &format!("{title}: {}", mission.title),
            &units.in_text(ending),
            ways_on(reached, end.has_next),
            Closes::Named,
        )
    }
}

/// The lamps that need something of their own, and what it is.
fn lamps_shown(end: &End, units: Units) -> Vec<Lamp> {
    let mission = &end.attempt.mission;
    let goals = counted(mission.goals.len(), "goal");
    let reached = format!("{} of {goals}", end.attempt.reached().len());
    let measures = Measures::new(mission, units);
    let par = mission.pars.first().map(|par| {
        let amount = |value| measures.amount(par.quantity, value, four_digits);
        let value = end.kept.par.map(|(_, value)| amount(value));
        let value = value.unwrap_or_else(|| "none".into());
        let name = quantity_name(par.quantity);
        let side = match par.better {
            Better::Less => "at most",
            Better::More => "at least",
        };
        let limit = amount(par_limit(par));
        format!("{name} {value}, needed {side} {limit}")
    });
    let time = end.solution_time.map(|time| {
        let limit = units.time(time_limit(time), four_digits);
        format!("needed at most {limit} on your clock")
    });
    // Without a par or a solution its lamp says what that of the goals does.
    let needed = [
        (LampKind::Goals, Some(reached)),
        (LampKind::Par, par),
        (LampKind::Time, time),
    ];
    let lamps = needed.into_iter().zip(end.lit);
    lamps
        .filter_map(|((kind, needed), is_lit)| {
            Some(Lamp {
                kind,
                is_lit,
                needed: needed?,
            })
        })
        .collect()
}

/// The best result before this one, and whether this one is better; without one, how near a failed attempt
/// came.
fn record(end: &End, units: Units) -> String {
    let kept = end.kept;
    let mission = &end.attempt.mission;
    let Some(best) = end.best else {
        if kept.reached {
            return "\nThis is your first success here.".into();
        }
        let nearest = end.nearest.and_then(|nearest| nearest.par);
        return nearest.map_or_else(String::new, |(quantity, value)| {
            let name = quantity_name(quantity);
            let amount = Measures::new(mission, units).amount(quantity, value, four_digits);
            format!("\nYour best before: {name} {amount}.")
        });
    };
    let lamps = counted(best.lamps, "lamp");
    let used = fuel_used(mission, best);
    let used = used.map_or_else(String::new, |used| format!(", {used}"));
    let now = if kept.is_better_than(best) {
        " This one is better."
    } else if kept.reached {
        " This one is not better."
    } else {
        ""
    };
    format!("\nYour best before: {lamps}{used}.{now}")
}

/// The fuel that an attempt used. `None` without an engine.
fn fuel_used(mission: &Mission, result: &MissionResult) -> Option<String> {
    let tank = mission.ship.rapidity;
    let used = fuel(result.rapidity_used, tank, four_digits);
    (tank > 0.0).then(|| format!("fuel used {used}"))
}

/// The numbers of an attempt that no lamp shows, in lines.
fn numbers(mission: &Mission, kept: &MissionResult, units: Units) -> String {
    let own = units.time(kept.own_time, four_digits);
    let far = kept.far_time.map_or_else(String::new, |far| {
        format!(", home's {}", units.time(far, four_digits))
    });
    let lowest = units.length(kept.lowest, four_digits);
    // The lamp of the par may say it.
    let is_par = |par: &Par| par.quantity == Quantity::RapidityUsed;
    let has_lamp = mission.pars.first().is_some_and(is_par);
    let used = fuel_used(mission, kept).filter(|_| !has_lamp);
    let used = used.map_or_else(String::new, |used| format!("{used}, "));
    format!(
        "your clock {own}{far}\n{used}at most {} g\nlowest point {lowest}, error {:.0e}",
        three_digits(kept.peak_g),
        kept.error
    )
}
