//! The resources of the geodesic pass on the GPU: the scenes that it draws.

use super::pipeline::Destination;
use super::queue::PicturePipelines;
use super::side::{Shared, Side};
use crate::comparison::{ComparedScene, ComparisonLayout};
use crate::draw_request::DrawRequest;
use crate::graphics::Graphics;
use crate::stars::SceneStars;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use lightfall_core::gpu::Drawable;
use std::ops::Range;

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(crate) struct GeodesicPass {
    /// What all pipelines bind.
    pub(super) layout: BindGroupLayoutDescriptor,
    pub(super) pipelines: PicturePipelines,
    pub(super) shared: Shared,
    pub(super) current: Side,
    /// The pinned scene, and where the two are drawn; `None` while nothing is compared.
    pub(super) pinned: Option<(Side, ComparisonLayout)>,
    /// What the pipelines of the written scenes draw to.
    pub(super) destination: Destination,
    /// Whether a scene has changed since it was written.
    pub(super) changed: bool,
}

impl GeodesicPass {
    /// The columns of a picture of this width that show the pinned scene and the current one.
    pub(super) fn columns(&self, width: u32) -> [Range<u32>; 2] {
        let layout = self.pinned.as_ref().map(|(_, layout)| *layout);
        let divider = layout.and_then(ComparisonLayout::divider).unwrap_or(0);
        let divider = divider.min(width);
        [0..divider, divider..width]
    }

    /// The stars of the scenes.
    pub(crate) fn scene_stars(&self) -> impl Iterator<Item = &SceneStars> {
        let pinned = self.pinned.as_ref().map(|(side, _)| side);
        let sides = pinned.into_iter().chain([&self.current]);
        sides.filter_map(Side::stars)
    }

    /// Goes on to another one of the frames that are averaged.
    pub(super) fn set_frame(
        &mut self,
        scene: &Drawable,
        compared: &ComparedScene,
        request: Option<&DrawRequest>,
        graphics: &Graphics,
    ) {
        let current = compared.drawn_current(scene);
        self.current.set_frame(current, request, graphics);
        if let (Some((side, _)), Some((pinned, _))) = (&mut self.pinned, compared.drawn()) {
            side.set_frame(pinned, request, graphics);
        }
    }

    /// The pipelines and bindings that refine the scenes, with the columns of each scene.
    pub(crate) fn refinements<'a>(
        &'a self,
        cache: &'a PipelineCache,
        width: u32,
    ) -> impl Iterator<Item = (&'a ComputePipeline, &'a BindGroup, Range<u32>)> {
        let [left, right] = self.columns(width);
        let pinned = self.pinned.as_ref().map(|(side, _)| (side, left));
        pinned
            .into_iter()
            .chain([(&self.current, right)])
            .filter(|(_, columns)| !columns.is_empty())
            .filter_map(|(side, columns)| {
                let (pipeline, bind_group) = side.refinement(cache)?;
                Some((pipeline, bind_group, columns))
            })
    }
}
