//! The shader that shows how two pictures differ, and its uniform.

use super::shader::ShaderText;
use encase::ShaderType;

/// Mirror of `Difference` in shaders/difference.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Difference {
    pub gain: f32,
}

impl Difference {
    /// The shader: entry points `vertex` and `difference`.
    pub fn shader() -> ShaderText {
        ShaderText::new(String::new(), &["vertex", "difference"], Vec::new())
    }
}
