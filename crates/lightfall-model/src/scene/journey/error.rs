//! What can be wrong with the text of a journey, each in one sentence.

use super::format::{MAX_CAPTIONS, MAX_KEYFRAMES, MAX_STOPS, NAMES};
use crate::scene::error::SceneFault;
use crate::scene::key_line::{Place, line_of};
use crate::scene::located::Located;
use crate::scene::nearest_name;
use crate::scene::presets::numbered_names;
use crate::scene::toml_fault::one_table;
use std::fmt;
use thiserror::Error;

/// Why a text is not a journey. Its sentence is that of the first fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JourneyError {
    /// The journey's file.
    origin: String,
    /// What is wrong with keyframes, captions and stops, in this order: at least one fault.
    faults: Vec<Located<Fault>>,
}

impl JourneyError {
    /// The error of a text with these faults.
    pub(super) fn new(origin: &str, text: &str, faults: Vec<Fault>) -> Self {
        let located = |fault: Fault| {
            let line = fault.place().and_then(|place| line_of(text, place));
            Located { line, what: fault }
        };
        Self {
            origin: origin.into(),
            faults: faults.into_iter().take(MAX_FAULTS).map(located).collect(),
        }
    }

    /// The same error of a text that nobody reads.
    pub(super) fn without_lines(mut self) -> Self {
        for located in &mut self.faults {
            located.line = None;
        }
        self
    }

    /// One sentence for each fault.
    pub fn sentences(&self) -> Vec<String> {
        let said = |located: &Located<Fault>| format!("{}: {located}", self.origin);
        self.faults.iter().map(said).collect()
    }
}

impl std::error::Error for JourneyError {}

impl fmt::Display for JourneyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.faults.first() {
            Some(first) => write!(f, "{}: {first}", self.origin),
            None => write!(f, "{}: is no journey", self.origin),
        }
    }
}

/// The most faults of a text that are told.
const MAX_FAULTS: usize = 20;

/// What a journey has at the top level.
const TOP: &str =
    "schema = 1, title, teaches, ending, preset, and tables [[keyframe]], [[caption]] and [[stop]]";

/// The keys of the top level.
const TOP_KEYS: [&str; 8] = [
    "schema", "title", "teaches", "ending", "preset", "keyframe", "caption", "stop",
];

/// The keys of a caption.
const CAPTION_KEYS: [&str; 3] = ["time", "seconds", "text"];

/// What is wrong with the text of a journey. Keyframes, captions and stops count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// The text is not TOML, or of another version.
    #[error(transparent)]
    Text(#[from] SceneFault),
    /// A key at the top level that is unknown, or has a value of the wrong type.
    #[error("{key} = {given} is refused: {}a journey has {TOP}", meant(key, &TOP_KEYS))]
    Top { key: String, given: String },
    /// A single table where there must be a list of them.
    #[error("{}", one_table(key))]
    OneTable { key: String },
    /// A key at the top level that is a field of scenes, or a table of them.
    #[error("{key} belongs to a preset, and this must be a journey, which has {TOP}")]
    FieldOfScenes { key: String },
    /// A text at the top level that is no line.
    #[error("{key} = {given} is refused: it must be {allowed}")]
    Line {
        key: &'static str,
        given: String,
        allowed: String,
    },
    /// A preset that is not one of the built-in ones.
    #[error(
        "preset = {given} is refused: it must be the name or the number of a built-in preset: {}",
        numbered_names()
    )]
    Preset { given: String },
    /// Too few or too many keyframes.
    #[error(
        "a journey has from 2 to {MAX_KEYFRAMES} tables [[keyframe]], and this one has {count}"
    )]
    Count { count: usize },
    /// A keyframe with an unknown key.
    #[error(
        "keyframe {number}: there is no {key}; {}a keyframe has time, ease, a table set of other fields of the \
             scene, any of {}, and a table rain of those but the observer and the disk's own, for an observer that \
             falls from rest at infinity",
        meant(key, &keyframe_keys()),
        names()
    )]
    UnknownKey { number: usize, key: String },
    /// A key of the table `set` that is no field, or one that no keyframe sets.
    #[error("keyframe {number}: {key} is refused: {why}")]
    SetKey {
        number: usize,
        /// With the table's name before it.
        key: String,
        why: String,
    },
    /// A value of the table `set` that its field cannot have.
    #[error("keyframe {number}: {key} = {given} is refused: it must be {allowed}")]
    SetValue {
        number: usize,
        /// With the table's name before it.
        key: String,
        given: String,
        allowed: String,
    },
    /// Too many captions.
    #[error("a journey has at most {MAX_CAPTIONS} tables [[caption]], and this one has {count}")]
    CaptionCount { count: usize },
    /// A caption with an unknown key.
    #[error(
        "caption {number}: there is no {key}; {}a caption has time, seconds and text",
        meant(key, &CAPTION_KEYS)
    )]
    CaptionKey { number: usize, key: String },
    /// Too many stops.
    #[error("a journey has at most {MAX_STOPS} tables [[stop]], and this one has {count}")]
    StopCount { count: usize },
    /// A stop with an unknown key, or with one that no stop switches.
    #[error(
        "stop {number}: there is no {key}; {hint}; a stop has at, caption, guides, side_by_side, inspector, question, and \
             fields of the scene such as view or effects.doppler"
    )]
    StopKey {
        number: usize,
        key: String,
        hint: String,
    },
    /// A value of a keyframe, a caption or a stop that is missing, of the wrong type or out of range.
    #[error("{table} {number}: {}", refusal(key, given.as_deref(), allowed))]
    Value {
        table: &'static str,
        number: usize,
        key: &'static str,
        /// None where the key is missing.
        given: Option<String>,
        allowed: String,
    },
}

impl Fault {
    /// Where the fault is. None for one of the whole text.
    fn place(&self) -> Option<Place<'_>> {
        match self {
            Self::Text(SceneFault::Schema { .. }) => Some((None, "schema")),
            Self::Text(_)
            | Self::Count { .. }
            | Self::CaptionCount { .. }
            | Self::StopCount { .. } => None,
            Self::Top { key, .. } | Self::OneTable { key } | Self::FieldOfScenes { key } => {
                Some((None, key.as_str()))
            }
            Self::Line { key, .. } => Some((None, *key)),
            Self::Preset { .. } => Some((None, "preset")),
            Self::UnknownKey { number, key }
            | Self::SetKey { number, key, .. }
            | Self::SetValue { number, key, .. } => {
                Some((Some(("keyframe", *number)), key.as_str()))
            }
            Self::CaptionKey { number, key } => Some((Some(("caption", *number)), key.as_str())),
            Self::StopKey { number, key, .. } => Some((Some(("stop", *number)), key.as_str())),
            Self::Value {
                table, number, key, ..
            } => Some((Some((*table, *number)), *key)),
        }
    }
}

fn refusal(key: &str, given: Option<&str>, allowed: &str) -> String {
    match given {
        Some(given) => format!("{key} = {given} is refused: it must be {allowed}"),
        None => format!("{key} is missing: it must be {allowed}"),
    }
}

fn names() -> String {
    NAMES.map(|(name, _)| name).join(", ")
}

/// The keys of a keyframe.
fn keyframe_keys() -> Vec<&'static str> {
    let own = ["time", "ease", "set", "rain"].into_iter();
    own.chain(NAMES.map(|(name, _)| name)).collect()
}

/// The part of a sentence that says which name was probably meant by an unknown one. Empty if none was.
pub(super) fn meant(name: &str, known: &[&str]) -> String {
    let is_known = known.contains(&name);
    match nearest_name(name, known).filter(|_| !is_known) {
        Some(meant) => format!("did you mean {meant}?; "),
        None => String::new(),
    }
}
