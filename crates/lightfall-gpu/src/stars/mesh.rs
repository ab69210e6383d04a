//! The mesh of rays that finds images of stars: its uniform, its lists and their sizes.

use super::list::PackedStars;
use super::numbers::stretch;
use super::{COUNT_SIZE, EMPTY_COUNT, StarSide};
use encase::ShaderType;
use glam::{DMat3, UVec2, Vec2, Vec3};
use lightfall_model::scene::Scene;
use lightfall_optics::stars::images::MeshLayout;

/// Cells at each side of the mesh that find no images and only complete the differences of their
/// neighbours.
pub(super) const MESH_RIM: u32 = 2;

/// The distance from an image of the rays that measure its magnification, as a share of the mesh's
/// spacing: 0.35 pixels of 960x540.
const HALF_STEP: f64 = 0.0875;

/// The limits of that distance in radians. Below, the rounding of directions has an effect of more
/// than 0.5 %; above, the curvature of the map from the picture to the sky would.
const HALF_STEPS: [f64; 2] = [3e-5, 6.1e-4];

/// Maximum number of candidates whose images rays find: more than in pictures from a few r_s away.
/// It prevents frames next to the horizon that take seconds.
pub const MAX_TRACED: u32 = 1 << 17;

/// Mirror of `StarMesh` in shaders/stars/mesh_points.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuStarMesh {
    pub origin: Vec2,
    pub points: UVec2,
    pub list_x: Vec3,
    pub spacing: f32,
    pub list_y: Vec3,
    pub half_step: f32,
    pub list_z: Vec3,
    pub capacity: u32,
    pub picture_right: Vec3,
    pub picture_up: Vec3,
    pub picture_forward: Vec3,
}

/// Mirror of `MeshPoint` in shaders/stars/mesh_points.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuMeshPoint {
    pub sky: Vec3,
    pub turn: f32,
    pub gain: f32,
}

/// The mesh of about `cells` cells for the scene's picture.
pub fn mesh_layout(scene: &Scene, cells: f64) -> MeshLayout {
    let reach = 2.0 * stretch(scene);
    MeshLayout::new(scene.picture.size(), cells, reach).with_rim(MESH_RIM)
}

impl GpuStarMesh {
    /// The uniform's size in bytes.
    pub const SIZE: u64 = <Self as encase::ShaderSize>::SHADER_SIZE.get();

    /// The numbers for the scene and this mesh of its picture. `hole_from_list` turns the list's
    /// directions into the hole's frame.
    pub fn new(
        scene: &Scene,
        layout: &MeshLayout,
        list: &PackedStars,
        hole_from_list: DMat3,
    ) -> Self {
        let pixel = scene.pixel_angle();
        let [shortest, longest] = HALF_STEPS;
        let angle = (HALF_STEP * layout.spacing * pixel).clamp(shortest, longest);
        // Rays are traced in the disk's frame. The rows of the inverse of a rotation are its
        // columns.
        let disk_from_list = scene.disk.hole_from_disk().transpose() * hole_from_list;
        let [list_x, list_y, list_z] = [0, 1, 2].map(|i| disk_from_list.col(i).as_vec3());
        Self {
            origin: layout.origin.as_vec2(),
            points: layout.points,
            list_x,
            spacing: layout.spacing as f32,
            list_y,
            half_step: (angle / pixel) as f32,
            list_z,
            capacity: list.max_candidates(),
            picture_right: Vec3::X,
            picture_up: Vec3::Y,
            picture_forward: Vec3::Z,
        }
    }

    /// The same numbers for a mesh on this side, with the rotation from the side to the picture.
    #[must_use]
    pub fn on_side(self, side: &StarSide) -> Self {
        let row = |i: usize| side.picture_from_side.row(i).as_vec3();
        Self {
            picture_right: row(0),
            picture_up: row(1),
            picture_forward: row(2),
            ..self
        }
    }
}

/// The size of `MESH_POINTS` in bytes.
pub fn mesh_points_size(layout: &MeshLayout) -> u64 {
    u64::from(layout.point_count()) * <GpuMeshPoint as encase::ShaderSize>::SHADER_SIZE.get()
}

/// The workgroups of `find_wide_candidates`, which share the parts of wide cells: some ten
/// thousands in most pictures. More are faster on a graphics card, and slower on a software
/// renderer, where a workgroup costs time even if it finds nothing to do.
pub(super) const WIDE_GROUPS: u32 = 256;

/// The workgroups of `test_candidates`, which share the candidates in bent cells.
pub(super) const TEST_GROUPS: u32 = 64;

/// The lists in `CANDIDATES`, which shaders/stars/candidates.wgsl names.
pub(super) const CANDIDATE_LISTS: usize = 4;

/// The ranks of stars by which rough candidates are counted.
pub(super) const RANKS: usize = 128;

/// The size of `CANDIDATE_COUNT` in bytes: lists, ranks and a number, filled up to whole 16 bytes.
pub const CANDIDATE_COUNT_SIZE: u64 = CANDIDATE_LISTS as u64 * COUNT_SIZE + 4 * RANKS as u64 + 16;

/// The contents of `CANDIDATE_COUNT` before a run in which rays follow at most `max_traced`
/// candidates: empty lists, no candidate of any rank, and this number.
pub fn empty_candidate_count(max_traced: u32) -> Vec<u8> {
    let lists = EMPTY_COUNT.repeat(CANDIDATE_LISTS);
    let words = lists.into_iter().chain([0; RANKS]);
    let words = words.chain([max_traced, 0, 0, 0]);
    words.flat_map(u32::to_le_bytes).collect()
}

/// The size of `CANDIDATES` in bytes.
pub fn candidates_size(list: &PackedStars) -> u64 {
    CANDIDATE_LISTS as u64 * 8 * u64::from(list.max_candidates())
}
