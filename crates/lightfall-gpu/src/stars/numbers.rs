//! The uniform and the table of the kernels, and the record of an image.

use super::list::PackedStars;
use super::sums::sums_side;
use encase::ShaderType;
use glam::{DMat3, DVec3, UVec2, UVec4, Vec3, Vec4};
use lightfall_model::scene::Scene;
use lightfall_optics::stars::images::{Inversion, ORDERS};
use lightfall_optics::stars::{Depth, ZERO_MAGNITUDE_FLUX};

/// Images of stars are one pixel wide in pictures of up to this height, and wider in proportion in
/// larger ones, so that these do not look emptier.
const FINE_HEIGHT: f64 = 1080.0;

/// Units of the sums per light that is shown as white, at an exposure of a whole step: a unit is at
/// most a 65 536th of white at any exposure.
const UNITS_PER_WHITE: f64 = 262_144.0;

/// The ratio of a camera's largest gain to the largest sampled one, at most.
const GAIN_MARGIN: f64 = 2.0;

/// Mirror of `Stars` in shaders/stars/stars.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuStars {
    pub behind: Vec3,
    pub shadow_half_angle: f32,
    pub along_theta: Vec4,
    pub along_phi: Vec4,
    pub frequency: Vec4,
    pub right: Vec4,
    pub up: Vec4,
    pub forward: Vec4,
    pub counts: UVec4,
    pub table_width: f32,
    pub table_first: f32,
    pub table_density: f32,
    pub flux_limit: f32,
    pub capacity: u32,
    pub stretch: f32,
    pub unit: f32,
    pub sums_side: u32,
}

/// Mirror of `StarImage` in shaders/stars/stars.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuStarImage {
    pub direction: Vec3,
    pub flux: f32,
    pub temperature: f32,
    pub star: u32,
    pub order: u32,
}

impl GpuStars {
    /// The uniform's size in bytes.
    pub const SIZE: u64 = <Self as encase::ShaderSize>::SHADER_SIZE.get();

    /// The numbers for a scene whose images are found by a mesh. Images are drawn down to `depth`.
    pub fn for_mesh(scene: &Scene, list: &PackedStars, depth: Depth) -> Self {
        let flux_limit = ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * depth.limit);
        Self {
            counts: UVec4::splat(count_to(list, depth.last)),
            flux_limit: flux_limit as f32,
            capacity: list.max_images(),
            stretch: stretch(scene) as f32,
            unit: (1.0 / light_unit(scene)) as f32,
            sums_side: sums_side(scene.picture.size()),
            ..Self::default()
        }
    }

    /// The numbers for a part of this size of the scene's picture.
    #[must_use]
    pub fn of_part(self, size: UVec2) -> Self {
        Self {
            sums_side: sums_side(size),
            ..self
        }
    }

    /// The numbers for a scene and its [`Inversion`]. `hole_from_list` turns the list's directions
    /// into the hole's frame. Images are drawn down to `depth`.
    pub fn new(
        scene: &Scene,
        inversion: &Inversion,
        list: &PackedStars,
        hole_from_list: DMat3,
        depth: Depth,
    ) -> Self {
        let axes = scene.camera.tetrad();
        let list_from_hole = hole_from_list.transpose();
        let behind = (list_from_hole * -axes.x_axis).as_vec3();
        let row = |axis: DVec3| {
            let axis = list_from_hole * axis;
            axis.extend(axis.dot(behind.as_dvec3())).as_vec4()
        };
        let flux_limit = ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * depth.limit);
        let [width, first, density, shadow] = inversion.table().map_or([1.0; 4], |table| {
            let [first, spacing] = table.places();
            let shadow = table.sky().shadow_half_angle();
            [table.width(), first, 1.0 / spacing, shadow]
        });
        let rows = inversion.camera_from_frame().transpose();
        let on_axes = [rows.y_axis, rows.z_axis, rows.w_axis];
        let camera_row = |axis: DVec3| {
            let [outward, theta, phi] = axis.to_array();
            (outward * on_axes[0] + theta * on_axes[1] + phi * on_axes[2]).as_vec4()
        };
        let tetrad_from_camera = scene.camera.tetrad_from_camera();
        Self {
            behind,
            shadow_half_angle: shadow as f32,
            along_theta: row(axes.y_axis),
            along_phi: row(axes.z_axis),
            frequency: rows.x_axis.as_vec4(),
            right: camera_row(tetrad_from_camera.x_axis),
            up: camera_row(tetrad_from_camera.y_axis),
            forward: camera_row(tetrad_from_camera.z_axis),
            counts: counts(inversion, list, flux_limit, depth.last),
            table_width: width as f32,
            table_first: first as f32,
            table_density: density as f32,
            ..Self::for_mesh(scene, list, depth)
        }
    }
}

/// Linear light per unit of the sums. It depends on the scene's exposure in large steps: a unit is
/// invisible at any exposure, and a sum has room for the light of the brightest stars.
pub fn light_unit(scene: &Scene) -> f64 {
    (-scene.stepped_exposure()).exp2() / UNITS_PER_WHITE
}

/// The width of an image relative to one pixel.
pub(super) fn stretch(scene: &Scene) -> f64 {
    (f64::from(scene.picture.height) / FINE_HEIGHT).max(1.0)
}

/// The number of stars down to the magnitude `last`.
fn count_to(list: &PackedStars, last: f64) -> u32 {
    list.count_brighter(ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * last))
}

/// The numbers of stars that may have an image of each order above the limit. All stars count for
/// the first two orders, whose images may be next to a caustic.
fn counts(inversion: &Inversion, list: &PackedStars, flux_limit: f64, last: f64) -> UVec4 {
    let mut counts = [count_to(list, last); ORDERS as usize];
    for order in 2..ORDERS {
        let gain = GAIN_MARGIN * inversion.max_gain(order);
        let bright = list.count_brighter(flux_limit / gain.max(f64::MIN_POSITIVE));
        counts[order as usize] = bright.min(counts[order as usize - 1]);
    }
    UVec4::from_array(counts)
}

/// The contents of `STAR_TABLE` as shaders/stars/closed.wgsl states them; `None` along straight
/// rays.
pub fn table_rows(inversion: &Inversion) -> Option<Vec<[f32; 4]>> {
    let nodes = inversion.table()?.nodes();
    let rows = nodes
        .windows(2)
        .map(|ends| [ends[0][0], ends[0][1], ends[1][0], ends[1][1]].map(|x| x as f32));
    Some(rows.collect())
}
