//! What can be wrong with a scene, each in one sentence.

use super::fields::field;
use super::key_line::line_of;
use super::located::Located;
use super::range::Kind;
use super::toml_fault::TomlFault;
use crate::numbers::number_with_comma;
use std::fmt;
use thiserror::Error;

/// A value that a scene cannot have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The field.
    pub key: &'static str,
    /// The value that it was given.
    pub given: String,
    /// What it may be, in words.
    pub allowed: String,
    /// The other fields that decide the range, and why; none if no other field does.
    pub because: Option<Because>,
    /// One of those fields with its value, if it was set after the refused field: it is then named
    /// as the cause.
    pub blamed: Option<Box<(&'static str, String)>>,
}

/// Why a range depends on other fields.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Because {
    /// The other fields.
    pub keys: Vec<&'static str>,
    /// The reason in words, e.g. `disk.outer is 11`.
    pub reason: String,
}

impl std::error::Error for Refusal {}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            key,
            given,
            allowed,
            ..
        } = self;
        let blamed = self.blamed.as_deref();
        match blamed {
            None => write!(f, "{key} = {given} is refused: it must be {allowed}")?,
            Some((culprit, its)) => write!(
                f,
                "{culprit} = {its} is refused together with {key} = {given}, which must then be {allowed}"
            )?,
        }
        // The field that narrows the range has been named already, with its value.
        let said = blamed.map(|(culprit, its)| format!("{culprit} is {its}"));
        match &self.because {
            Some(Because { reason, .. }) if Some(reason) != said.as_ref() => {
                write!(f, " ({reason})")
            }
            _ => Ok(()),
        }?;
        match self.meant() {
            Some(meant) => write!(f, "; did you mean {meant}?"),
            None => Ok(()),
        }
    }
}

impl Refusal {
    /// The number that was probably meant by a text with commas.
    fn meant(&self) -> Option<String> {
        let text = self.given.trim_matches('"');
        match field(self.key)?.kind {
            Kind::Float(range) => number_with_comma(text, |number| range.contains(number)),
            Kind::Integer(range) => {
                let allowed = |number: f64| number.fract() == 0.0 && range.contains(number);
                let meant = number_with_comma(text, allowed)?;
                // Nobody writes three decimals of a whole number: 1,000 is 1000.
                let last = meant.rsplit(' ').next()?;
                let whole = last.trim_end_matches('0').strip_suffix('.');
                Some(whole.unwrap_or(last).to_owned())
            }
            // With decimal commas, three numbers read as four to six.
            Kind::Velocity => {
                let count = text.trim_matches(['[', ']']).split(',').count();
                (4..=6)
                    .contains(&count)
                    .then(|| "decimal points, as in 0.5,0,0".into())
            }
            _ => None,
        }
    }
}

/// Why a preset and its overrides do not make a scene.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{origin}: {fault}")]
pub struct SceneError {
    /// Where the fault was written: a file, a preset or an option of the command line.
    origin: String,
    /// What is wrong.
    pub(super) fault: Located<SceneFault>,
}

impl SceneError {
    pub(super) fn new(origin: &str, fault: SceneFault) -> Self {
        Self {
            origin: origin.into(),
            fault: Located {
                line: None,
                what: fault,
            },
        }
    }

    /// The same error with its line, if it is one of the preset with this origin and text.
    pub(super) fn in_text(mut self, origin: &str, text: &str) -> Self {
        let key = self.fault.what.key().filter(|_| self.origin == origin);
        self.fault.line = key.and_then(|key| line_of(text, (None, key)));
        self
    }
}

/// What is wrong with a preset or an override.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum SceneFault {
    /// The text is not TOML, or has fields or values of another kind.
    #[error(transparent)]
    Toml(#[from] TomlFault),
    /// The preset was written for another version of the format.
    #[error(
        "schema = {given} is another version of the preset format; this program reads schema 1"
    )]
    Schema { given: String },
    /// A preset whose tables are all empty.
    #[error("no field has a value; a field is a line such as camera.r = 20")]
    NoField,
    /// No field has this name.
    #[error("there is no field {key}; {hint}")]
    UnknownKey { key: String, hint: String },
    /// A value was given to a table of fields.
    #[error("{key} = {given} is refused: {key} is a table of fields, such as {example}")]
    NotAField {
        key: String,
        given: String,
        example: &'static str,
    },
    /// An assignment without an equals sign.
    #[error("{given} is not of the form KEY=VALUE, such as camera.r=20")]
    NotAnAssignment { given: String },
    /// An override of a field that a mission itself sets.
    #[error("{key} is refused: the mission {title:?} sets it")]
    SetByMission { key: String, title: String },
    /// A value of the wrong type or out of range.
    #[error(transparent)]
    Refused(#[from] Box<Refusal>),
}

impl SceneFault {
    /// The key of the field that it is about, if there is one.
    fn key(&self) -> Option<&str> {
        match self {
            Self::UnknownKey { key, .. } | Self::NotAField { key, .. } => Some(key),
            Self::Schema { .. } => Some("schema"),
            Self::Refused(refusal) => match &refusal.blamed {
                Some(blamed) => Some(blamed.0),
                None => Some(refusal.key),
            },
            Self::Toml(_)
            | Self::NoField
            | Self::NotAnAssignment { .. }
            | Self::SetByMission { .. } => None,
        }
    }
}
