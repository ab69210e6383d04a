//! The buffers that depend on the length of a list of stars or the size of a picture.

use super::list::GpuStarList;
use crate::graphics::create_buffer;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderDevice;
use lightfall_core::gpu::bindings::{
    CANDIDATE_COUNT, CANDIDATES, MESH_POINTS, STAR_COUNT, STAR_IMAGES, STAR_SUMS,
};
use lightfall_core::gpu::stars::{
    CANDIDATE_COUNT_SIZE, COUNT_SIZE, StarKernel, candidates_size, images_size, mesh_points_size,
    sums_size,
};
use lightfall_core::optics::stars::images::MeshLayout;
use lightfall_core::scene::Part;
use std::sync::Arc;

/// A list of stars, and what its images are drawn with.
pub(super) struct Drawn {
    pub(super) list: Arc<GpuStarList>,
    /// The size of the picture, and the part that the sums are of.
    pub(super) size: UVec2,
    pub(super) part: Option<Part>,
    /// Unless images are found by inversion.
    pub(super) mesh: Option<MeshLayout>,
    /// The buffers that the kernels write.
    pub(super) buffers: Vec<(u32, Buffer)>,
    /// The bindings of the kernels, in the order of [`StarKernel::ALL`]: those of a mesh once for each
    /// round.
    pub(super) bind_groups: [Vec<BindGroup>; StarKernel::ALL.len()],
    /// How many pictures have a mesh: one, or the sides of a cube.
    pub(super) rounds: usize,
    /// An empty list of candidates, for each round but the first.
    pub(super) no_candidates: Buffer,
}

impl Drawn {
    /// The buffers for a list and a size, without the sums.
    pub(super) fn new(
        list: Arc<GpuStarList>,
        size: UVec2,
        (mesh, rounds): (Option<MeshLayout>, usize),
        device: &RenderDevice,
    ) -> Self {
        let mut sizes = vec![
            (STAR_IMAGES, images_size(&list.stars)),
            (STAR_COUNT, COUNT_SIZE),
        ];
        if let Some(layout) = &mesh {
            sizes.extend([
                (MESH_POINTS, mesh_points_size(layout)),
                (CANDIDATES, candidates_size(&list.stars)),
                (CANDIDATE_COUNT, CANDIDATE_COUNT_SIZE),
            ]);
        }
        let buffers = sizes
            .into_iter()
            .map(|(binding, size)| (binding, create(device, size)));
        Self {
            list,
            size,
            part: None,
            mesh,
            buffers: buffers.collect(),
            bind_groups: [const { Vec::new() }; StarKernel::ALL.len()],
            rounds,
            no_candidates: create_buffer(
                device,
                "no candidates",
                CANDIDATE_COUNT_SIZE,
                BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            ),
        }
    }

    /// Makes the sums as large as the part of the picture needs. Returns whether they are new.
    pub(super) fn make_room_for_sums(&mut self, device: &RenderDevice) -> bool {
        let needed = sums_size(self.part.map_or(self.size, |part| part.size));
        let old = self.buffer(STAR_SUMS);
        if old.is_some_and(|sums| sums.size() >= needed) {
            return false;
        }
        self.buffers.retain(|(binding, _)| *binding != STAR_SUMS);
        self.buffers.push((STAR_SUMS, create(device, needed)));
        true
    }

    /// A buffer that the kernels write.
    pub(super) fn buffer(&self, binding: u32) -> Option<&Buffer> {
        let found = self.buffers.iter().find(|(at, _)| *at == binding);
        found.map(|(_, buffer)| buffer)
    }
}

/// A buffer that the kernels write.
fn create(device: &RenderDevice, size: u64) -> Buffer {
    let usage = BufferUsages::STORAGE | BufferUsages::INDIRECT | BufferUsages::COPY_DST;
    create_buffer(device, "stars", size, usage)
}
