//! The pass that develops the picture: it adds the bloom to the light, and applies the exposure and the
//! tone curve.

use crate::bloom::{BloomPass, draw_bloom};
use crate::camera_markers::SceneCamera;
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::full_screen_pass::{FullScreenPass, Stage, attachment};
use crate::given_light::GivenLight;
use crate::graphics::Graphics;
use crate::live_shaders::add_shader;
use bevy::asset::uuid::Uuid;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{Render, RenderApp, RenderStartup, RenderSystems};
use lightfall_core::gpu::{Developer, Development};
use std::marker::PhantomData;

/// The first of the shaders, which have consecutive numbers.
const FIRST_SHADER: u128 = 0xa5d9e0f4_62c7_4b3e_9d1b_08e5c4f7b2a0;

const STAGE: Stage = ("develop", [Some(TextureFormat::Rgba16Float), None]);

#[derive(Resource)]
pub(super) struct DevelopPass {
    /// One for each shader.
    passes: [FullScreenPass<Development>; Developer::COUNT],
    /// The number of the one for the present scene.
    current: usize,
}

/// The shader of this number.
fn shader(number: usize) -> Handle<Shader> {
    Handle::Uuid(Uuid::from_u128(FIRST_SHADER + number as u128), PhantomData)
}

pub(super) fn plugin(app: &mut App) {
    for developer in Developer::all() {
        let handle = shader(developer.number());
        add_shader(app, &handle, developer.shader(), "lightfall/develop.wgsl");
    }
    app.sub_app_mut(RenderApp)
        .add_systems(RenderStartup, create_develop_pass)
        .add_systems(
            Render,
            prepare_develop_pass.in_set(RenderSystems::PrepareBindGroups),
        )
        .add_systems(
            Core3d,
            develop
                .in_set(Core3dSystems::PostProcess)
                .after(draw_bloom)
                .run_if(not(waits_for_bloom)),
        );
}

fn create_develop_pass(mut commands: Commands, device: Res<RenderDevice>) {
    commands.insert_resource(DevelopPass {
        passes: std::array::from_fn(|number| {
            FullScreenPass::new("development layout", shader(number), 2).with_sampler(&device)
        }),
        current: 0,
    });
}

/// Writes the uniform, when the textures of the bloom are known.
fn prepare_develop_pass(
    (scene, part): (Res<DrawnScene>, Res<DrawnPart>),
    (If(bloom), If(mut pass)): (If<Res<BloomPass>>, If<ResMut<DevelopPass>>),
    graphics: Graphics,
) {
    let DevelopPass { passes, current } = &mut *pass;
    *current = Developer::of(&scene, bloom.is_on()).number();
    let full_screen = &mut passes[*current];
    full_screen.queue(STAGE, &graphics.cache);
    full_screen.set_sampler(bloom.sampler());
    full_screen.write(Development::new(&scene, part.first_pixel()), &graphics);
}

/// Whether the picture is a part whose bloom is not known yet.
pub(super) fn waits_for_bloom(
    (part, given): (Res<DrawnPart>, Res<GivenLight>),
    bloom: Option<Res<BloomPass>>,
) -> bool {
    let has_bloom = bloom.is_some_and(|bloom| bloom.is_on());
    has_bloom && part.drawn().is_some() && given.is_none()
}

/// Develops the picture.
pub(super) fn develop(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    (If(bloom), If(pass)): (If<Res<BloomPass>>, If<Res<DevelopPass>>),
    cache: Res<PipelineCache>,
    mut context: RenderContext,
) {
    let full_screen = &pass.passes[pass.current];
    // The picture's two textures change places only if the pass draws.
    if full_screen.pipeline(STAGE, &cache).is_none() {
        return;
    }
    let picture = view.into_inner().post_process_write();
    full_screen.draw(
        &mut context,
        &cache,
        STAGE,
        &[picture.source, bloom.largest_level()],
        &[attachment(picture.destination)],
    );
}
