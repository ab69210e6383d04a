//! The shader that shows how two pictures differ, and its uniform.

use super::bindings::DIFFERENCE_CONSTANTS;
use super::shader::ShaderText;
use super::shader::text::add_constant;
use encase::ShaderType;

/// Mirror of `Difference` in shaders/difference.wgsl.
#[expect(
    missing_docs,
    reason = "shaders/difference.wgsl says what each field means"
)]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Difference {
    pub gain: f32,
}

impl Difference {
    /// The shader: entry points `vertex` and `difference`.
    #[must_use]
    pub fn shader() -> ShaderText {
        let mut prelude = String::new();
        for (name, value) in DIFFERENCE_CONSTANTS {
            add_constant(&mut prelude, name, "u32", format!("{value}u"));
        }
        ShaderText::new(prelude, &["vertex", "difference"], Vec::new())
    }
}
