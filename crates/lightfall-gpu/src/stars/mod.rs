//! Point stars on the GPU: the list of stars, the kernels that find their images and draw them, and
//! the numbers that the kernels share.
//!
//! # How the kernels run
//!
//! [`StarKernel`] lists the kernels in their order, with the bindings and the number of workgroups of
//! each. Before every run the pass writes [`EMPTY_COUNT`] to the buffer `STAR_COUNT`, clears
//! `STAR_SUMS` and, where a mesh is used, writes [`empty_candidate_count`] to `CANDIDATE_COUNT`.
//!
//! 1. The images are found by inversion: `solve`, with [`solve_workgroups`] workgroups. Where
//!    [`Variant::uses_star_mesh`](super::Variant::uses_star_mesh), a mesh of rays finds them instead:
//!    `trace_mesh` traces it, `find_candidates`, `find_wide_candidates` and `test_candidates` list the
//!    stars that may have an image in each cell, and `interpolate` and `refine_image` find the images.
//!    In other projections than the perspective one, this is done for each [`StarSide`] in turn, with
//!    the scene and the mesh of that side, and [`empty_candidate_count`] before each.
//! 2. `dim` dims the images behind the disk, if there is one.
//! 3. `splat` adds the light of the images to `STAR_SUMS`. The light on the square (x, y) of
//!    [`sums_side`] pixels each way, linear and before exposure, is the three numbers from
//!    3 (y columns + x) on, divided by [`GpuStars::unit`]. They are whole numbers, so the order of the
//!    additions does not matter.
//!
//! The list of images depends on the scene's hole, camera, observer, effects, disk and sky and on
//! the picture's size; the sums depend on the exposure as well, through their unit. The list holds
//! directions, not pixels, so that every projection can draw it.

mod index;
mod kernel;
mod list;
mod mesh;
mod numbers;
mod shader;
mod sides;
mod sums;

pub use index::index_bytes;
pub use kernel::StarKernel;
pub use list::{MAX_CANDIDATES, MAX_IMAGES, PackedStars};
pub use mesh::{
    CANDIDATE_COUNT_SIZE, GpuMeshPoint, GpuStarMesh, MAX_TRACED, candidates_size,
    empty_candidate_count, mesh_layout, mesh_points_size,
};
pub use numbers::{GpuStarImage, GpuStars, light_unit, table_rows};
pub use shader::{candidate_shader, splat_shader};
pub use sides::StarSide;
pub use sums::{sums_side, sums_size};

pub(super) use shader::add_star_constants;

use super::bindings::{MAX_WORKGROUPS, WORKGROUP_SIZE};
use encase::ShaderSize;
use lightfall_optics::stars::images::table::INTERVALS;

/// The contents of `STAR_COUNT` and of each list in `CANDIDATE_COUNT` before a run: no workgroups of the
/// kernel that reads the list, and nothing in it.
pub const EMPTY_COUNT: [u32; 4] = [0, 1, 1, 0];

/// The size in bytes of `STAR_COUNT` and of the part of each list in `CANDIDATE_COUNT`.
pub const COUNT_SIZE: u64 = 16;

/// The size of `STAR_TABLE` in bytes.
pub const TABLE_SIZE: u64 = 16 * INTERVALS as u64;

/// The workgroups along x and y that give each of `count` stars its invocation of `solve`.
pub fn solve_workgroups(count: u32) -> [u32; 2] {
    let groups = count.div_ceil(WORKGROUP_SIZE);
    let rows = groups.div_ceil(MAX_WORKGROUPS).max(1);
    [groups.div_ceil(rows), rows]
}

/// The size of `STAR_IMAGES` in bytes.
pub fn images_size(list: &PackedStars) -> u64 {
    u64::from(list.max_images()) * GpuStarImage::SHADER_SIZE.get()
}
