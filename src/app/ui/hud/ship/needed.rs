//! Which instruments a mission needs, and how many a flight has.

use super::quantities::{named, said_by};
use super::values::{FUEL, Instrument, LIFE, TIME};
use crate::app::motion::ship::quantity_name;
use lightfall_core::scene::mission::{Mission, Quantity};

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

/// What a flight needs of the instruments. It follows from the texts and conditions of the mission.
#[derive(Clone, Debug)]
pub(super) struct Needed {
    /// The labels of what the smallest window shows: what the mission names in a condition or in a text, the
    /// radius, and the pace.
    labels: Vec<&'static str>,
    /// The quantities that the mission names and that no other instrument shows.
    others: Vec<Quantity>,
}

impl Needed {
    /// What a flight needs, in a mission or without one.
    pub(super) fn of(mission: Option<&Mission>) -> Self {
        let Some(mission) = mission else {
            return Self {
                labels: NEEDED.to_vec(),
                others: Vec::new(),
            };
        };
        let named = named(mission);
        let compared = named.iter().copied().filter_map(shown_by);
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
        let others = named
            .into_iter()
            .filter(|quantity| shown_by(*quantity).is_none());
        Self {
            labels,
            others: others.collect(),
        }
    }

    /// Adds the quantities that no other instrument shows, and notes what the smallest window shows.
    pub(super) fn complete(&self, all: &mut Vec<Instrument>, value: impl Fn(Quantity) -> String) {
        let rows = self.others.iter().map(|quantity| Instrument {
            is_needed: true,
            ..Instrument::new(quantity_name(*quantity), value(*quantity))
        });
        // Before those that a narrow window leaves out.
        let end = all.iter().position(|row| row.is_minor);
        let end = end.unwrap_or(all.len());
        drop(all.splice(end..end, rows));
        for row in all {
            row.is_needed |= self.labels.contains(&row.label);
        }
    }

    /// See [`most_rows`].
    pub(super) fn most_rows(&self) -> [usize; 3] {
        let row = |(label, is_minor): (&'static str, bool)| Instrument {
            is_minor,
            ..Instrument::new(label, String::new())
        };
        let mut rows: Vec<Instrument> = ROWS.into_iter().map(row).collect();
        self.complete(&mut rows, |_| String::new());
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
}

/// What the flight of the last frame needs, with its mission, whose texts are not read in every frame.
#[derive(Default)]
pub(in crate::app::ui::hud) struct KnownNeeds(Option<(Option<Mission>, Needed)>);

impl KnownNeeds {
    /// What a flight needs, in this mission or without one.
    pub(super) fn of(&mut self, mission: Option<&Mission>) -> &Needed {
        self.0.take_if(|(known, _)| known.as_ref() != mission);
        let (_, needed) = self
            .0
            .get_or_insert_with(|| (mission.cloned(), Needed::of(mission)));
        needed
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
pub fn most_rows(mission: Option<&Mission>) -> [usize; 3] {
    Needed::of(mission).most_rows()
}
