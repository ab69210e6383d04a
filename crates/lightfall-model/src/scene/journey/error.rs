//! What can be wrong with the text of a journey, each in one sentence.

use super::format::{MAX_CAPTIONS, MAX_KEYFRAMES, MAX_STOPS, NAMES};
use crate::scene::error::SceneFault;
use crate::scene::presets::numbered_names;
use thiserror::Error;

/// Why a text is not a journey.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{origin}: {fault}")]
pub struct JourneyError {
    /// The journey's file.
    pub origin: String,
    /// What is wrong.
    pub fault: Fault,
}

/// What a journey has at the top level.
const TOP: &str =
    "schema = 1, title, teaches, ending, preset, and tables [[keyframe]], [[caption]] and [[stop]]";

/// What is wrong with the text of a journey. Keyframes, captions and stops count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// The text is not TOML, or of another version.
    #[error(transparent)]
    Text(#[from] SceneFault),
    /// A key at the top level that is unknown, or has a value of the wrong type.
    #[error("{key} = {given} is refused: a journey has {TOP}")]
    Top { key: String, given: String },
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
        "keyframe {number}: there is no {key}; a keyframe has time, any of {}, and a table rain of those but \
             the observer and the disk's own, for an observer that falls from rest at infinity",
        names()
    )]
    UnknownKey { number: usize, key: String },
    /// Too many captions.
    #[error("a journey has at most {MAX_CAPTIONS} tables [[caption]], and this one has {count}")]
    CaptionCount { count: usize },
    /// A caption with an unknown key.
    #[error("caption {number}: there is no {key}; a caption has time, seconds and text")]
    CaptionKey { number: usize, key: String },
    /// Too many stops.
    #[error("a journey has at most {MAX_STOPS} tables [[stop]], and this one has {count}")]
    StopCount { count: usize },
    /// A stop with an unknown key, or with one that no stop switches.
    #[error(
        "{}stop {number}: there is no {key}; {hint}; a stop has at, caption, guides, side_by_side, inspector, question, and \
             fields of the scene such as view or effects.doppler",
        line.map_or_else(String::new, |line| format!("line {line}: "))
    )]
    StopKey {
        line: Option<usize>,
        number: usize,
        key: String,
        hint: String,
    },
    /// A value of a keyframe, a caption or a stop that is missing, of the wrong type or out of range.
    #[error("{table} {number}: {key} = {given} is refused: it must be {allowed}")]
    Value {
        table: &'static str,
        number: usize,
        key: &'static str,
        given: String,
        allowed: String,
    },
}

fn names() -> String {
    NAMES.map(|(name, _)| name).join(", ")
}
