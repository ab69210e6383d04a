//! The shader that gives a developed picture the levels of a file, and its uniform.

use super::shader::ShaderText;
use encase::ShaderType;
use glam::IVec2;

/// Mirror of `Print` in shaders/print.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Print {
    pub origin: IVec2,
    pub top: f32,
    pub bloom: u32,
}

impl Print {
    /// The shader: entry points `vertex` and `print`.
    pub fn shader() -> ShaderText {
        ShaderText::new(String::new(), &["vertex", "print"], Vec::new())
    }
}
