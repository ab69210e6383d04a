//! WGSL text joined from constants and files.

use std::borrow::Cow;

/// A file below shaders/, and its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gpu) struct Part {
    pub file: &'static str,
    pub text: &'static str,
    /// A function of the file that another file defines in its place, and its name instead.
    pub renamed: Option<(&'static str, &'static str)>,
}

impl Part {
    /// The same file with its function `own` called `other`, so that another file can define `own`
    /// and call it.
    pub(super) fn renaming(self, own: &'static str, other: &'static str) -> Self {
        Self {
            renamed: Some((own, other)),
            ..self
        }
    }

    /// The text as it is joined.
    fn joined(&self) -> Cow<'static, str> {
        match self.renamed {
            Some((own, other)) => with_name_replaced(self.text, own, other).into(),
            None => self.text.into(),
        }
    }
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

/// The [`Part`] of a file below shaders/.
macro_rules! part {
    ($file:literal) => {
        $crate::gpu::shader::text::Part {
            file: $file,
            text: include_str!(concat!(
                env!("CARGO_MANIFEST_DIR"),
                "/../../shaders/",
                $file
            )),
            renamed: None,
        }
    };
}
pub(in crate::gpu) use part;

/// The file name that stands for the constants in front of the files.
const PRELUDE: &str = "constants of the variant";

/// A shader's text: constants that the CPU writes, and the files that are joined after them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaderText {
    prelude: String,
    parts: Vec<Part>,
}

impl ShaderText {
    pub(in crate::gpu) fn new(prelude: String, parts: Vec<Part>) -> Self {
        Self { prelude, parts }
    }

    /// The text with one more file at its end.
    #[must_use]
    pub fn followed_by(mut self, file: &'static str, text: &'static str) -> Self {
        self.parts.push(Part {
            file,
            text,
            renamed: None,
        });
        self
    }

    /// The whole WGSL text.
    #[must_use]
    pub fn source(&self) -> String {
        self.blocks().map(|(_, text)| text).collect()
    }

    /// The constants in front of the files.
    #[must_use]
    pub fn prelude(&self) -> &str {
        &self.prelude
    }

    /// The files below shaders/ in their order, with their texts as they are joined.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, Cow<'static, str>)> {
        self.parts.iter().map(|part| (part.file, part.joined()))
    }

    /// The file that a line of the text comes from, and the line within that file; both lines are
    /// counted from 1.
    #[must_use]
    pub fn locate(&self, line: usize) -> (&'static str, usize) {
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

    fn blocks(&self) -> impl Iterator<Item = (&'static str, Cow<'_, str>)> {
        let files = self.parts.iter().map(|part| (part.file, part.joined()));
        std::iter::once((PRELUDE, self.prelude.as_str().into())).chain(files)
    }
}

/// Appends a WGSL constant to a prelude.
pub(in crate::gpu) fn add_constant(
    prelude: &mut String,
    name: &str,
    kind: &str,
    value: impl std::fmt::Display,
) {
    *prelude += &format!("const {name}: {kind} = {value};\n");
}
