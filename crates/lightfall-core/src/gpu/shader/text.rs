//! WGSL text joined from constants and files.

/// A file below shaders/, and its text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gpu) struct Part {
    pub file: &'static str,
    pub text: &'static str,
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

    /// The files below shaders/ in their order, with their texts.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.parts.iter().map(|part| (part.file, part.text))
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

    fn blocks(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let files = self.parts.iter().map(|part| (part.file, part.text));
        std::iter::once((PRELUDE, self.prelude.as_str())).chain(files)
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
