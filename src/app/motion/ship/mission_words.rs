//! What the window says of a mission.

use crate::app::state::end_card::Way;
use crate::app::state::mission_results::MissionResult;
use lightfall_core::numbers::{four_digits, three_digits};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Attempt, Outcome};
use lightfall_core::scene::mission::{Goal, Mission, MissionKey};

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

/// A goal in words.
fn goal_words(goal: &Goal, units: Units) -> String {
    match goal.hold {
        0.0 => goal.text.clone(),
        hold => format!("{} (for {})", goal.text, units.time(hold, four_digits)),
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
    format!(
        "{par}your clock {own}{far}\nrapidity {}, at most {} g\nlowest point {lowest}, error {:.0e}",
        four_digits(kept.rapidity_used),
        three_digits(kept.peak_g),
        kept.error
    )
}
