//! Which instruments a mission needs, and how many a flight has.

use super::quantities::{named, present, said_by};
use super::values::{FUEL, Instrument, LIFE, TIME};
use crate::app::motion::ship::quantity_name;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::Attempt;
use lightfall_core::scene::mission::Quantity;

/// Instruments that show a quantity of a mission, by their labels. The clocks are dials.
fn shown_by(quantity: Quantity) -> Option<&'static str> {
    Some(match quantity {
        Quantity::R | Quantity::Speed => "radius, speed",
        Quantity::RapidityUsed => FUEL,
        Quantity::Thrust | Quantity::GLoad => "thrust",
        Quantity::Periapsis => "lowest point",
        Quantity::Apoapsis => "highest point",
        Quantity::Tide => "tide",
        Quantity::Tau | Quantity::T | Quantity::Rate => "",
        _ => return None,
    })
}

/// Adds the quantities that the mission names and that no other instrument shows.
pub(super) fn add_named(all: &mut Vec<Instrument>, attempt: &Attempt, units: Units) {
    let others = named(&attempt.mission)
        .into_iter()
        .filter(|quantity| shown_by(*quantity).is_none());
    let rows = others.map(|quantity| Instrument {
        is_needed: true,
        ..Instrument::new(quantity_name(quantity), present(attempt, quantity, units))
    });
    // Before those that a narrow window leaves out.
    let end = all.iter().position(|row| row.is_minor);
    let end = end.unwrap_or(all.len());
    drop(all.splice(end..end, rows));
}

/// By which words a text for players names an instrument.
const NAMED_BY: [(&str, &[&str]); 9] = [
    (FUEL, &["rapidity", "fuel", "tank"]),
    ("thrust", &["thrust", "engine"]),
    ("lowest point", &["lowest point"]),
    ("highest point", &["highest point"]),
    (LIFE, &["life left"]),
    ("nose", &["nose"]),
    ("held", &["hold"]),
    ("to stand still", &["stand still"]),
    ("tide", &["tide"]),
];

/// What a ship without a mission needs: the pace, where it is, its fuel, and its path.
const NEEDED: [&str; 7] = [
    TIME,
    "radius, speed",
    FUEL,
    "thrust",
    "lowest point",
    "highest point",
    LIFE,
];

/// Notes which instruments the smallest window shows: those that the mission names in a condition or in a
/// text, the radius, and the pace.
pub(super) fn note_needed(all: &mut [Instrument], attempt: Option<&Attempt>) {
    let Some(attempt) = attempt else {
        for row in all {
            row.is_needed = NEEDED.contains(&row.label);
        }
        return;
    };
    let mission = &attempt.mission;
    let compared = named(mission).into_iter().filter_map(shown_by);
    let mut labels: Vec<&str> = compared.chain(["radius, speed", TIME]).collect();
    let texts: Vec<String> = said_by(mission).map(str::to_lowercase).collect();
    let said = NAMED_BY
        .into_iter()
        .filter(|(_, words)| {
            let is_in = |text: &String| words.iter().any(|word| text.contains(word));
            texts.iter().any(is_in)
        })
        .map(|(label, _)| label);
    labels.extend(said);
    for row in all {
        row.is_needed |= labels.contains(&row.label);
    }
}

/// The instruments that a flight has at one time or another, and whether they are minor. Those that a mission
/// names besides come after them.
const ROWS: [(&str, bool); 12] = [
    ("radius, speed", false),
    (FUEL, false),
    ("thrust", false),
    ("lowest point", false),
    ("highest point", false),
    (LIFE, false),
    ("nose", false),
    ("held", false),
    (TIME, false),
    ("to stand still", true),
    ("tide", true),
    ("signal home", true),
];

/// The most instruments that a flight has at a time, from its beginning to its end: all of them, those that
/// are not minor, and those that are needed.
#[must_use]
pub fn most_rows(attempt: Option<&Attempt>, units: Units) -> [usize; 3] {
    let row = |(label, is_minor): (&'static str, bool)| Instrument {
        is_minor,
        ..Instrument::new(label, String::new())
    };
    let mut rows: Vec<Instrument> = ROWS.into_iter().map(row).collect();
    if let Some(attempt) = attempt {
        add_named(&mut rows, attempt, units);
    }
    note_needed(&mut rows, attempt);
    let needed = |labels: &[&str]| {
        let named = rows.iter().filter(|row| labels.contains(&row.label));
        named.filter(|row| row.is_needed).count()
    };
    let [points, life] = [&["lowest point", "highest point"][..], &[LIFE]].map(needed);
    let main = rows.iter().filter(|row| !row.is_minor || row.is_needed);
    let all_needed = rows.iter().filter(|row| row.is_needed).count();
    // The life that is left and the turning points are never shown together.
    [
        rows.len() - 1,
        main.count() - 1,
        all_needed - points.min(life),
    ]
}
