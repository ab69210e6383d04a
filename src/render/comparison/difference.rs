//! The difference: a pass that reads the light of the two scenes and writes how they differ,
//! amplified, to the HDR picture. Its textures exist only while a difference is shown.

use super::compared_scene::{ComparedScene, ComparisonLayout};
use crate::render::camera_markers::SceneCamera;
use crate::render::full_screen_pass::{draw_triangle, run_full_screen_pass};
use crate::render::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::render_resource::binding_types::{texture_2d, uniform_buffer};
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderContext, RenderDevice, RenderQueue, ViewQuery};
use bevy::render::view::ViewTarget;
use bevy::render::{RenderApp, RenderStartup};
use lightfall_core::gpu::Difference;
use lightfall_core::gpu::bindings::{DIFFERENCE, DIFFERENCE_LEFT, DIFFERENCE_RIGHT};

const SHADER: Handle<Shader> = uuid_handle!("b2a4e5a1-3c55-4b57-8f0d-6a53c2a6e0d4");

/// The pass's resources on the GPU.
#[derive(Resource)]
pub(in crate::render) struct DifferencePass {
    layout: BindGroupLayoutDescriptor,
    /// Queued when a difference is shown for the first time.
    pipeline: Option<CachedRenderPipelineId>,
    uniform: UniformBuffer<Difference>,
    lights: Option<Lights>,
}

/// The light of each of the two scenes.
pub(in crate::render) struct Lights {
    pub(in crate::render) size: UVec2,
    pub(in crate::render) pinned: TextureView,
    pub(in crate::render) current: TextureView,
    bind_group: BindGroup,
}

impl DifferencePass {
    /// Whether its pipeline exists.
    pub(in crate::render) fn is_ready(&self, cache: &PipelineCache) -> bool {
        self.pipeline
            .is_some_and(|id| cache.get_render_pipeline(id).is_some())
    }

    /// The textures that the two scenes are drawn to.
    pub(in crate::render) fn lights(&self) -> Option<&Lights> {
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
    let texture = || texture_2d(TextureSampleType::Float { filterable: false });
    let layout = BindGroupLayoutDescriptor::new(
        "difference layout",
        &BindGroupLayoutEntries::with_indices(
            ShaderStages::FRAGMENT,
            (
                (DIFFERENCE, uniform_buffer::<Difference>(false)),
                (DIFFERENCE_LEFT, texture()),
                (DIFFERENCE_RIGHT, texture()),
            ),
        ),
    );
    commands.insert_resource(DifferencePass {
        layout,
        pipeline: None,
        uniform: UniformBuffer::from(Difference::default()),
        lights: None,
    });
}

/// Creates what a difference needs, and drops the textures when none is shown.
pub(in crate::render) fn prepare_difference(
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
        layout,
        pipeline,
        uniform,
        lights,
    } = &mut *pass;
    pipeline.get_or_insert_with(|| cache.queue_render_pipeline(pipeline_descriptor(layout)));
    uniform.set(Difference { gain });
    uniform.write_buffer(&device, &queue);
    let size = scene.picture.size();
    if lights.as_ref().is_some_and(|lights| lights.size == size) {
        return;
    }
    let Some(uniform) = uniform.binding() else {
        return;
    };
    let [pinned, current] = ["light of the pinned scene", "light of the scene"]
        .map(|label| create(&device, label, size));
    let bind_group = device.create_bind_group(
        "difference bindings",
        &cache.get_bind_group_layout(layout),
        &BindGroupEntries::with_indices((
            (DIFFERENCE, uniform),
            (DIFFERENCE_LEFT, &pinned),
            (DIFFERENCE_RIGHT, &current),
        )),
    );
    *lights = Some(Lights {
        size,
        pinned,
        current,
        bind_group,
    });
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

fn pipeline_descriptor(layout: &BindGroupLayoutDescriptor) -> RenderPipelineDescriptor {
    RenderPipelineDescriptor {
        label: Some("difference".into()),
        layout: vec![layout.clone()],
        vertex: VertexState {
            shader: SHADER,
            entry_point: Some("vertex".into()),
            ..default()
        },
        fragment: Some(FragmentState {
            shader: SHADER,
            entry_point: Some("difference".into()),
            targets: vec![Some(ColorTargetState {
                format: TextureFormat::Rgba16Float,
                blend: None,
                write_mask: ColorWrites::ALL,
            })],
            ..default()
        }),
        ..default()
    }
}

/// Writes the difference to the picture, also where the probe is: it is the same in both scenes.
pub(in crate::render) fn draw_difference(
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
    let (Some(pipeline), Some(lights)) = (
        pass.pipeline.and_then(|id| cache.get_render_pipeline(id)),
        &pass.lights,
    ) else {
        return;
    };
    // The pipeline writes one sample a pixel.
    if target.sampled_main_texture().is_some() {
        return;
    }
    run_full_screen_pass(
        &mut context,
        "difference",
        target.get_color_attachment(),
        pipeline,
        &lights.bind_group,
        draw_triangle,
    );
}
