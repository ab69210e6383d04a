//! The difference: a pass that reads the light of the two scenes and writes how they differ,
//! amplified, to the HDR picture. Its textures exist only while a difference is shown.

use super::compared_scene::{ComparedScene, ComparisonLayout};
use crate::camera_markers::SceneCamera;
use crate::full_screen_pass::{FullScreenPass, Stage};
use crate::graphics::{Graphics, TexturePair};
use crate::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{RenderApp, RenderStartup};
use lightfall_core::gpu::Difference;

const SHADER: Handle<Shader> = uuid_handle!("b2a4e5a1-3c55-4b57-8f0d-6a53c2a6e0d4");

const STAGE: Stage = ("difference", [Some(TextureFormat::Rgba16Float), None]);

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(crate) struct DifferencePass {
    full_screen: FullScreenPass<Difference>,
    /// The textures that the current and the pinned scene are drawn to.
    pub(crate) lights: Option<TexturePair>,
}

impl DifferencePass {
    /// Whether its pipeline exists.
    pub(crate) fn is_ready(&self, cache: &PipelineCache) -> bool {
        self.full_screen.pipeline(STAGE, cache).is_some()
    }
}

pub(super) fn plugin(app: &mut App) {
    add_shader(
        app,
        &SHADER,
        Difference::shader(),
        "lightfall/difference.wgsl",
    );
    app.sub_app_mut(RenderApp)
        .add_systems(RenderStartup, create_difference_pass);
}

fn create_difference_pass(mut commands: Commands) {
    commands.insert_resource(DifferencePass {
        full_screen: FullScreenPass::new("difference layout", SHADER, 2),
        lights: None,
    });
}

/// Creates the textures and the pipeline of a difference, and drops the textures when none is shown.
pub(crate) fn prepare_difference(
    compared: Res<ComparedScene>,
    If(mut pass): If<ResMut<DifferencePass>>,
    graphics: Graphics,
) {
    let Some((scene, ComparisonLayout::Difference { gain })) = compared.drawn() else {
        pass.lights = None;
        return;
    };
    let DifferencePass {
        full_screen,
        lights,
    } = &mut *pass;
    full_screen.queue(STAGE, &graphics.cache);
    full_screen.write(Difference { gain }, &graphics);
    TexturePair::create_or_keep(
        lights,
        &graphics.device,
        ["light of the scene", "light of the pinned scene"],
        scene.picture.size(),
        TextureFormat::Rgba16Float,
    );
}

/// Writes the difference to the picture, also where the probe is: it is the same in both scenes.
pub(crate) fn draw_difference(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    compared: Res<ComparedScene>,
    If(pass): If<Res<DifferencePass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let target = view.into_inner();
    // The pipeline writes one sample a pixel.
    let (true, Some(lights), None) = (
        compared.is_difference(),
        &pass.lights,
        target.sampled_main_texture(),
    ) else {
        return;
    };
    let [current, pinned] = &lights.views;
    pass.full_screen.draw(
        &mut context,
        &cache,
        STAGE,
        &[pinned, current],
        &[Some(target.get_color_attachment())],
    );
}
