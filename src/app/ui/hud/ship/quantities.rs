//! The quantities that a mission compares, in words: their values, and what is wanted.

use crate::app::motion::ship::{Measures, quantity_name};
use lightfall_core::geometry::ship::Ship;
use lightfall_core::numbers::{four_digits, steady_digits};
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Apsides, Attempt, Outcome};
use lightfall_core::scene::mission::{Comparison, Condition, Mission, Quantity};

/// A quantity of the next goal or of what ends a mission.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// Its name.
    pub label: &'static str,
    /// Its present value with its unit.
    pub value: String,
    /// What it has to be, and what it must not be.
    pub wanted: String,
    /// Whether it is what it has to be.
    pub is_met: bool,
}

/// The quantities of the next goal and of what ends the mission, each with what is wanted of it. Empty once
/// the mission is over.
#[must_use]
pub fn wanted(attempt: &Attempt, units: Units) -> Vec<Wanted> {
    let Outcome::UnderWay(next) = attempt.outcome() else {
        return Vec::new();
    };
    let mission = &attempt.mission;
    let measures = Measures::new(mission, units);
    let goal = mission.goals.get(next).map_or(&[][..], |goal| &goal.all);
    let mut rows: Vec<(Quantity, Vec<String>, bool)> = Vec::new();
    let mut add = |condition: &Condition, words: String, is_met: bool| {
        let quantity = condition.quantity;
        match rows.iter_mut().find(|row| row.0 == quantity) {
            Some(row) => {
                row.1.push(words);
                row.2 &= is_met;
            }
            None => rows.push((quantity, vec![words], is_met)),
        }
    };
    let holds = |condition: &Condition| {
        let value = attempt.voyage().quantity(condition.quantity);
        condition.holds(value)
    };
    for condition in goal {
        add(condition, bound(condition, measures), holds(condition));
    }
    for fail in &mission.fails {
        // A fail of several conditions forbids none of them alone.
        let not = if fail.all.len() == 1 {
            "not"
        } else {
            "not together"
        };
        // Far from a limit it is only in the way.
        let voyage = attempt.voyage();
        let is_near = |condition: &Condition| near(condition, voyage.quantity(condition.quantity));
        if !fail.all.iter().all(is_near) {
            continue;
        }
        for condition in &fail.all {
            let words = format!("{not} {}", bound(condition, measures));
            add(condition, words, fail.all.len() > 1 || !holds(condition));
        }
    }
    let row = |(quantity, wanted, is_met): (Quantity, Vec<String>, bool)| Wanted {
        label: quantity_name(quantity),
        value: present(attempt, quantity, units),
        wanted: wanted.join(", "),
        is_met,
    };
    rows.into_iter().map(row).collect()
}

/// Whether a value meets a condition, or comes within a factor of 1.5 of what it compares with.
fn near(condition: &Condition, value: Option<f64>) -> bool {
    let limit = condition.value;
    value.is_some_and(|value| match condition.comparison {
        Comparison::Less | Comparison::AtMost => value <= limit + 0.5 * limit.abs(),
        Comparison::More | Comparison::AtLeast => value >= limit - limit.abs() / 3.0,
        Comparison::Equal => true,
    })
}

/// Whether the path of a ship leads into the hole without a highest point before.
pub(super) fn plunges(ship: &Ship) -> bool {
    let apsides = Apsides::of(ship);
    let falls = ship.constants().radial < 0.0;
    falls && apsides.periapsis.is_none() && apsides.apoapsis.is_none()
}

/// The value of a quantity now.
pub(super) fn present(attempt: &Attempt, quantity: Quantity, units: Units) -> String {
    let voyage = attempt.voyage();
    match voyage.quantity(quantity) {
        None => "not known here".into(),
        Some(0.0) if quantity == Quantity::Periapsis => "in the hole".into(),
        Some(0.0) if quantity == Quantity::Thrust => "off".into(),
        Some(value) if value.is_infinite() && plunges(&voyage.flight.ship) => {
            "none: you fall in".into()
        }
        Some(value) if value.is_infinite() => "none: you come away".into(),
        Some(value) => {
            Measures::new(&attempt.mission, units).amount(quantity, value, steady_digits)
        }
    }
}

/// The quantities that a mission names in its conditions, its pars and its texts, in the order of their
/// list.
pub(super) fn named(mission: &Mission) -> Vec<Quantity> {
    let goals = mission.goals.iter().flat_map(|goal| &goal.all);
    let fails = mission.fails.iter().flat_map(|fail| &fail.all);
    let captions = mission.captions.iter().flat_map(|caption| &caption.when);
    let pars = mission.pars.iter().map(|par| par.quantity);
    let conditions = goals.chain(fails).chain(captions);
    let compared: Vec<Quantity> = conditions
        .map(|condition| condition.quantity)
        .chain(pars)
        .collect();
    // Letters stand alone in a text.
    let is_said = |quantity: Quantity| {
        let word = quantity.word();
        let mut words = said_by(mission)
            .flat_map(|text| text.split(|c: char| !c.is_alphanumeric() && c != '_'));
        word.len() == 1 && word != "r" && word != "t" && words.any(|said| said == word)
    };
    let all = Quantity::ALL.into_iter();
    all.filter(|quantity| compared.contains(quantity) || is_said(*quantity))
        .collect()
}

/// What a mission says to a pilot in flight, and after a failure.
pub(super) fn said_by(mission: &Mission) -> impl Iterator<Item = &str> {
    let goals = mission.goals.iter().map(|goal| goal.text.as_str());
    let fails = mission.fails.iter().map(|fail| fail.text.as_str());
    let captions = mission.captions.iter().map(|caption| caption.text.as_str());
    let hints = mission.hints.iter().map(|hint| hint.text.as_str());
    goals.chain(fails).chain(captions).chain(hints)
}

/// A condition without its quantity.
fn bound(condition: &Condition, measures: Measures) -> String {
    let Condition {
        quantity,
        comparison,
        value,
    } = *condition;
    // No thrust is that of an engine that is off.
    if quantity == Quantity::Thrust && value == 0.0 {
        match comparison {
            Comparison::Equal | Comparison::AtMost => return "engine off".into(),
            Comparison::More => return "engine on".into(),
            Comparison::Less | Comparison::AtLeast => {}
        }
    }
    let sign = match comparison {
        Comparison::Less => "<",
        Comparison::AtMost => "≤",
        Comparison::More => ">",
        Comparison::AtLeast => "≥",
        Comparison::Equal => "=",
    };
    let value = measures.amount(quantity, value, four_digits);
    format!("{sign} {value}")
}
