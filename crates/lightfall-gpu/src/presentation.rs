//! The presentation's shader and its uniform, which turn the tone-mapped picture into cells on the
//! screen.

use super::shader::ShaderText;
use super::shader::text::add_u32;
use encase::ShaderType;
use glam::{UVec2, Vec2};
use lightfall_model::scene::MAX_PIXELS_PER_CELL;

/// Mirror of `Presentation` in shaders/presentation.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Presentation {
    pub picture: UVec2,
    pub grid: UVec2,
    pub offset: Vec2,
    pub extent: Vec2,
    pub levels: f32,
    pub dither: u32,
    pub bloom: u32,
}

impl Presentation {
    /// The shader of all stages: entry points `vertex`, `pixelate`, `expand` and `fit`.
    pub fn shader() -> ShaderText {
        let mut prelude = String::new();
        // A cell touches one pixel more than it is wide if its edges lie within pixels.
        add_u32(&mut prelude, "MAX_PIXELS_TOUCHED", MAX_PIXELS_PER_CELL + 1);
        let entries = ["vertex", "pixelate", "expand", "fit"];
        ShaderText::new(prelude, &entries, Vec::new())
    }
}
