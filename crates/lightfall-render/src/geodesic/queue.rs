//! The pipelines that the scenes need. All pipelines of a scene are queued at the same time.

use super::pipeline::{Destination, pipeline_descriptor};
use super::shader::{JoinedShader, SceneShaders};
use crate::antialias::refinement_layout;
use crate::graphics::ComputePipelines;
use crate::stars::StarPipelines;
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::render_resource::*;

/// The pipelines of pictures queued so far, by shader and what they draw to.
pub(super) type PicturePipelines = HashMap<(AssetId<Shader>, Destination), CachedRenderPipelineId>;

/// The pipelines of a scene.
#[derive(Clone, Copy)]
pub(super) struct SidePipelines {
    pub(super) picture: CachedRenderPipelineId,
    /// What refines its edges, where there is anything to refine.
    pub(super) refine: Option<CachedComputePipelineId>,
    /// What draws its stars, where it has any.
    pub(super) stars: Option<StarPipelines>,
}

/// The resources for queueing the pipelines of a scene.
pub(super) struct PipelineQueue<'a> {
    /// What the pipelines bind.
    pub(super) layout: &'a BindGroupLayoutDescriptor,
    pub(super) pictures: &'a mut PicturePipelines,
    pub(super) kernels: &'a mut ComputePipelines,
    /// Whether the pass that shows a difference is ready.
    pub(super) shows_difference: bool,
    /// Whether the pass that finds edges is ready.
    pub(super) finds_edges: bool,
    /// How many times the shaders have been read again.
    pub(super) reloads: u32,
    pub(super) cache: &'a PipelineCache,
}

impl PipelineQueue<'_> {
    /// The pipelines of a scene's shaders. Marks the shaders whose pipelines exist.
    pub(super) fn all_of(&mut self, shaders: &SceneShaders) -> SidePipelines {
        SidePipelines {
            picture: self.picture(&shaders.picture),
            refine: shaders
                .refine
                .as_ref()
                .map(|joined| self.refinement(joined)),
            stars: (!shaders.stars.is_empty()).then(|| self.stars(shaders)),
        }
    }

    fn picture(&mut self, joined: &JoinedShader) -> CachedRenderPipelineId {
        let (shader, destination) = (&joined.shader, joined.destination);
        let id = *self
            .pictures
            .entry((shader.id(), destination))
            .or_insert_with(|| {
                let layout = self.layout.clone();
                let descriptor = pipeline_descriptor(layout, shader.clone(), destination);
                self.cache.queue_render_pipeline(descriptor)
            });
        let exists = self.cache.get_render_pipeline(id).is_some();
        joined.set_ready(exists && (destination != Destination::Light || self.shows_difference));
        id
    }

    fn refinement(&mut self, joined: &JoinedShader) -> CachedComputePipelineId {
        let layouts = [self.layout, &refinement_layout()];
        let id = self
            .kernels
            .queue(self.cache, "refine", &layouts, &joined.shader);
        let exists = self.cache.get_compute_pipeline(id).is_some();
        joined.set_ready(exists && self.finds_edges);
        id
    }

    fn stars(&mut self, scene: &SceneShaders) -> StarPipelines {
        let kernels = &scene.stars;
        let shaders = kernels
            .iter()
            .filter_map(|joined| Some((joined.star_kernel()?, &joined.shader)));
        let pipelines = StarPipelines::queue(
            shaders,
            scene.picture.projection(),
            self.reloads,
            self.kernels,
            self.cache,
        );
        let ready = pipelines.are_ready(self.cache);
        for joined in kernels {
            joined.set_ready(ready);
        }
        pipelines
    }
}
