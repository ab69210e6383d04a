//! The two cameras: the scene camera draws the scene at the HDR picture's size, and the screen
//! camera shows the picture.

use crate::camera_markers::{SceneCamera, ScreenCamera};
use crate::capture::Capture;
use crate::chain::Chain;
use crate::comparison::{ComparedScene, follow_current_scene};
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::given_light::GivenLight;
use bevy::camera::{
    CameraMainTextureUsages, CameraOutputMode, CameraUpdateSystems, ClearColorConfig, Exposure,
    Hdr, MsaaWriteback, RenderTarget, SubCameraView,
};
use bevy::core_pipeline::tonemapping::{DebandDither, Tonemapping};
use bevy::light::cluster::ClusterConfig;
use bevy::prelude::*;
use bevy::render::extract_component::ExtractComponentPlugin;
use bevy::render::render_resource::TextureUsages;
use bevy::render::view::Msaa;
use lightfall_core::scene::Part;

/// Distance of the near plane from the scene camera, in r_s.
pub const NEAR_PLANE: f32 = 1e-3;

/// The exposure value at which Bevy's photometric scale is one, so that lamps and traced light have
/// the same unit.
const UNIT_EV100: f32 = -0.263_034_4;

/// Where the screen camera writes.
#[derive(Resource, Clone)]
struct ScreenTarget(RenderTarget);

/// Spawns the two cameras and applies the scene's settings to the scene camera. The screen camera
/// writes to `target`.
pub(super) fn insert(app: &mut App, target: RenderTarget) {
    app.add_plugins((
        ExtractComponentPlugin::<SceneCamera>::default(),
        ExtractComponentPlugin::<ScreenCamera>::default(),
    ))
    .insert_resource(ScreenTarget(target))
    .add_systems(Startup, spawn_cameras)
    .add_systems(
        PostUpdate,
        // Before Bevy computes transforms and projections, or the foreground would lag the traced
        // light by a frame.
        apply_scene_to_camera
            .run_if(
                resource_changed::<DrawnScene>
                    .or_eager(resource_changed::<DrawnPart>)
                    .or_eager(resource_changed::<GivenLight>)
                    .or_eager(resource_changed::<ComparedScene>),
            )
            .after(follow_current_scene)
            .before(TransformSystems::Propagate)
            .before(CameraUpdateSystems),
    );
}

fn spawn_cameras(
    mut commands: Commands,
    target: Res<ScreenTarget>,
    scene: Res<DrawnScene>,
    capture: Option<Res<Capture>>,
) {
    let copy_usage = if capture.is_some() {
        TextureUsages::COPY_SRC
    } else {
        TextureUsages::empty()
    };
    // The scene camera has no output of its own: the screen camera's passes read its picture. It is
    // not cleared, since the probe and the geodesic pass together cover every pixel.
    commands.spawn((
        SceneCamera,
        Camera3d {
            depth_texture_usages: (TextureUsages::RENDER_ATTACHMENT | copy_usage).into(),
            ..default()
        },
        Camera {
            order: -1,
            clear_color: ClearColorConfig::None,
            // The probe and the geodesic pass cover every sample, so none needs the last picture.
            msaa_writeback: MsaaWriteback::Off,
            output_mode: CameraOutputMode::Skip,
            ..default()
        },
        RenderTarget::None {
            size: scene.picture.size(),
        },
        Hdr,
        Msaa::Off,
        Tonemapping::None,
        DebandDither::Disabled,
        Exposure { ev100: UNIT_EV100 },
        // Every lamp lights the whole foreground.
        ClusterConfig::Single,
    ));
    commands.spawn((
        ScreenCamera,
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

/// Sets the scene camera's size, projection and direction.
fn apply_scene_to_camera(
    (scene, part, given): (Res<DrawnScene>, Res<DrawnPart>, Res<GivenLight>),
    compared: Res<ComparedScene>,
    camera: Single<
        (
            &mut Camera,
            &mut RenderTarget,
            &mut Transform,
            &mut Projection,
            &mut Msaa,
            &mut CameraMainTextureUsages,
        ),
        With<SceneCamera>,
    >,
) {
    let (mut view, mut target, mut transform, mut projection, mut msaa, mut usages) =
        camera.into_inner();
    let chain = Chain::of(&scene).of_part(part.drawn()).comparing(&compared);
    msaa.set_if_neq(if chain.samples > 1 {
        Msaa::Sample4
    } else {
        Msaa::Off
    });
    let mut needed = CameraMainTextureUsages::default();
    if chain.antialias {
        // Refined pixels are stored by a compute pass.
        needed = needed.with(TextureUsages::STORAGE_BINDING);
    }
    if given.is_some() {
        needed = needed.with(TextureUsages::COPY_DST);
    }
    if usages.0 != needed.0 {
        *usages = needed;
    }
    let size = chain.picture;
    if !matches!(*target, RenderTarget::None { size: old } if old == size) {
        *target = RenderTarget::None { size };
    }
    let whole = scene.picture.size();
    view.sub_camera_view = part.drawn().map(|Part { origin, size }| SubCameraView {
        full_size: whole,
        offset: origin.as_vec2(),
        size,
    });
    // Bevy's meshes are drawn in perspective, whatever the scene's projection is.
    *projection = Projection::Perspective(PerspectiveProjection {
        fov: scene.camera.fov_deg.to_radians() as f32,
        aspect_ratio: whole.x as f32 / whole.y as f32,
        near: NEAR_PLANE,
        ..default()
    });
    // The camera stays at the origin, and the probe is placed relative to it in f64, so that it
    // does not jitter far from the hole.
    let axes = (scene.camera.tetrad() * scene.camera.tetrad_from_camera()).as_mat3();
    let backward = -axes.z_axis;
    transform.rotation = Quat::from_mat3(&Mat3::from_cols(axes.x_axis, axes.y_axis, backward));
}
