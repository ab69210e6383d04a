//! The kernels of stars and their bindings, in the order in which they run.

use super::COUNT_SIZE;
use super::mesh::{TEST_GROUPS, WIDE_GROUPS};
use super::shader::{candidate_shader, splat_shader};
use crate::bindings::{
    ALL, CANDIDATE_COUNT, CANDIDATES, MESH_POINTS, SCENE, SPECTRUM, STAR_COUNT, STAR_IMAGES,
    STAR_INDEX, STAR_LIST, STAR_MESH, STAR_SUMS, STAR_TABLE, STARS, STRUCTURE, THICK_DISK,
    WAVE_HEIGHTS, WORKGROUP_SIZE,
};
use crate::shader::{ShaderText, Variant};
use lightfall_model::scene::Scene;
use lightfall_optics::stars::images::MeshLayout;
use wgpu::{BindGroupLayoutEntry, BindingType, BufferBindingType, ShaderStages};

/// A storage array that a kernel writes.
const WRITTEN: BindingType = BindingType::Buffer {
    ty: BufferBindingType::Storage { read_only: false },
    has_dynamic_offset: false,
    min_binding_size: None,
};

lightfall_model::words! {
    /// A kernel of stars, in the order in which they run. The word is the name of its entry point.
    pub enum StarKernel {
        /// Finds images by inversion.
        Solve = "solve",
        /// Traces the mesh.
        TraceMesh = "trace_mesh",
        /// Finds the candidates of each cell of the mesh.
        FindCandidates = "find_candidates",
        /// Finds the candidates of cells that see much of the sky.
        FindWideCandidates = "find_wide_candidates",
        /// Keeps the candidates in bent cells whose image may lie there.
        TestCandidates = "test_candidates",
        /// Finds the images of candidates in smooth cells, by interpolation.
        Interpolate = "interpolate",
        /// Finds those of the other candidates by rays.
        RefineImage = "refine_image",
        /// Dims images behind the disk.
        Dim = "dim",
        /// Draws images.
        Splat = "splat",
    }
}

impl StarKernel {
    /// The kernels that list candidates, which share one shader.
    pub const FINDING_CANDIDATES: [Self; 3] = [
        Self::FindCandidates,
        Self::FindWideCandidates,
        Self::TestCandidates,
    ];

    /// The kernels that draw the scene's stars.
    pub fn of(scene: &Scene) -> impl Iterator<Item = Self> {
        Self::finding_images(scene, Variant::uses_star_mesh(scene))
    }

    /// The kernels of a scene whose images a mesh finds, or an inversion.
    pub fn finding_images(scene: &Scene, by_mesh: bool) -> impl Iterator<Item = Self> {
        let has_disk = scene.disk.enabled;
        Self::ALL.into_iter().filter(move |kernel| match kernel {
            Self::Solve => !by_mesh,
            Self::Dim => has_disk,
            Self::Splat => true,
            _ => by_mesh,
        })
    }

    /// Whether it runs for every picture that has a mesh.
    pub fn is_of_mesh(self) -> bool {
        !matches!(self, Self::Solve | Self::Dim | Self::Splat)
    }

    /// Its WGSL text.
    pub fn source(self, scene: &Scene) -> String {
        self.text(scene).source()
    }

    /// Its WGSL text, by its parts.
    pub fn text(self, scene: &Scene) -> ShaderText {
        let projection = scene.camera.projection.of_picture();
        match Variant::of_kernel(self, scene) {
            Some(variant) => variant.text(),
            None if self == Self::Splat => splat_shader(projection),
            None => candidate_shader(),
        }
    }

    /// The bindings that it reads. Without lensing [`Self::Solve`] has no `STAR_TABLE`, and only matter
    /// with depth gives [`Self::Dim`] its tables.
    pub fn reads(self) -> &'static [u32] {
        match self {
            Self::Solve => &[SCENE, SPECTRUM, STARS, STAR_TABLE, STAR_LIST],
            Self::TraceMesh => &[SCENE, STAR_MESH],
            Self::FindCandidates | Self::FindWideCandidates => {
                &[SCENE, STARS, STAR_MESH, STAR_LIST, STAR_INDEX, MESH_POINTS]
            }
            Self::TestCandidates => &[SCENE, STARS, STAR_MESH, STAR_LIST, MESH_POINTS],
            Self::Interpolate | Self::RefineImage => &[
                SCENE,
                SPECTRUM,
                STARS,
                STAR_MESH,
                STAR_LIST,
                MESH_POINTS,
                CANDIDATES,
                CANDIDATE_COUNT,
            ],
            Self::Dim => &[
                SCENE,
                STARS,
                STRUCTURE,
                WAVE_HEIGHTS,
                THICK_DISK,
                STAR_COUNT,
            ],
            Self::Splat => &[SCENE, SPECTRUM, STARS, STAR_IMAGES, STAR_COUNT],
        }
    }

    /// The bindings that it writes.
    pub fn writes(self) -> &'static [u32] {
        match self {
            Self::Solve | Self::Interpolate | Self::RefineImage => &[STAR_IMAGES, STAR_COUNT],
            Self::TraceMesh => &[MESH_POINTS],
            Self::FindCandidates | Self::FindWideCandidates | Self::TestCandidates => {
                &[CANDIDATES, CANDIDATE_COUNT]
            }
            Self::Dim => &[STAR_IMAGES],
            Self::Splat => &[STAR_SUMS],
        }
    }

    /// The layout of its bindings.
    pub fn layout(self) -> Vec<BindGroupLayoutEntry> {
        let entry = |binding: &u32| ALL[*binding as usize].layout_entry(ShaderStages::COMPUTE);
        let written = self.writes().iter().map(|binding| BindGroupLayoutEntry {
            ty: WRITTEN,
            ..entry(binding)
        });
        self.reads().iter().map(entry).chain(written).collect()
    }

    /// The workgroups of a kernel of the mesh.
    pub fn mesh_workgroups(self, layout: &MeshLayout) -> u32 {
        match self {
            Self::TraceMesh => layout.point_count().div_ceil(WORKGROUP_SIZE),
            Self::FindWideCandidates => WIDE_GROUPS,
            Self::TestCandidates => TEST_GROUPS,
            _ => layout.cell_count().div_ceil(WORKGROUP_SIZE),
        }
    }

    /// The binding from which its number of workgroups is read, and from which byte on, if it is
    /// dispatched indirectly.
    pub fn indirect(self) -> Option<(u32, u64)> {
        match self {
            Self::Interpolate => Some((CANDIDATE_COUNT, 0)),
            Self::RefineImage => Some((CANDIDATE_COUNT, COUNT_SIZE)),
            Self::Dim | Self::Splat => Some((STAR_COUNT, 0)),
            _ => None,
        }
    }
}
