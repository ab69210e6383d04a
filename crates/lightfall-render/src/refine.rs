//! The passes that smooth edges: EDGES marks the pixels whose neighbours show something else, and
//! REFINE traces more rays through them and writes the mean of their light to the picture. Nothing
//! waits for the CPU: the number of marked pixels stays on the GPU.
//!
//! Of two scenes side by side, each has marks of its own, and neither looks across the divider.

use crate::antialias::{AntialiasPass, edges_layout, refinement_layout};
use crate::camera_markers::SceneCamera;
use crate::draw_request::DrawRequest;
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::geodesic::GeodesicPass;
use crate::given_light::traces_light;
use crate::graphics::run_compute_pass;
use crate::progress::DrawnFrame;
use bevy::core_pipeline::core_3d::main_transparent_pass_3d;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::RenderApp;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderQueue, ViewQuery};
use bevy::render::view::ViewTarget;
use lightfall_core::gpu::Edges;
use lightfall_core::gpu::bindings::{LIST, PICTURE, SEARCH, TRAITS, WORK};

pub(super) fn plugin(app: &mut App) {
    app.sub_app_mut(RenderApp).add_systems(
        Core3d,
        refine_edges
            .in_set(Core3dSystems::MainPass)
            .after(main_transparent_pass_3d)
            .run_if(traces_light),
    );
}

/// Finds and refines the edges of the picture that this frame has drawn.
pub(super) fn refine_edges(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    (If(geodesic), If(pass)): (If<Res<GeodesicPass>>, If<Res<AntialiasPass>>),
    If(request): If<Res<DrawRequest>>,
    (drawn, scene, part): (Res<DrawnFrame>, Res<DrawnScene>, Res<DrawnPart>),
    cache: Res<PipelineCache>,
    queue: Res<RenderQueue>,
    mut context: RenderContext,
) {
    let target = view.into_inner();
    let Some(targets) = pass.0.as_ref().filter(|targets| targets.fits(target)) else {
        return;
    };
    let Some(edges) = targets.edges_pipeline(&cache) else {
        return;
    };
    if !drawn.is_drawn {
        return;
    }
    // All frames of a mean refine the pixels that the first one has marked. Marks that depended on
    // each frame's own rays would make the mean wrong: bright rays would be refined, dark ones not.
    let searches = request.averaged_frame().is_none_or(|frame| frame == 0);
    let search = Edges { size: targets.size };
    // A part has the neighbours of its outermost columns in its apron.
    let goes_around = scene.camera.projection.goes_around() && part.drawn().is_none();
    let refinements: Vec<_> = geodesic
        .refinements(&cache, targets.size.x)
        .zip(&targets.marks)
        .map(|(refinement, marks)| {
            let (_, _, columns) = &refinement;
            if searches {
                let quick = u32::from(request.is_quick());
                let around = u32::from(goes_around && columns.len() == targets.size.x as usize);
                let wanted = [columns.start, columns.end, quick, around].map(u32::to_le_bytes);
                queue.write_buffer(&marks.search, 0, &wanted.concat());
                queue.write_buffer(&marks.work, 0, &search.no_work());
            }
            (refinement, marks)
        })
        .collect();
    if refinements.is_empty() {
        return;
    }
    let edges_layout = cache.get_bind_group_layout(&edges_layout(targets.samples));
    let refine_layout = cache.get_bind_group_layout(&refinement_layout());
    let device = context.render_device().clone();
    let find_edges = |compute_pass: &mut ComputePass| {
        compute_pass.set_pipeline(edges);
        for ((_, _, columns), marks) in &refinements {
            let bindings = device.create_bind_group(
                "edges bindings",
                &edges_layout,
                &BindGroupEntries::with_indices((
                    (TRAITS, &targets.traits),
                    (SEARCH, marks.search.as_entire_binding()),
                    (WORK, marks.work.as_entire_binding()),
                    (LIST, marks.list.as_entire_binding()),
                )),
            );
            compute_pass.set_bind_group(0, &bindings, &[]);
            let groups = search.groups(columns.len() as u32);
            compute_pass.dispatch_workgroups(groups.x, groups.y, 1);
        }
    };
    if searches {
        run_compute_pass(&mut context, "edges", find_edges);
    }
    run_compute_pass(&mut context, "refine", |compute_pass| {
        for ((pipeline, scene, _), marks) in &refinements {
            let bindings = device.create_bind_group(
                "refinement bindings",
                &refine_layout,
                &BindGroupEntries::with_indices((
                    (WORK, marks.work.as_entire_binding()),
                    (LIST, marks.list.as_entire_binding()),
                    (PICTURE, target.main_texture_view()),
                )),
            );
            compute_pass.set_pipeline(pipeline);
            compute_pass.set_bind_group(0, *scene, &[]);
            compute_pass.set_bind_group(1, &bindings, &[]);
            compute_pass.dispatch_workgroups_indirect(&marks.work, 0);
        }
    });
}
