//! The uniform of the sky modes that are maps, in a binding of its own: only scenes with stars or with
//! a picture of the sky read it.

use super::shader::text::add_constant;
use super::sky_texture::TEXEL;
use super::stars::{light_unit, sums_side};
use encase::ShaderType;
use glam::{DVec2, Mat3, UVec2, Vec2, Vec4};
use lightfall_model::scene::Scene;
use lightfall_optics::milky_way::{MilkyWay, nebular};
use lightfall_optics::sky_picture::{SkyPicture, picture_from_hole};
use lightfall_optics::stars::{Depth, FAINTER_SHARE, hole_from_celestial};

/// Mirror of `Starlight` in shaders/sky/map.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuStarlight {
    pub celestial_from_hole: Mat3,
    pub magnitude_limit: f32,
    pub last_magnitude: f32,
    pub temperatures: Vec2,
    pub nebular: [Vec4; nebular::TABLE_LEN],
    pub texel: f32,
    pub light_unit: f32,
    pub squares_per_pixel: f32,
    pub columns: u32,
}

impl GpuStarlight {
    /// The numbers of a scene whose points are as deep as `depth`. Those of a picture of the sky are on
    /// the picture's axes.
    pub fn new(scene: &Scene, depth: Depth) -> Self {
        let sky = &scene.sky;
        // A scene that can be drawn has its picture.
        let picture = SkyPicture::of(scene).ok().flatten();
        let (map_from_hole, texel) = match &picture {
            Some(picture) => (picture_from_hole(scene), picture.texel_width()),
            None => (
                hole_from_celestial(sky.ra_deg, sky.dec_deg, sky.roll_deg).transpose(),
                TEXEL,
            ),
        };
        // Rays are traced in the disk's frame.
        let map_from_rays = map_from_hole * scene.disk.hole_from_disk();
        Self {
            celestial_from_hole: map_from_rays.as_mat3(),
            magnitude_limit: depth.limit as f32,
            last_magnitude: depth.last as f32,
            temperatures: DVec2::from(MilkyWay::temperatures()).as_vec2(),
            nebular: nebular::table().map(|colour| colour.extend(0.0).as_vec4()),
            texel: texel as f32,
            light_unit: light_unit(scene) as f32,
            ..Self::default()
        }
        .of_part(scene.picture.size())
    }

    /// The numbers for a part of this size of the scene's picture.
    #[must_use]
    pub fn of_part(self, size: UVec2) -> Self {
        let side = sums_side(size);
        Self {
            squares_per_pixel: 1.0 / side as f32,
            columns: size.x.div_ceil(side),
            ..self
        }
    }
}

/// Appends the constant that the shader shares.
pub(super) fn add_constants(prelude: &mut String) {
    let [a, b, c, d] = FAINTER_SHARE;
    let cubic = format!("vec4<f32>({a:?}, {b:?}, {c:?}, {d:?})");
    add_constant(prelude, "FAINTER_SHARE", "vec4<f32>", cubic);
    let shift = |g: f64| format!("{g:?}");
    add_constant(
        prelude,
        "NEBULAR_MIN_SHIFT",
        "f32",
        shift(nebular::MIN_SHIFT),
    );
    add_constant(
        prelude,
        "NEBULAR_MAX_SHIFT",
        "f32",
        shift(nebular::MAX_SHIFT),
    );
    let length = format!("{}u", nebular::TABLE_LEN);
    add_constant(prelude, "NEBULAR_LEN", "u32", length);
}
