//! The names of keys in sentences, and in texts of missions and lessons.

use super::bindings::{Bindable, BindingTable, Bindings};
use super::table::{CONTROLS, control_named};
use lightfall_core::scene::nearest_name;

impl<B: Bindable> BindingTable<B> {
    /// The name of the first input of the control with this name, as a sentence has it: a punctuation
    /// mark in quotes, since it would otherwise be read as one. Empty as [`label`](Self::label) is.
    #[must_use]
    pub fn first_label(&self, id: &str) -> String {
        let name = self.first_name(id);
        let is_mark = !name.is_empty() && name.chars().all(|c| c.is_ascii_punctuation());
        if is_mark { format!("\"{name}\"") } else { name }
    }

    /// The name of the first input of the control with this name, where it stands as a key by itself.
    /// Empty as [`label`](Self::label) is.
    #[must_use]
    pub fn first_name(&self, id: &str) -> String {
        // A comma may be a key itself.
        let names = self.label(id);
        names.split(", ").next().unwrap_or_default().to_owned()
    }
}

impl Bindings {
    /// A text in which the name of a control in braces, such as `{fly.forward}`, stands for its key.
    #[must_use]
    pub fn with_keys(&self, text: &str) -> String {
        let mut parts = text.split('{');
        let mut words = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            match part.split_once('}') {
                Some((id, after)) if control_named(id).is_some() => {
                    words += &self.first_label(id);
                    words += after;
                }
                _ => {
                    words.push('{');
                    words += part;
                }
            }
        }
        words
    }
}

/// A sentence for each name in braces in these texts that no control has.
#[must_use]
pub fn unknown_controls<'a>(texts: impl IntoIterator<Item = &'a String>) -> Vec<String> {
    let names: Vec<String> = CONTROLS.iter().map(|control| control.id.into()).collect();
    let in_braces = texts.into_iter().flat_map(|text| {
        let parts = text.split('{').skip(1);
        parts.filter_map(|part| part.split_once('}').map(|(name, _)| name))
    });
    let unknown = in_braces.filter(|name| control_named(name).is_none());
    unknown
        .map(|name| {
            // The group before the point is easily forgotten.
            let in_group = |id: &&String| id.split_once('.').is_some_and(|(_, end)| end == name);
            let meant = names.iter().find(in_group).cloned();
            let sentence = format!("there is no control {{{name}}}, and the text keeps its braces");
            match meant.or_else(|| nearest_name(name, &names)) {
                Some(meant) => format!("{sentence}; did you mean {{{meant}}}?"),
                None => sentence,
            }
        })
        .collect()
}
