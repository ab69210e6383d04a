//! A pass that draws one full-screen triangle to one texture, without depth.

use bevy::render::diagnostic::RecordDiagnostics;
use bevy::render::render_phase::TrackedRenderPass;
use bevy::render::render_resource::{
    BindGroup, RenderPassColorAttachment, RenderPassDescriptor, RenderPipeline,
};
use bevy::render::renderer::RenderContext;

/// Runs a pass with one pipeline and one bind group, measured under its name. `draw` issues the
/// draw calls.
pub(super) fn run_full_screen_pass(
    context: &mut RenderContext,
    name: &'static str,
    target: RenderPassColorAttachment,
    pipeline: &RenderPipeline,
    bind_group: &BindGroup,
    draw: impl FnOnce(&mut TrackedRenderPass),
) {
    let diagnostics = context.diagnostic_recorder();
    let diagnostics = diagnostics.as_deref();
    let mut render_pass = context.begin_tracked_render_pass(RenderPassDescriptor {
        label: Some(name),
        color_attachments: &[Some(target)],
        depth_stencil_attachment: None,
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    });
    let span = diagnostics.pass_span(&mut render_pass, name);
    render_pass.set_render_pipeline(pipeline);
    render_pass.set_bind_group(0, bind_group, &[]);
    draw(&mut render_pass);
    span.end(&mut render_pass);
}

/// Draws one triangle that covers the target.
pub(super) fn draw_triangle(render_pass: &mut TrackedRenderPass) {
    render_pass.draw(0..3, 0..1);
}
