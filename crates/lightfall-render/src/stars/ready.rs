//! The passes of a scene's stars.

use super::buffers::Drawn;
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderQueue;
use lightfall_core::gpu::bindings::{CANDIDATE_COUNT, STAR_COUNT, STAR_SUMS};
use lightfall_core::gpu::stars::{
    CANDIDATE_COUNT_SIZE, EMPTY_COUNT, StarKernel, empty_candidate_count, solve_workgroups,
};

/// A scene's stars whose passes can run.
pub(super) struct ReadyStars<'a> {
    pub(super) kernels: Vec<(StarKernel, &'a ComputePipeline)>,
    pub(super) drawn: &'a Drawn,
    /// How many candidates rays follow at most.
    pub(super) max_traced: u32,
}

/// What the kernels have to compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stale {
    /// The images and the sums.
    All,
    /// The sums: another part of the same picture is drawn.
    Sums,
}

impl ReadyStars<'_> {
    /// How many times [`dispatch`](Self::dispatch) has to run: once for each picture that has a mesh, if
    /// the images are stale.
    pub(super) fn rounds(&self, stale: Stale) -> usize {
        match stale {
            Stale::All => self.drawn.rounds,
            Stale::Sums => 1,
        }
    }

    /// Empties the list of candidates for another round.
    pub(super) fn clear_candidates(&self, encoder: &mut CommandEncoder) {
        if let Some(count) = self.drawn.buffer(CANDIDATE_COUNT) {
            let none = &self.drawn.no_candidates;
            encoder.copy_buffer_to_buffer(none, 0, count, 0, CANDIDATE_COUNT_SIZE);
        }
    }

    /// Empties what is stale of the lists and the sums.
    pub(super) fn clear(&self, stale: Stale, encoder: &mut CommandEncoder, queue: &RenderQueue) {
        let none: Vec<u8> = EMPTY_COUNT.iter().flat_map(|n| n.to_le_bytes()).collect();
        for (binding, buffer) in &self.drawn.buffers {
            match *binding {
                STAR_SUMS => encoder.clear_buffer(buffer, 0, None),
                _ if stale == Stale::Sums => {}
                STAR_COUNT => queue.write_buffer(buffer, 0, &none),
                CANDIDATE_COUNT => {
                    let none = empty_candidate_count(self.max_traced);
                    queue.write_buffer(buffer, 0, &none);
                    queue.write_buffer(&self.drawn.no_candidates, 0, &none);
                }
                _ => {}
            }
        }
    }

    /// Finds the images of a round, if they are stale. The last round dims those behind the disk and draws
    /// all of them.
    pub(super) fn dispatch(&self, (stale, round): (Stale, usize), pass: &mut ComputePass) {
        let is_last = round + 1 == self.rounds(stale);
        let runs = |kernel: StarKernel| match stale {
            Stale::All => is_last || kernel.is_of_mesh(),
            Stale::Sums => kernel == StarKernel::Splat,
        };
        for (kernel, pipeline) in self.kernels.iter().filter(|(kernel, _)| runs(*kernel)) {
            let groups = &self.drawn.bind_groups[*kernel as usize];
            let Some(bind_group) = groups.get(if kernel.is_of_mesh() { round } else { 0 }) else {
                continue;
            };
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, bind_group, &[]);
            let indirect = kernel
                .indirect()
                .and_then(|(at, start)| Some((self.drawn.buffer(at)?, start)));
            match (indirect, kernel, &self.drawn.mesh) {
                (Some((count, start)), ..) => pass.dispatch_workgroups_indirect(count, start),
                (None, kernel, Some(layout)) => {
                    pass.dispatch_workgroups(kernel.mesh_workgroups(layout), 1, 1);
                }
                (None, _, None) => {
                    let [x, y] = solve_workgroups(self.drawn.list.stars.len());
                    pass.dispatch_workgroups(x, y, 1);
                }
            }
        }
    }
}
