//! What can be wrong with the text of a mission, each in one sentence.

use crate::scene::error::{SceneError, SceneFault};
use crate::scene::key_line::{Place, line_of};
use crate::scene::located::Located;
use crate::scene::presets::numbered_names;
use thiserror::Error;

/// Why a text is not a mission.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{origin}: {fault}")]
pub struct MissionError {
    /// The mission's file.
    origin: String,
    /// What is wrong, with its line if it is a field or a table.
    fault: Located<Box<Fault>>,
}

impl MissionError {
    /// The error of a text with this fault.
    pub(super) fn new(origin: &str, text: &str, fault: Fault) -> Self {
        let line = fault.place().and_then(|place| line_of(text, place));
        Self {
            origin: origin.into(),
            fault: Located {
                line,
                what: Box::new(fault),
            },
        }
    }
}

/// What is wrong with the text of a mission. Tables count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// The text is not TOML, of another version, or has an unknown key or a value of another type.
    #[error(transparent)]
    Text(#[from] SceneFault),
    /// A preset that is not one of the built-in ones.
    #[error(
        "preset = {given:?} is refused: it must be the name or the number of a built-in preset: {}",
        numbered_names()
    )]
    Preset { given: String },
    /// The start is not a scene.
    #[error("the start of the mission is refused: {0}")]
    Start(SceneError),
    /// A number out of range.
    #[error("{key} = {given} is refused: it must be {allowed}")]
    Number {
        key: String,
        given: String,
        allowed: &'static str,
    },
    /// A name or a title that is no line of text.
    #[error("{key} = {given:?} is refused: it must be {allowed}")]
    Line {
        key: String,
        given: String,
        allowed: &'static str,
    },
    /// A key that is listed twice.
    #[error("keys lists {key:?} twice: each key stands there once")]
    KeyTwice { key: &'static str },
    /// A star without a nose that faces it.
    #[error("start.star_deg is refused: it belongs to face = \"star\", and face is {face:?}")]
    Star { face: &'static str },
    /// A table that needs conditions has none.
    #[error("{table} {number} has no condition; it needs all = [\"r <= 1.6\"], for example")]
    NoCondition { table: &'static str, number: usize },
    /// A mission without a goal.
    #[error("a mission needs at least one table [[goal]], with text and all")]
    NoGoal,
    /// A part of a solution with too many or too few of some keys.
    #[error("solution {number} has {found}; it needs exactly one of {needed}")]
    Choice {
        number: usize,
        found: String,
        needed: &'static str,
    },
}

impl Fault {
    /// Where the fault is. None for one of the whole text.
    fn place(&self) -> Option<Place<'_>> {
        match self {
            Self::Text(SceneFault::Schema { .. }) => Some((None, "schema")),
            Self::Text(_) | Self::Start(_) | Self::NoGoal => None,
            Self::Preset { .. } => Some((None, "preset")),
            Self::Number { key, .. } | Self::Line { key, .. } => Some(place_of(key)),
            Self::KeyTwice { .. } => Some((None, "keys")),
            Self::Star { .. } => Some((None, "start.star_deg")),
            Self::NoCondition { table, number } => Some((Some((*table, *number)), "all")),
            Self::Choice { number, needed, .. } => Some((Some(("solution", *number)), *needed)),
        }
    }
}

/// The place that a message names as `ship.exhaust`, `start.star_deg: theta` or `goal 2: hold`.
fn place_of(named: &str) -> Place<'_> {
    let (before, key) = named.split_once(": ").unwrap_or((named, ""));
    let numbered = before.rsplit_once(' ').and_then(|(table, number)| {
        let number = number.parse::<usize>().ok()?;
        Some((table, number))
    });
    match numbered {
        Some(table) => (Some(table), key),
        None => (None, before),
    }
}
