//! What is wrong with a text in TOML, in words for people who know nothing of TOML.
//!
//! The parser says which token it expects next. The author of a preset or a lesson needs to know what is
//! wrong and what was probably meant, so each common mistake has a sentence of its own, and the parser's
//! messages are not shown.

mod head;
mod scalar;
mod syntax;
mod tokens;
mod types;

pub(in crate::scene) use head::one_table;

use super::located::{Located, line_number};
use thiserror::Error;
use toml::de::{self, DeTable};

/// Why a text is not TOML, or lacks the fields that its reader asks for.
///
/// Its sentence says what was given, and what is allowed or meant.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct TomlFault(Located<String>);

impl TomlFault {
    /// The fault of a `text` that was read with this `error`.
    pub fn new(text: &str, error: &de::Error) -> Self {
        match DeTable::parse(text) {
            Ok(document) => types::told(text, document.get_ref(), error),
            Err(error) => syntax::told(text, &error),
        }
    }

    /// A fault at this place of the text.
    fn at(text: &str, at: usize, said: String) -> Self {
        Self(Located {
            line: Some(line_number(text, at)),
            what: said,
        })
    }
}

/// A part of a text between backticks, as a sentence quotes it.
fn shown(part: &str) -> String {
    format!("`{}`", first_line(part))
}

/// The first line of a part of a text, if that is not too long.
fn first_line(part: &str) -> String {
    const MAX_CHARS: usize = 60;
    let mut lines = part.trim().lines();
    let first = lines.next().unwrap_or_default().trim_end();
    let printed = || first.chars().filter(|c| !c.is_control());
    let mut short: String = printed().take(MAX_CHARS).collect();
    if printed().count() > MAX_CHARS || lines.next().is_some() {
        short.push_str("...");
    }
    short
}
