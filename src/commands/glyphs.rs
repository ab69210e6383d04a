//! What the window cannot show of a file's texts.

use crate::app::lacking;
use lightfall_platform::fonts::{SystemFonts, is_right_to_left, missing_sentence};
use lightfall_platform::log::say;
use std::fmt::Display;

/// Largest number of characters that a sentence lists.
const MAX_LISTED: usize = 8;

/// Says which characters of these texts no font has, and which order of words is wrong. `origin`
/// names their file.
pub(super) fn note_lacking<'a>(origin: impl Display, texts: impl IntoIterator<Item = &'a String>) {
    let texts: Vec<&str> = texts.into_iter().map(String::as_str).collect();
    let lacking = lacking(&texts);
    if lacking.is_empty() {
        return;
    }
    let missing = SystemFonts::open().find(&lacking).missing;
    if let Some(sentence) = missing_sentence(&missing, MAX_LISTED, written) {
        say(format_args!("lightfall: {origin}: {sentence}"));
    }
    let is_disordered = |text: &&&str| {
        let words = text.split_whitespace();
        words.filter(|word| word.contains(is_right_to_left)).count() > 1
    };
    if let Some(text) = texts.iter().find(is_disordered) {
        say(format_args!(
            "lightfall: {origin}: the window puts words of right-to-left text in order from left to right, as in \
             \"{text}\"; a text of one such word is right"
        ));
    }
}

/// A letter, or the number of a character that does not stand alone.
fn written(character: char) -> String {
    if character.is_alphanumeric() {
        character.into()
    } else {
        format!("U+{:04X}", u32::from(character))
    }
}
