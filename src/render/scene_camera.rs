//! The two cameras: the eye, which sees the scene at the HDR picture's size, and the screen, which
//! shows it.

use super::chain::Chain;
use super::{Capture, CurrentScene};
use bevy::camera::{
    CameraOutputMode, CameraUpdateSystems, ClearColorConfig, Exposure, Hdr, RenderTarget,
};
use bevy::core_pipeline::tonemapping::{DebandDither, Tonemapping};
use bevy::light::cluster::ClusterConfig;
use bevy::post_process::bloom::Bloom;
use bevy::prelude::*;
use bevy::render::extract_component::{ExtractComponent, ExtractComponentPlugin};
use bevy::render::render_resource::TextureUsages;
use bevy::render::view::{ColorGrading, ColorGradingGlobal, Msaa};

/// Marks the camera that sees the scene.
#[derive(Component, Clone, Copy, ExtractComponent)]
pub struct SceneCamera;

/// Marks the camera that shows the picture in a window or an image.
#[derive(Component, Clone, Copy, ExtractComponent)]
pub struct Screen;

/// Light in front of the eye, nearest distance drawn, in r_s.
pub const NEAR: f32 = 1e-3;

/// With this exposure value Bevy's photometric scale is one, so that lamps and traced light share
/// their units.
const UNIT_EV100: f32 = -0.263_034_4;

/// Spawns the cameras and keeps the eye as the scene says.
pub struct SceneCameraPlugin {
    /// Where the screen writes.
    pub target: RenderTarget,
}

#[derive(Resource, Clone)]
struct ScreenTarget(RenderTarget);

impl Plugin for SceneCameraPlugin {
    fn build(&self, app: &mut App) {
        app.add_plugins((
            ExtractComponentPlugin::<SceneCamera>::default(),
            ExtractComponentPlugin::<Screen>::default(),
        ))
        .insert_resource(ScreenTarget(self.target.clone()))
        .add_systems(Startup, spawn)
        .add_systems(
            PostUpdate,
            // In time for what Bevy makes of transforms and cameras, or the eye would lag the
            // traced light by a frame.
            follow
                .run_if(resource_changed::<CurrentScene>)
                .before(TransformSystems::Propagate)
                .before(CameraUpdateSystems),
        );
    }
}

fn spawn(
    mut commands: Commands,
    target: Res<ScreenTarget>,
    scene: Res<CurrentScene>,
    capture: Option<Res<Capture>>,
) {
    let copied = if capture.is_some() {
        TextureUsages::COPY_SRC
    } else {
        TextureUsages::empty()
    };
    // The eye writes to no output: the screen's passes read its picture. Nothing clears it either,
    // since the probe and the geodesic pass together cover every pixel.
    commands.spawn((
        SceneCamera,
        Camera3d {
            depth_texture_usages: (TextureUsages::RENDER_ATTACHMENT | copied).into(),
            ..default()
        },
        Camera {
            order: -1,
            clear_color: ClearColorConfig::None,
            output_mode: CameraOutputMode::Skip,
            ..default()
        },
        RenderTarget::None {
            size: UVec2::new(scene.picture.width, scene.picture.height),
        },
        Hdr,
        Msaa::Off,
        Tonemapping::KhronosPbrNeutral,
        DebandDither::Disabled,
        Exposure { ev100: UNIT_EV100 },
        // Every lamp lights the whole of the foreground.
        ClusterConfig::Single,
    ));
    commands.spawn((
        Screen,
        Camera2d,
        Camera {
            order: 0,
            clear_color: ClearColorConfig::None,
            ..default()
        },
        target.0.clone(),
        Msaa::Off,
        Tonemapping::None,
        DebandDither::Disabled,
    ));
}

/// Keeps the eye's size, lens, direction, exposure and bloom as the scene says.
fn follow(
    mut commands: Commands,
    scene: Res<CurrentScene>,
    eye: Single<
        (
            Entity,
            &mut RenderTarget,
            &mut Transform,
            &mut Projection,
            &mut ColorGrading,
            &mut Msaa,
        ),
        With<SceneCamera>,
    >,
) {
    let (entity, mut target, mut transform, mut projection, mut grading, mut msaa) =
        eye.into_inner();
    let chain = Chain::of(&scene);
    let samples = if chain.samples > 1 {
        Msaa::Sample4
    } else {
        Msaa::Off
    };
    if *msaa != samples {
        *msaa = samples;
    }
    let size = chain.picture;
    if !matches!(*target, RenderTarget::None { size: old } if old == size) {
        *target = RenderTarget::None { size };
    }
    *projection = Projection::Perspective(PerspectiveProjection {
        fov: scene.camera.fov_deg.to_radians() as f32,
        aspect_ratio: size.x as f32 / size.y as f32,
        near: NEAR,
        ..default()
    });
    // The eye stays at the origin and things are placed relative to it in f64, so that nothing
    // jitters far away.
    let world_from_camera = scene.camera.tetrad() * scene.camera.tetrad_from_camera();
    let [right, up, forward] = [
        world_from_camera.x_axis,
        world_from_camera.y_axis,
        world_from_camera.z_axis,
    ];
    transform.rotation = Quat::from_mat3(&Mat3::from_cols(
        right.as_vec3(),
        up.as_vec3(),
        -forward.as_vec3(),
    ));
    *grading = ColorGrading {
        global: ColorGradingGlobal {
            exposure: scene.picture.exposure_ev as f32,
            ..default()
        },
        ..default()
    };
    if let Some(rows) = chain.bloom {
        commands.entity(entity).insert(Bloom {
            intensity: scene.picture.bloom as f32,
            max_mip_dimension: rows,
            ..Bloom::NATURAL
        });
    } else {
        commands.entity(entity).remove::<Bloom>();
    }
}
