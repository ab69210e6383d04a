//! The shader that averages frames, and its uniform.

use super::bindings::ACCUMULATION_CONSTANTS;
use super::shader::ShaderText;
use super::shader::text::add_constant;
use encase::ShaderType;

/// Mirror of `Accumulation` in shaders/antialias/accumulate.wgsl.
#[expect(
    missing_docs,
    reason = "shaders/antialias/accumulate.wgsl says what each field means"
)]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Accumulation {
    pub frame: u32,
}

impl Accumulation {
    /// The shader: entry points `vertex` and `accumulate`.
    #[must_use]
    pub fn shader() -> ShaderText {
        let mut prelude = String::new();
        for (name, value) in ACCUMULATION_CONSTANTS {
            add_constant(&mut prelude, name, "u32", format!("{value}u"));
        }
        ShaderText::new(prelude, &["vertex", "accumulate"], Vec::new())
    }
}
