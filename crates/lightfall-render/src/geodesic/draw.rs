//! Draws the scenes: a full-screen triangle at the far plane, or one over a texture of its own.

use super::pass::GeodesicPass;
use super::pipeline::Destination;
use super::side::Side;
use crate::antialias::AntialiasPass;
use crate::camera_markers::SceneCamera;
use crate::comparison::DifferencePass;
use crate::full_screen_pass::attachment;
use crate::graphics::{picture_size, run_render_pass};
use crate::progress::DrawnFrame;
use bevy::prelude::*;
use bevy::render::render_phase::TrackedRenderPass;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, ViewQuery};
use bevy::render::view::{ViewDepthTexture, ViewTarget};
use lightfall_core::gpu::bands;

pub(super) fn draw_geodesic_pass(
    view: ViewQuery<(&ViewTarget, &ViewDepthTexture), With<SceneCamera>>,
    If(pass): If<Res<GeodesicPass>>,
    mut frame: ResMut<DrawnFrame>,
    (difference, antialias): (Option<Res<DifferencePass>>, Option<Res<AntialiasPass>>),
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let (target, depth) = view.into_inner();
    frame.is_drawn = match (pass.destination, &pass.pinned) {
        (Destination::Light, Some((pinned, _))) => {
            let lights = difference.as_ref().and_then(|pass| pass.lights.as_ref());
            lights.is_some_and(|lights| {
                let [to_current, to_pinned] =
                    lights.views.each_ref().map(|view| (view, lights.size));
                draw_light(&mut context, &cache, "geodesic", &pass.current, to_current)
                    && draw_light(&mut context, &cache, "geodesic_pinned", pinned, to_pinned)
            })
        }
        (Destination::Light, None) | (Destination::Compute(_), _) => false,
        // A pipeline for another number of samples waits until the target has as many.
        (Destination::Picture { samples, .. }, _)
            if (samples > 1) != target.sampled_main_texture().is_some() =>
        {
            false
        }
        (Destination::Picture { traits, .. }, _) => {
            let second = antialias.as_ref().filter(|_| traits.is_some());
            let second = second.and_then(|pass| pass.attachment(target));
            // So does a pipeline with a second target.
            second.is_some() == traits.is_some()
                && draw_picture(&mut context, &cache, &pass, (target, second), depth)
        }
    };
}

/// Draws the current scene to the picture, and the pinned one left of the divider. Returns whether
/// all is drawn.
fn draw_picture(
    context: &mut RenderContext,
    cache: &PipelineCache,
    pass: &GeodesicPass,
    (target, second): (&ViewTarget, Option<RenderPassColorAttachment>),
    depth: &ViewDepthTexture,
) -> bool {
    let Some(current) = pass.current.ready(cache) else {
        return false;
    };
    let pinned = match &pass.pinned {
        Some((side, layout)) if layout.divider().is_some() => {
            let Some(ready) = side.ready(cache) else {
                return false;
            };
            Some(ready)
        }
        _ => None,
    };
    let size = picture_size(target);
    let attachments: Vec<_> = [Some(target.get_color_attachment())]
        .into_iter()
        .chain(second.map(Some))
        .collect();
    let depth = Some(depth.get_attachment(StoreOp::Store));
    let [left, right] = pass.columns(size.x);
    let pinned = pinned.map(|ready| (ready, left));
    run_render_pass(context, "geodesic", &attachments, depth, |render_pass| {
        for (ready, columns) in pinned.into_iter().chain([(current, right)]) {
            if columns.is_empty() {
                continue;
            }
            // Not a scissor rectangle: some drivers let its edge cut through the samples of a pixel.
            let (left, width) = (columns.start as f32, columns.len() as f32);
            render_pass.set_viewport(left, 0.0, width, size.y as f32, 0.0, 1.0);
            draw_in_bands(render_pass, size, ready);
        }
    });
    true
}

/// Draws one scene to a texture of its own. Returns whether it is drawn.
fn draw_light(
    context: &mut RenderContext,
    cache: &PipelineCache,
    name: &'static str,
    side: &Side,
    (texture, size): (&TextureView, UVec2),
) -> bool {
    let Some(ready) = side.ready(cache) else {
        return false;
    };
    run_render_pass(context, name, &[attachment(texture)], None, |render_pass| {
        draw_in_bands(render_pass, size, ready);
    });
    true
}

/// Draws the triangle band by band on a target of this size, with at most `most` pixels a band.
fn draw_in_bands<'a>(
    render_pass: &mut TrackedRenderPass<'a>,
    size: UVec2,
    (pipeline, bind_group, most): (&'a RenderPipeline, &'a BindGroup, u32),
) {
    render_pass.set_render_pipeline(pipeline);
    render_pass.set_bind_group(0, bind_group, &[]);
    for (top, rows) in bands(size.x, size.y, most) {
        render_pass.set_scissor_rect(0, top, size.x, rows);
        render_pass.draw(0..3, 0..1);
    }
}
