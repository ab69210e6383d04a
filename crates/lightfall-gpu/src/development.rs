//! The shader that develops a picture, and its uniform.

use super::shader::ShaderText;
use super::shader::text::add_u32;
use encase::ShaderType;
use glam::UVec2;
use lightfall_model::scene::{Part, Scene, ToneCurve};

/// Mirror of `Development` in shaders/develop.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Development {
    pub whole: UVec2,
    pub origin: UVec2,
    pub exposure: f32,
    pub bloom: f32,
    pub curve: u32,
}

impl Development {
    /// The numbers of a scene of which a part is drawn, if one is given, with or without bloom.
    pub fn new(scene: &Scene, part: Option<Part>, has_bloom: bool) -> Self {
        // The marks of a view have the colours of its legend.
        let curve = if scene.view.shows_light() {
            scene.picture.tone_curve
        } else {
            ToneCurve::Neutral
        };
        Self {
            whole: scene.picture.size(),
            origin: part.map_or(UVec2::ZERO, |part| part.origin),
            exposure: scene.picture.exposure_ev.exp2() as f32,
            bloom: if has_bloom {
                scene.picture.bloom as f32
            } else {
                0.0
            },
            curve: curve as u32,
        }
    }

    /// The shader: entry points `vertex` and `develop`.
    pub fn shader() -> ShaderText {
        let mut prelude = String::new();
        for curve in ToneCurve::ALL {
            add_u32(
                &mut prelude,
                &curve.word().to_ascii_uppercase(),
                curve as u32,
            );
        }
        ShaderText::new(prelude, &["vertex", "develop"], Vec::new())
    }
}
