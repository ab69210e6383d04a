//! The pipelines that the scenes need. All pipelines of a scene are queued at the same time.

use super::pipeline::{Destination, pipeline_descriptor};
use super::shader::{GeodesicShaders, JoinedShader, SceneShaders};
use crate::antialias::AntialiasPass;
use crate::comparison::DifferencePass;
use crate::stars::{StarPass, StarPipelines};
use bevy::platform::collections::HashMap;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use lightfall_core::gpu::bindings;

/// The pipelines of the scenes that are to be drawn.
#[derive(Resource)]
pub(super) struct GeodesicPipelines {
    /// What all of them bind.
    pub(super) layout: BindGroupLayoutDescriptor,
    /// The pipelines of pictures queued so far, by shader and what they draw to.
    queued: HashMap<(AssetId<Shader>, Destination), CachedRenderPipelineId>,
    /// Those of the current scene, and of the pinned one.
    pub(super) current: Option<SidePipelines>,
    pub(super) pinned: Option<SidePipelines>,
}

/// The pipelines of a scene.
#[derive(Clone, Copy)]
pub(super) struct SidePipelines {
    pub(super) picture: CachedRenderPipelineId,
    /// What refines its edges, where there is anything to refine.
    pub(super) refine: Option<CachedComputePipelineId>,
    /// What draws its stars, where it has any.
    pub(super) stars: Option<StarPipelines>,
}

impl Default for GeodesicPipelines {
    fn default() -> Self {
        Self {
            layout: BindGroupLayoutDescriptor::new("geodesic layout", &bindings::picture_layout()),
            queued: HashMap::default(),
            current: None,
            pinned: None,
        }
    }
}

/// Queues the pipelines of the present shaders, and marks the shaders whose pipelines exist.
pub(super) fn queue_pipelines(
    If(shaders): If<Res<GeodesicShaders>>,
    If(mut pipelines): If<ResMut<GeodesicPipelines>>,
    difference: Option<Res<DifferencePass>>,
    If(mut antialias): If<ResMut<AntialiasPass>>,
    If(mut stars): If<ResMut<StarPass>>,
    cache: Res<PipelineCache>,
) {
    let pipelines = &mut *pipelines;
    let mut queue = PipelineQueue {
        layout: &pipelines.layout,
        pictures: &mut pipelines.queued,
        shows_difference: difference.is_some_and(|pass| pass.is_ready(&cache)),
        antialias: &mut antialias,
        stars: &mut stars,
        reloads: shaders.reloads,
        cache: &cache,
    };
    pipelines.current = Some(queue.all_of(&shaders.current));
    pipelines.pinned = shaders.pinned.as_ref().map(|pinned| queue.all_of(pinned));
}

/// The resources for queueing the pipelines of a scene.
struct PipelineQueue<'a> {
    layout: &'a BindGroupLayoutDescriptor,
    pictures: &'a mut HashMap<(AssetId<Shader>, Destination), CachedRenderPipelineId>,
    /// Whether the pass that shows a difference is ready.
    shows_difference: bool,
    antialias: &'a mut AntialiasPass,
    stars: &'a mut StarPass,
    /// How many times the shaders have been read again.
    reloads: u32,
    cache: &'a PipelineCache,
}

impl PipelineQueue<'_> {
    fn all_of(&mut self, shaders: &SceneShaders) -> SidePipelines {
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
        let id = self
            .antialias
            .refinement(self.layout, &joined.shader, self.cache);
        let exists = self.cache.get_compute_pipeline(id).is_some();
        joined.set_ready(exists && self.antialias.finds_edges(self.cache));
        id
    }

    fn stars(&mut self, scene: &SceneShaders) -> StarPipelines {
        let kernels = &scene.stars;
        let shaders = kernels
            .iter()
            .filter_map(|joined| Some((joined.star_kernel()?, &joined.shader)));
        let pipelines = self.stars.pipelines(
            shaders,
            scene.picture.projection(),
            self.reloads,
            self.cache,
        );
        let ready = pipelines.are_ready(self.cache);
        for joined in kernels {
            joined.set_ready(ready);
        }
        pipelines
    }
}
