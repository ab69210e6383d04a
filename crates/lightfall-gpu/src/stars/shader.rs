//! The shader that draws images, and the constants of all kernels of stars.

use super::StarKernel;
use super::index;
use super::list::{FLUX_BIAS, TEMPERATURE_STEPS};
use super::mesh::{CANDIDATE_LISTS, MESH_RIM, RANKS, TEST_GROUPS, WIDE_GROUPS};
use crate::shader::spectrum_constants::add_spectrum_constants;
use crate::shader::text::{add_constant, add_f32, add_u32};
use crate::shader::{Choice, ShaderText, projection_file};
use lightfall_model::scene::Projection;
use lightfall_optics::spectrum::rgb_from_xyz;
use lightfall_optics::stars::images::{MIN_SOURCE_RADIUS, ORDERS, table::INTERVALS};

/// The shader that adds the images to the sums: entry point `splat`. It is the same for all scenes
/// with the same projection.
pub fn splat_shader(projection: Projection) -> ShaderText {
    let mut prelude = String::new();
    add_spectrum_constants(&mut prelude);
    add_star_constants(&mut prelude);
    let entry = StarKernel::Splat.word();
    let splat = Choice::of(match projection.of_picture() {
        Projection::Perspective => "stars/splat.wgsl",
        _ => "stars/splat_on_sky.wgsl",
    });
    ShaderText::new(prelude, &[entry], vec![projection_file(projection), splat])
}

/// The shader that looks for the stars in each cell of the mesh: entry points `find_candidates`,
/// `find_wide_candidates` and `test_candidates`. It is the same for all scenes, because a mesh covers a
/// perspective picture.
pub fn candidate_shader() -> ShaderText {
    let mut prelude = String::new();
    add_spectrum_constants(&mut prelude);
    add_star_constants(&mut prelude);
    add_u32(&mut prelude, "INDEX_LAYERS", index::LAYERS);
    add_u32(&mut prelude, "FIRST_INDEX_SIDE", index::FIRST_SIDE);
    add_u32(&mut prelude, "MESH_RIM", MESH_RIM);
    add_u32(&mut prelude, "WIDE_GROUPS", WIDE_GROUPS);
    add_u32(&mut prelude, "TEST_GROUPS", TEST_GROUPS);
    let entries = StarKernel::FINDING_CANDIDATES.map(StarKernel::word);
    let perspective = projection_file(Projection::Perspective);
    ShaderText::new(prelude, &entries, vec![perspective])
}

/// Appends the constants of the kernels.
pub(crate) fn add_star_constants(prelude: &mut String) {
    add_u32(prelude, "STAR_ORDERS", ORDERS);
    add_u32(prelude, "STAR_INTERVALS", INTERVALS as u32);
    add_u32(prelude, "STAR_FLUX_BIAS", FLUX_BIAS);
    add_u32(prelude, "CANDIDATE_LISTS", CANDIDATE_LISTS as u32);
    add_u32(prelude, "RANKS", RANKS as u32);
    add_f32(prelude, "STAR_TEMPERATURE_STEPS", TEMPERATURE_STEPS.into());
    add_f32(prelude, "MIN_SOURCE_RADIUS", MIN_SOURCE_RADIUS);
    // The share of each primary in the luminance Y.
    let [r, g, b] = rgb_from_xyz().inverse().row(1).to_array();
    let luminance = format!("vec3<f32>({r:?}, {g:?}, {b:?})");
    add_constant(prelude, "LUMINANCE", "vec3<f32>", luminance);
}
