//! The mean of several frames, each with its rays at other places within their pixels: a pass that
//! adds the light of a frame to the sum of those before it, and writes the mean to the picture.
//!
//! The sums are kept in two textures, of which each frame reads one and writes the other. So a frame
//! that is drawn twice is added once.

use crate::camera_markers::SceneCamera;
use crate::draw_request::DrawRequest;
use crate::full_screen_pass::{FullScreenPass, Stage, attachment};
use crate::given_light::traces_light;
use crate::graphics::{Graphics, TexturePair, picture_size};
use crate::live_shaders::add_shader;
use crate::progress::DrawnFrame;
use crate::refine::refine_edges;
use bevy::asset::uuid_handle;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::Accumulation;

const SHADER: Handle<Shader> = uuid_handle!("0f3f2f4e-93a8-4a52-8b93-2f7d6f1c0a35");

/// The entry point, which writes the picture and the sum.
const STAGE: Stage = (
    "accumulate",
    [
        Some(TextureFormat::Rgba16Float),
        Some(TextureFormat::Rgba32Float),
    ],
);

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(super) struct AccumulatePass {
    full_screen: FullScreenPass<Accumulation>,
    /// The sums after an even and after an odd frame. `None` while frames are shown as they are.
    sums: Option<TexturePair>,
}

pub(super) fn plugin(app: &mut App) {
    add_shader(
        app,
        &SHADER,
        Accumulation::shader(),
        "lightfall/accumulate.wgsl",
    );
    app.sub_app_mut(RenderApp)
        .add_systems(RenderStartup, create_accumulate_pass)
        .add_systems(
            Render,
            prepare_accumulate_pass.in_set(RenderSystems::PrepareResources),
        )
        .add_systems(
            Core3d,
            accumulate_frame
                .in_set(Core3dSystems::MainPass)
                .after(refine_edges)
                .run_if(traces_light),
        );
}

fn create_accumulate_pass(mut commands: Commands) {
    commands.insert_resource(AccumulatePass {
        full_screen: FullScreenPass::new("accumulation layout", SHADER, 2),
        sums: None,
    });
}

/// Creates the sums and the pipeline of a mean, and drops the sums where a frame is shown as it is.
fn prepare_accumulate_pass(
    (If(request), If(mut pass)): (If<Res<DrawRequest>>, If<ResMut<AccumulatePass>>),
    graphics: Graphics,
) {
    let AccumulatePass { full_screen, sums } = &mut *pass;
    let Some(frame) = request.averaged_frame() else {
        *sums = None;
        return;
    };
    full_screen.queue(STAGE, &graphics.cache);
    full_screen.write(Accumulation { frame }, &graphics);
    TexturePair::create_or_keep(
        sums,
        &graphics.device,
        ["sum of even frames", "sum of odd frames"],
        request.picture_size(),
        TextureFormat::Rgba32Float,
    );
}

/// Adds the frame to the mean, and shows it.
pub(super) fn accumulate_frame(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    (If(request), If(pass)): (If<Res<DrawRequest>>, If<Res<AccumulatePass>>),
    mut drawn: ResMut<DrawnFrame>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let target = view.into_inner();
    let sums = pass.sums.as_ref();
    let (true, Some(frame), Some(sums)) = (
        drawn.shows_scene(),
        request.averaged_frame(),
        sums.filter(|sums| sums.size == picture_size(target)),
    ) else {
        return;
    };
    // The picture's two textures change places only if the pass draws.
    if pass.full_screen.pipeline(STAGE, &cache).is_none() {
        return;
    }
    let after = &sums.views[frame as usize % 2];
    let before = &sums.views[(frame as usize + 1) % 2];
    let picture = target.post_process_write();
    drawn.is_added = pass.full_screen.draw(
        &mut context,
        &cache,
        STAGE,
        &[picture.source, before],
        &[attachment(picture.destination), attachment(after)],
    );
}
