//! What can be wrong with the text of a journey, each in one sentence.

use super::format::{MAX_CAPTIONS, MAX_KEYFRAMES, NAMES};
use crate::scene::error::SceneError;
use crate::scene::presets::PRESETS;
use thiserror::Error;

/// Why a text is not a journey. `origin` is its file; keyframes count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum JourneyError {
    /// The text is not TOML, or of another version.
    #[error(transparent)]
    Text(#[from] SceneError),
    /// A key at the top level that is unknown, or has a value of the wrong type.
    #[error(
        "{origin}: {key} = {given} is refused: a journey has schema = 1, title = \"...\", preset = \"...\", tables [[keyframe]] and tables [[caption]]"
    )]
    Top {
        origin: String,
        key: String,
        given: String,
    },
    /// A preset that is not one of the built-in ones.
    #[error(
        "{origin}: preset = {given} is refused: it must be the name or the number of a built-in preset: {}",
        preset_names()
    )]
    Preset { origin: String, given: String },
    /// Too few or too many keyframes.
    #[error(
        "{origin}: a journey has from 2 to {MAX_KEYFRAMES} tables [[keyframe]], and this one has {count}"
    )]
    Count { origin: String, count: usize },
    /// A keyframe without a time, or with one that is not after the time before.
    #[error("{origin}: keyframe {number}: time = {given} is refused: it must be {allowed}")]
    Time {
        origin: String,
        number: usize,
        given: String,
        allowed: String,
    },
    /// A keyframe with an unknown key.
    #[error(
        "{origin}: keyframe {number}: there is no {key}; a keyframe has time, any of {}, and a table rain of those but \
             the observer and the disk's own, for an observer that falls from rest at infinity",
        names()
    )]
    UnknownKey {
        origin: String,
        number: usize,
        key: String,
    },
    /// A value of the wrong type or out of range.
    #[error("{origin}: keyframe {number}: {key} = {given} is refused: it must be {allowed}")]
    Value {
        origin: String,
        number: usize,
        key: &'static str,
        given: String,
        allowed: String,
    },
    /// Too many captions.
    #[error(
        "{origin}: a journey has at most {MAX_CAPTIONS} tables [[caption]], and this one has {count}"
    )]
    CaptionCount { origin: String, count: usize },
    /// A caption with an unknown key.
    #[error("{origin}: caption {number}: there is no {key}; a caption has time, seconds and text")]
    CaptionKey {
        origin: String,
        number: usize,
        key: String,
    },
    /// A value of a caption that is missing, of the wrong type or out of range.
    #[error("{origin}: caption {number}: {key} = {given} is refused: it must be {allowed}")]
    Caption {
        origin: String,
        number: usize,
        key: &'static str,
        given: String,
        allowed: String,
    },
}

fn preset_names() -> String {
    PRESETS
        .map(|preset| format!("{} {}", preset.number, preset.name))
        .join(", ")
}

fn names() -> String {
    NAMES.map(|(name, _)| name).join(", ")
}
