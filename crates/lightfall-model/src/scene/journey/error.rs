//! What can be wrong with the text of a journey, each in one sentence.

use super::format::{MAX_CAPTIONS, MAX_KEYFRAMES, NAMES};
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

/// What is wrong with the text of a journey. Keyframes and captions count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// The text is not TOML, or of another version.
    #[error(transparent)]
    Text(#[from] SceneFault),
    /// A key at the top level that is unknown, or has a value of the wrong type.
    #[error(
        "{key} = {given} is refused: a journey has schema = 1, title = \"...\", ending = \"...\", preset = \"...\", tables [[keyframe]] and tables [[caption]]"
    )]
    Top { key: String, given: String },
    /// A key at the top level that is a field of scenes, or a table of them.
    #[error(
        "{key} belongs to a preset, and this must be a journey, which has schema = 1, title = \"...\", ending = \"...\", preset = \"...\", tables [[keyframe]] and tables [[caption]]"
    )]
    FieldOfScenes { key: String },
    /// An ending that is no line of text.
    #[error("ending = {given} is refused: it must be {allowed}")]
    Ending { given: String, allowed: String },
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
    /// A value of a keyframe or a caption that is missing, of the wrong type or out of range.
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
