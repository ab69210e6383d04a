//! The shader that averages frames, and its uniform.

use super::shader::ShaderText;
use encase::ShaderType;

/// Mirror of `Accumulation` in shaders/antialias/accumulate.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Accumulation {
    pub frame: u32,
}

impl Accumulation {
    /// The shader: entry points `vertex` and `accumulate`.
    pub fn shader() -> ShaderText {
        ShaderText::new(String::new(), &["vertex", "accumulate"], Vec::new())
    }
}
