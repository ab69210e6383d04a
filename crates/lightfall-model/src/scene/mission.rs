//! A mission: a flight with goals for a ship with an engine. Plain data.
//!
//! A mission starts from a built-in preset with another hole and another observer. Its goals are
//! conditions on physical quantities, in order. docs/FLIGHT.md gives the equations of the flight.

mod condition;
mod error;
mod keys;
mod load;
mod text;

pub use condition::{Comparison, Condition, Quantity};
pub use error::MissionError;
pub use keys::MissionKey;
pub use load::load;
pub use text::{
    Better, Burn, Caption, Course, Ending, Face, Fail, Goal, Hint, HoleOfMission, Look, Par, Push,
    Ship, Start, Until,
};

use super::Scene;
use super::presets::Preset;
use super::question::Question;

/// A mission.
#[derive(Clone, Debug, PartialEq)]
pub struct Mission {
    /// Its name: letters, digits and hyphens.
    pub name: String,
    /// One line for lists.
    pub title: String,
    /// The preset that it starts from.
    pub preset: &'static Preset,
    /// The hole.
    pub hole: HoleOfMission,
    /// The ship.
    pub ship: Ship,
    /// Where and how the ship starts.
    pub start: Start,
    /// What to do, in one or two sentences.
    pub brief: String,
    /// What a teacher can show with it.
    pub teaches: String,
    /// The keys that the card at the start lists. `None` for the usual ones.
    pub keys: Option<Vec<MissionKey>>,
    /// What to reach, in order.
    pub goals: Vec<Goal>,
    /// What ends the mission without success.
    pub fails: Vec<Fail>,
    /// What to say on the way.
    pub captions: Vec<Caption>,
    /// What to say after failed attempts.
    pub hints: Vec<Hint>,
    /// What to ask a class.
    pub questions: Vec<Question>,
    /// What a good flight needs.
    pub pars: Vec<Par>,
    /// What the card at the end says.
    pub ending: Ending,
    /// How to reach the goals. Tests fly it, and players never see it.
    pub solution: Vec<Burn>,
    scene: Scene,
}

impl Mission {
    /// The scene in which the ship starts, facing the hole.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Everything that players read.
    pub fn texts(&self) -> Vec<&String> {
        let mut texts = vec![
            &self.title,
            &self.brief,
            &self.teaches,
            &self.ending.success,
            &self.ending.failure,
        ];
        texts.extend(self.goals.iter().map(|goal| &goal.text));
        texts.extend(self.fails.iter().map(|fail| &fail.text));
        texts.extend(self.captions.iter().map(|caption| &caption.text));
        texts.extend(self.hints.iter().map(|hint| &hint.text));
        let questions = self.questions.iter();
        texts.extend(questions.flat_map(Question::texts));
        texts
    }
}

/// Whether a text is meant as a mission, and not as a preset: it has a table that only missions have, or the
/// head of one with a bracket too few.
pub fn is_mission(text: &str) -> bool {
    const TABLES: [&str; 5] = ["[[goal]", "[goal]", "[ending]", "[[solution]", "[solution]"];
    text.lines().any(|line| {
        TABLES
            .iter()
            .any(|table| line.trim_start().starts_with(table))
    })
}

/// The built-in mission with this name.
pub fn built_in(name: &str) -> Option<Mission> {
    let (name, text) = MISSIONS.into_iter().find(|(known, _)| *known == name)?;
    load(name, text).ok()
}

macro_rules! missions {
    ($($name:literal),* $(,)?) => {
        [$((
            $name,
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/missions/", $name, ".toml")),
        )),*]
    };
}

/// Names and texts of the built-in missions, part of the program itself, in the order in which they
/// are offered.
pub const MISSIONS: [(&str, &str); 8] = missions![
    "two-burns",
    "weight",
    "gyroscope",
    "graze",
    "ten-years",
    "sample",
    "penrose",
    "longest",
];
