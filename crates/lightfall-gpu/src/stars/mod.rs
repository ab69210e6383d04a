//! Point stars on the GPU: the list of stars, the kernels that find their images and draw them, and
//! the numbers that the kernels share.
//!
//! # How the kernels run
//!
//! All bindings are in group 0, with the numbers of [`bindings`](super::bindings). [`StarKernel`] has the
//! kernels in their order, with what each binds.
//!
//! 1. Before every run the pass writes [`EMPTY_COUNT`] to the buffer `STAR_COUNT` and clears
//!    `STAR_SUMS`.
//! 2. `solve` ([`Variant::stars`](super::Variant::stars)) reads `SCENE`, `SPECTRUM`, `STARS`,
//!    `STAR_LIST` and, with lensing, `STAR_TABLE`, and writes `STAR_IMAGES` and `STAR_COUNT`. It
//!    takes [`solve_workgroups`] workgroups.
//!    Where [`Variant::uses_star_mesh`](super::Variant::uses_star_mesh) says so, others take its
//!    place:
//!    * `trace_mesh` ([`Variant::star_mesh`](super::Variant::star_mesh)) reads `SCENE` and
//!      `STAR_MESH` and writes `MESH_POINTS`. It takes [`StarKernel::mesh_workgroups`] workgroups.
//!    * `propose`, `propose_wide` and `predict` ([`candidate_shader`]) read `SCENE`, `STARS`,
//!      `STAR_LIST`, `STAR_MESH` and `MESH_POINTS`, the first two also `STAR_INDEX`, and write
//!      `CANDIDATES` and `CANDIDATE_COUNT`, to which the pass has written [`empty_candidate_count`].
//!      They take [`StarKernel::mesh_workgroups`] workgroups.
//!    * `interpolate` ([`Variant::star_interpolation`](super::Variant::star_interpolation)) and
//!      `polish` ([`Variant::star_refinement`](super::Variant::star_refinement)) read `SCENE`, `SPECTRUM`,
//!      `STARS`, `STAR_LIST`, `STAR_MESH`, `MESH_POINTS`, `CANDIDATES` and `CANDIDATE_COUNT`, and
//!      write `STAR_IMAGES` and `STAR_COUNT`. They are dispatched indirectly from the first and the
//!      second [`COUNT_SIZE`] bytes of `CANDIDATE_COUNT`.
//! 3. Where there is a disk, `hide` ([`Variant::star_dimming`](super::Variant::star_dimming)) reads
//!    `SCENE`, `STARS` and `STAR_COUNT`, and dims the images in `STAR_IMAGES`. It is dispatched
//!    indirectly from the start of `STAR_COUNT`.
//! 4. `splat` ([`splat_shader`]) reads `SCENE`, `SPECTRUM`, `STARS`, `STAR_IMAGES` and `STAR_COUNT`,
//!    and writes `STAR_SUMS`. It is dispatched in the same way.
//!
//! The light of the stars on the square (x, y) of [`sums_side`] pixels each way, in linear light before
//! exposure, is then the three numbers from 3 (y columns + x) on in `STAR_SUMS`, divided by
//! [`GpuStars::unit`]. Because the
//! numbers are whole, they do not depend on the order of the additions.
//!
//! | buffer | usage | size | contents change with |
//! |---|---|---|---|
//! | `STARS` | uniform | [`GpuStars::SIZE`] | the scene |
//! | `STAR_TABLE` | uniform | [`TABLE_SIZE`] | the camera's radius |
//! | `STAR_LIST` | storage | [`PackedStars::bytes`] | the catalogue and how deep it goes |
//! | `STAR_MESH` | uniform | [`GpuStarMesh::SIZE`] | the scene |
//! | `MESH_POINTS` | storage | [`mesh_points_size`] | every run |
//! | `STAR_INDEX` | storage | [`index_bytes`] | the list |
//! | `CANDIDATES` | storage | [`candidates_size`] | every run |
//! | `CANDIDATE_COUNT` | storage, indirect | [`CANDIDATE_COUNT_SIZE`] | every run |
//! | `STAR_IMAGES` | storage | [`images_size`] | every run |
//! | `STAR_COUNT` | storage, indirect | [`COUNT_SIZE`] | every run |
//! | `STAR_SUMS` | storage | [`sums_size`] | every run |
//!
//! The list of images depends on the scene's hole, camera, observer, effects, disk and sky and on
//! the picture's size; the sums depend on the exposure as well, through their unit. It holds
//! directions, not pixels, so that every projection can draw it.

mod index;
mod kernel;
mod list;
mod mesh;
mod numbers;
mod run;
mod shader;
mod sums;

pub use index::index_bytes;
pub use kernel::StarKernel;
pub use list::{MAX_CANDIDATES, MAX_IMAGES, PackedStars, UnpackedStar};
pub use mesh::{
    CANDIDATE_COUNT_SIZE, GpuMeshPoint, GpuStarMesh, MAX_TRACED, candidates_size,
    empty_candidate_count, mesh_layout, mesh_points_size,
};
pub use numbers::{GpuStarImage, GpuStars, light_unit, table_rows};
pub use run::{StarLight, StarRun};
pub use shader::{candidate_shader, splat_shader};
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
#[must_use]
pub fn solve_workgroups(count: u32) -> [u32; 2] {
    let groups = count.div_ceil(WORKGROUP_SIZE);
    let rows = groups.div_ceil(MAX_WORKGROUPS).max(1);
    [groups.div_ceil(rows), rows]
}

/// The size of `STAR_IMAGES` in bytes.
#[must_use]
pub fn images_size(list: &PackedStars) -> u64 {
    u64::from(list.max_images()) * GpuStarImage::SHADER_SIZE.get()
}
