//! WGSL text joined from constants and files.

use super::fault::ShaderFault;
use super::files::{ShaderFile, ShaderFiles};
use super::link::{Choice, link};
use crate::bindings;
use std::borrow::Cow;

/// A file below shaders/, and its text as it is joined.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Part {
    file: Cow<'static, str>,
    text: Cow<'static, str>,
}

/// The text with `other` in place of the name `own`, wherever this is a whole name.
fn with_name_replaced(text: &str, own: &str, other: &str) -> String {
    let is_in_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let (mut replaced, mut end) = (String::with_capacity(text.len()), 0);
    for (start, _) in text.match_indices(own) {
        replaced += &text[end..start];
        end = start + own.len();
        let continues = text[..start].ends_with(is_in_name) || text[end..].starts_with(is_in_name);
        replaced += if continues { own } else { other };
    }
    replaced + &text[end..]
}

/// The file name that stands for the constants in front of the files.
const PRELUDE: &str = "constants of the variant";

/// A shader's text: constants that the CPU writes, and the files that are linked after them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaderText {
    /// The constants that do not depend on the files.
    constants: String,
    /// The same with the numbers of the files' bindings.
    prelude: String,
    entries: Vec<&'static str>,
    choices: Vec<Choice>,
    parts: Vec<Part>,
    fault: Option<ShaderFault>,
}

impl ShaderText {
    /// The shader with these entry points, linked from the files that the program was built with.
    pub(crate) fn new(constants: String, entries: &[&'static str], choices: Vec<Choice>) -> Self {
        let unlinked = Self {
            constants,
            prelude: String::new(),
            entries: entries.to_vec(),
            choices,
            parts: Vec::new(),
            fault: None,
        };
        unlinked.linked_from(ShaderFiles::built_in())
    }

    /// The same shader, linked from other files. [`Self::validate`] says what is wrong with it.
    #[must_use]
    pub fn linked_from(&self, files: &ShaderFiles) -> Self {
        let is_constant = |name: &str| declares(&self.constants, name);
        let (files, fault) = link(files, &self.entries, &self.choices, is_constant);
        let part = |file: &ShaderFile| Part {
            file: file.name.clone(),
            text: match self.renaming(&file.name) {
                Some((own, other)) => with_name_replaced(&file.text, own, other).into(),
                None => file.text.clone(),
            },
        };
        let parts: Vec<Part> = files.into_iter().map(part).collect();
        let mut prelude = self.constants.clone();
        for (name, number) in bindings::constants(parts.iter().map(|part| &*part.text)) {
            add_u32(&mut prelude, name, number);
        }
        Self {
            prelude,
            parts,
            fault,
            ..self.clone()
        }
    }

    /// The function of a file that is joined under another name, and this name.
    fn renaming(&self, file: &str) -> Option<(&'static str, &'static str)> {
        let choice = self.choices.iter().find(|choice| choice.file == file)?;
        choice.renamed
    }

    /// The text with one more file at its end.
    #[must_use]
    pub fn followed_by(mut self, file: &'static str, text: &'static str) -> Self {
        let (file, text) = (file.into(), text.into());
        self.parts.push(Part { file, text });
        self
    }

    /// The whole WGSL text.
    pub fn source(&self) -> String {
        self.blocks().map(|(_, text)| text).collect()
    }

    /// The constants in front of the files.
    pub fn prelude(&self) -> &str {
        &self.prelude
    }

    /// The files below shaders/ in their order, with their texts as they are joined.
    pub fn files(&self) -> impl Iterator<Item = (&str, &str)> {
        self.parts.iter().map(|part| (&*part.file, &*part.text))
    }

    /// Why it cannot be linked. In a browser no shader changes, so that none has a fault.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn link_fault(&self) -> Option<&ShaderFault> {
        self.fault.as_ref()
    }

    /// The file that a line of the text comes from, and the line within that file; both lines are
    /// counted from 1.
    pub fn locate(&self, line: usize) -> (&str, usize) {
        let mut first = 1;
        let mut place = (PRELUDE, line);
        for (file, text) in self.blocks() {
            if line >= first {
                place = (file, line - first + 1);
            }
            first += text.lines().count();
        }
        place
    }

    fn blocks(&self) -> impl Iterator<Item = (&str, &str)> {
        std::iter::once((PRELUDE, &*self.prelude)).chain(self.files())
    }
}

/// Whether a name is one of these constants, or a number of the files' bindings.
pub(super) fn declares(constants: &str, name: &str) -> bool {
    if bindings::is_constant(name) {
        return true;
    }
    let mut lines = constants.lines().filter_map(|line| line.split_once(' '));
    lines.any(|(_, rest)| {
        let rest = rest.strip_prefix(name);
        rest.is_some_and(|rest| rest.starts_with([':', ' ']))
    })
}

/// Appends a whole number to a prelude.
pub(crate) fn add_u32(prelude: &mut String, name: &str, value: u32) {
    add_constant(prelude, name, "u32", format!("{value}u"));
}

/// Appends a floating-point number to a prelude.
pub(crate) fn add_f32(prelude: &mut String, name: &str, value: f64) {
    add_constant(prelude, name, "f32", format!("{value:?}"));
}

/// Appends a WGSL constant to a prelude.
pub(crate) fn add_constant(
    prelude: &mut String,
    name: &str,
    kind: &str,
    value: impl std::fmt::Display,
) {
    *prelude += &format!("const {name}: {kind} = {value};\n");
}
