//! The shader that develops a picture, and its uniform.

use super::shader::ShaderText;
use super::shader::text::{add_constant, add_u32};
use encase::ShaderType;
use glam::{IVec2, UVec2, Vec2};
use lightfall_model::scene::{Projection, Scene, ToneCurve};

/// The radius of a circle that is larger than every picture, in pixels.
const NO_CIRCLE: f32 = 1e9;

/// Mirror of `Development` in shaders/develop.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct Development {
    pub whole: UVec2,
    pub origin: IVec2,
    pub exposure: f32,
    pub bloom: f32,
    pub axis: Vec2,
    pub radius: f32,
}

/// A shader that develops a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Developer {
    /// The tone curve.
    pub curve: ToneCurve,
    /// Whether there is bloom.
    pub has_bloom: bool,
}

impl Development {
    /// The numbers of a scene, of whose picture what is drawn begins at `origin`.
    pub fn new(scene: &Scene, origin: IVec2) -> Self {
        let (camera, whole) = (&scene.camera, scene.picture.size());
        let size = whole.max(UVec2::ONE).as_dvec2();
        let (axis, radius) = match camera.projection {
            Projection::Fisheye => (
                camera.axis(size).as_vec2(),
                camera.projection_numbers(size).y as f32,
            ),
            _ => (Vec2::ZERO, NO_CIRCLE),
        };
        Self {
            whole,
            origin,
            exposure: scene.picture.exposure_ev.exp2() as f32,
            bloom: scene.picture.bloom as f32,
            axis,
            radius,
        }
    }
}

impl Developer {
    /// The number of shaders.
    pub const COUNT: usize = 2 * ToneCurve::ALL.len();

    /// All of them, in the order of their numbers.
    pub fn all() -> [Self; Self::COUNT] {
        std::array::from_fn(|number| Self {
            curve: ToneCurve::ALL[number / 2],
            has_bloom: number % 2 == 1,
        })
    }

    /// The one for a scene, with or without bloom.
    pub fn of(scene: &Scene, has_bloom: bool) -> Self {
        // The marks of a view have the colours of its legend.
        let curve = if scene.view.shows_light() {
            scene.picture.tone_curve
        } else {
            ToneCurve::Neutral
        };
        Self { curve, has_bloom }
    }

    /// Its number.
    pub fn number(self) -> usize {
        2 * self.curve as usize + usize::from(self.has_bloom)
    }

    /// The shader: entry points `vertex` and `develop`.
    pub fn shader(self) -> ShaderText {
        let mut prelude = String::new();
        add_constant(&mut prelude, "HAS_BLOOM", "bool", self.has_bloom);
        add_u32(&mut prelude, "CURVE", self.curve as u32);
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
