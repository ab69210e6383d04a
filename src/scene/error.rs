//! What can be wrong with a scene, each in one sentence.

use thiserror::Error;

/// A value that a scene cannot have.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{key} = {given} is refused: it must be {allowed}{}", in_brackets(.because))]
pub struct Refusal {
    /// The field.
    pub key: &'static str,
    /// Its value, as it was given.
    pub given: String,
    /// What it may be, in words.
    pub allowed: String,
    /// The other field that decides the range, and why; none where the range stands alone.
    pub because: Option<Because>,
}

/// Why a range depends on another field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Because {
    /// The other field.
    pub key: &'static str,
    /// The reason in words, e.g. `disk.outer is 11`.
    pub reason: String,
}

fn in_brackets(because: &Option<Because>) -> String {
    because.as_ref().map(|because| format!(" ({})", because.reason)).unwrap_or_default()
}

/// Why a preset, with what overrides it, does not make a scene. `origin` is where the fault was written: a file, a
/// preset or an option of the command line.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SceneError {
    /// The text is not TOML.
    #[error("{origin}: line {line}, column {column}: {message}")]
    Syntax {
        /// Where it was written.
        origin: String,
        /// Line, from 1.
        line: usize,
        /// Column in characters, from 1.
        column: usize,
        /// What the TOML reader says.
        message: String,
    },
    /// The preset was written for another version of the format.
    #[error("{origin}: schema = {given} is another version of the preset format; this program reads schema 1")]
    Schema {
        /// Where it was written.
        origin: String,
        /// The version.
        given: String,
    },
    /// No field has this name.
    #[error("{origin}: there is no field {key}; {hint}")]
    UnknownKey {
        /// Where it was written.
        origin: String,
        /// The name.
        key: String,
        /// What was probably meant.
        hint: String,
    },
    /// A table of fields was treated as a field, or the other way round.
    #[error("{origin}: {key} = {given} is refused: {key} is a table of fields, such as {example}")]
    NotAField {
        /// Where it was written.
        origin: String,
        /// The table.
        key: String,
        /// What it was given.
        given: String,
        /// One of its fields.
        example: &'static str,
    },
    /// An assignment without an equals sign.
    #[error("--set: {given} is not of the form KEY=VALUE, such as camera.r=20")]
    NotAnAssignment {
        /// What was given.
        given: String,
    },
    /// A value of the wrong type or out of range.
    #[error("{origin}: {refusal}")]
    Refused {
        /// Where it was written.
        origin: String,
        /// The value and what is allowed.
        refusal: Box<Refusal>,
    },
}
