//! The kernels of stars: their layouts and pipelines.

use crate::graphics::ComputePipelines;
use crate::live_shaders::add_shader;
use bevy::asset::uuid::Uuid;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use lightfall_core::gpu::stars::{StarKernel, candidate_shader, splat_shader};
use lightfall_core::scene::Projection;
use std::marker::PhantomData;

/// The shader that lists candidates.
const CANDIDATE_SHADER: u128 = 0x5a1de0c4_3c8e_4d0b_8a4e_b0a6f3a7d911;
/// The first of the shaders that draw images, which have consecutive numbers, one for each projection.
const SPLAT_SHADERS: u128 = 0x0f3b6c55_7a10_4a5e_9d3c_51d7a6f0c2b8;

/// The pipelines of a scene's stars, in the order of [`StarKernel::ALL`]; `None` where the scene has no
/// use for a kernel.
#[derive(Clone, Copy)]
pub(crate) struct StarPipelines {
    ids: [Option<CachedComputePipelineId>; StarKernel::ALL.len()],
    /// How often their shaders have been reloaded.
    pub(super) reloads: u32,
}

/// The layout of a kernel's bindings.
pub(super) fn layout(kernel: StarKernel) -> BindGroupLayoutDescriptor {
    BindGroupLayoutDescriptor::new(kernel.word(), &kernel.layout())
}

impl StarPipelines {
    /// The pipelines with these shaders of kernels, and with those that are the same for all scenes
    /// with this projection.
    pub(crate) fn queue<'a>(
        shaders: impl Iterator<Item = (StarKernel, &'a Handle<Shader>)> + Clone,
        projection: Projection,
        reloads: u32,
        pipelines: &mut ComputePipelines,
        cache: &PipelineCache,
    ) -> Self {
        let by_mesh = shaders
            .clone()
            .any(|(kernel, _)| kernel == StarKernel::TraceMesh);
        let finding = by_mesh.then_some(StarKernel::FINDING_CANDIDATES);
        let finding = finding.into_iter().flatten();
        let candidates = handle(CANDIDATE_SHADER);
        let splat = splat_handle(projection);
        let all = shaders
            .map(|(kernel, shader)| (kernel, shader.clone()))
            .chain(finding.map(|kernel| (kernel, candidates.clone())))
            .chain([(StarKernel::Splat, splat)]);
        let mut ids = [None; StarKernel::ALL.len()];
        for (kernel, shader) in all {
            let id = pipelines.queue(cache, kernel.word(), &[&layout(kernel)], &shader);
            ids[kernel as usize] = Some(id);
        }
        Self { ids, reloads }
    }

    /// The kernels and their pipelines, in the order in which they run.
    pub(super) fn kernels(self) -> impl Iterator<Item = (StarKernel, CachedComputePipelineId)> {
        let pairs = StarKernel::ALL.into_iter().zip(self.ids);
        pairs.filter_map(|(kernel, id)| Some((kernel, id?)))
    }

    /// Whether all of them exist.
    pub(crate) fn are_ready(self, cache: &PipelineCache) -> bool {
        self.kernels()
            .all(|(_, id)| cache.get_compute_pipeline(id).is_some())
    }
}

/// The shader with this number.
fn handle(number: u128) -> Handle<Shader> {
    Handle::Uuid(Uuid::from_u128(number), PhantomData)
}

/// The shader that draws images in a projection.
fn splat_handle(projection: Projection) -> Handle<Shader> {
    handle(SPLAT_SHADERS + projection as u128)
}

/// Adds the shaders that are the same for all scenes with the same projection.
pub(super) fn add_shaders(app: &mut App) {
    let candidates = handle(CANDIDATE_SHADER);
    let text = candidate_shader();
    add_shader(app, &candidates, text, "lightfall/find_candidates.wgsl");
    let of_pictures = Projection::ALL
        .into_iter()
        .filter(|projection| projection.of_picture() == *projection);
    for projection in of_pictures {
        let splat = splat_handle(projection);
        let text = splat_shader(projection);
        add_shader(app, &splat, text, "lightfall/splat.wgsl");
    }
}
