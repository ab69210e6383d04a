//! The difference: a pass that reads the light of the two scenes and writes how they differ,
//! amplified, to the HDR picture. Its textures exist only while a difference is shown.

use super::compared_scene::{ComparedScene, ComparisonLayout};
use crate::camera_markers::SceneCamera;
use crate::full_screen_pass::{FullScreenPass, Stage};
use crate::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{RenderApp, RenderStartup};
use lightfall_core::gpu::Difference;

const SHADER: Handle<Shader> = uuid_handle!("b2a4e5a1-3c55-4b57-8f0d-6a53c2a6e0d4");

const STAGE: Stage = ("difference", [Some(TextureFormat::Rgba16Float), None]);

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(crate) struct DifferencePass {
    full_screen: FullScreenPass<Difference>,
    lights: Option<Lights>,
}

/// The light of each of the two scenes.
pub(crate) struct Lights {
    pub(crate) size: UVec2,
    pub(crate) pinned: TextureView,
    pub(crate) current: TextureView,
}

impl DifferencePass {
    /// Whether its pipeline exists.
    pub(crate) fn is_ready(&self, cache: &PipelineCache) -> bool {
        self.full_screen.pipeline(STAGE, cache).is_some()
    }

    /// The textures that the two scenes are drawn to.
    pub(crate) fn lights(&self) -> Option<&Lights> {
        self.lights.as_ref()
    }
}

pub(super) fn plugin(app: &mut App) {
    add_shader(
        app,
        &SHADER,
        Difference::shader(),
        "lightfall/difference.wgsl",
    );
    if let Some(render_app) = app.get_sub_app_mut(RenderApp) {
        render_app.add_systems(RenderStartup, create_difference_pass);
    }
}

fn create_difference_pass(mut commands: Commands) {
    commands.insert_resource(DifferencePass {
        full_screen: FullScreenPass::new("difference layout", SHADER, 2),
        lights: None,
    });
}

/// Creates what a difference needs, and drops the textures when none is shown.
pub(crate) fn prepare_difference(
    compared: Res<ComparedScene>,
    pass: Option<ResMut<DifferencePass>>,
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
) {
    let Some(mut pass) = pass else { return };
    let Some((scene, ComparisonLayout::Difference { gain })) = compared.drawn() else {
        if pass.lights.is_some() {
            pass.lights = None;
        }
        return;
    };
    let DifferencePass {
        full_screen,
        lights,
    } = &mut *pass;
    full_screen.queue(STAGE, &cache);
    full_screen.write(Difference { gain }, &device, &queue);
    let size = scene.picture.size();
    if lights.as_ref().is_none_or(|lights| lights.size != size) {
        *lights = Some(Lights {
            size,
            pinned: create(&device, "light of the pinned scene", size),
            current: create(&device, "light of the scene", size),
        });
    }
}

fn create(device: &RenderDevice, label: &'static str, size: UVec2) -> TextureView {
    let texture = device.create_texture(&TextureDescriptor {
        label: Some(label),
        size: size.to_extents(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::Rgba16Float,
        usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&default())
}

/// Writes the difference to the picture, also where the probe is: it is the same in both scenes.
pub(crate) fn draw_difference(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    compared: Res<ComparedScene>,
    pass: Option<Res<DifferencePass>>,
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let target = view.into_inner();
    let Some(pass) = pass.filter(|_| compared.is_difference()) else {
        return;
    };
    // The pipeline writes one sample a pixel.
    let (Some(lights), None) = (&pass.lights, target.sampled_main_texture()) else {
        return;
    };
    pass.full_screen.draw(
        &mut context,
        &cache,
        STAGE,
        &[&lights.pinned, &lights.current],
        &[Some(target.get_color_attachment())],
    );
}
