//! The foreground probe: a small craft, lit by the disk and the
//! stars. It is drawn in ordinary perspective, neither lensed nor hidden by the hole, and the
//! geodesic pass does not draw over it.

mod craft;

use crate::camera_markers::SceneCamera;
use crate::chain::Chain;
use crate::comparison::{ComparedScene, follow_current_scene};
use crate::drawn_scene::DrawnScene;
use bevy::camera::visibility::NoFrustumCulling;
use bevy::light::GlobalAmbientLight;
use bevy::pbr::ExtractedClusterConfig;
use bevy::prelude::*;
use bevy::render::{Render, RenderApp, RenderSystems};
use lightfall_core::optics::photometry::DiskRing;
use std::f32::consts::TAU;

/// Marks the craft.
#[derive(Component)]
struct Probe;

/// Marks one of the lamps that approximate the disk's light.
#[derive(Component)]
struct DiskLamp {
    /// Its ring, from 0 to [`RINGS`] - 1.
    ring: usize,
    /// Its place on the ring, from 0 to [`LAMPS`] - 1.
    place: usize,
}

/// Number of rings of lamps.
const RINGS: usize = 4;
/// Number of lamps on a ring.
const LAMPS: usize = 8;

/// Ambient light of the stars, in the units of traced light. It is a good deal brighter than the
/// real stars' light, so that the shape of the dark side is visible.
const STARLIGHT: f32 = 0.02;

/// Range of a lamp, in r_s.
const LAMP_RANGE: f32 = 1e4;

pub(super) fn plugin(app: &mut App) {
    app.insert_resource(GlobalAmbientLight {
        color: Color::srgb(0.8, 0.88, 1.0),
        brightness: STARLIGHT,
        ..default()
    })
    .add_systems(
        PostUpdate,
        (spawn_or_despawn_probe, place_probe, light_lamps)
            .chain()
            .run_if(resource_changed::<DrawnScene>.or_eager(resource_changed::<ComparedScene>))
            .after(follow_current_scene)
            .before(TransformSystems::Propagate),
    );
    app.sub_app_mut(RenderApp).add_systems(
        Render,
        skip_lamp_clustering
            .after(RenderSystems::ExtractCommands)
            .before(RenderSystems::CreateViews),
    );
}

/// Keeps Bevy from sorting lamps into the camera's clusters where there is no foreground to light.
fn skip_lamp_clustering(
    mut commands: Commands,
    (scene, compared): (Res<DrawnScene>, Res<ComparedScene>),
    cameras: Query<Entity, (With<SceneCamera>, With<ExtractedClusterConfig>)>,
) {
    if !Chain::of(&scene).comparing(&compared).probe {
        cameras.iter().for_each(|camera| {
            commands.entity(camera).remove::<ExtractedClusterConfig>();
        });
    }
}

/// Spawns the craft and its lamps when the scene has a probe, and despawns them when it has none.
fn spawn_or_despawn_probe(
    mut commands: Commands,
    (scene, compared): (Res<DrawnScene>, Res<ComparedScene>),
    parts: Query<Entity, Or<(With<Probe>, With<DiskLamp>)>>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    let wanted = Chain::of(&scene).comparing(&compared).probe;
    if wanted != parts.is_empty() {
        return;
    }
    if !wanted {
        parts
            .iter()
            .for_each(|part| commands.entity(part).despawn());
        return;
    }
    commands
        .spawn((Probe, Transform::default(), Visibility::default()))
        .with_children(|probe| {
            for (mesh, material, transform) in craft::parts(&mut materials) {
                probe.spawn((
                    Mesh3d(meshes.add(mesh)),
                    MeshMaterial3d(material),
                    transform,
                    // Bevy would cull with a frustum that has a tile's aspect ratio and the
                    // whole picture's axis, in which the craft may be outside.
                    NoFrustumCulling,
                ));
            }
        });
    for (ring, place) in (0..RINGS).flat_map(|ring| (0..LAMPS).map(move |place| (ring, place))) {
        commands.spawn((
            DiskLamp { ring, place },
            PointLight::default(),
            Transform::default(),
        ));
    }
}

/// Places the craft and its lamps relative to the camera, which stays at the origin. The difference
/// is taken in f64.
fn place_probe(
    scene: Res<DrawnScene>,
    mut craft: Query<&mut Transform, (With<Probe>, Without<DiskLamp>)>,
    mut lamps: Query<(&DiskLamp, &mut Transform), Without<Probe>>,
) {
    let camera = scene.camera.direction() * scene.camera.r;
    for mut transform in &mut craft {
        let here = lightfall_core::scene::Camera {
            r: scene.probe.r,
            theta_deg: scene.probe.theta_deg,
            phi_deg: scene.probe.phi_deg,
            ..scene.camera
        };
        let axes = here.tetrad().as_mat3();
        let [outward, north, west] = [axes.x_axis, -axes.y_axis, -axes.z_axis];
        let upright = Quat::from_mat3(&Mat3::from_cols(outward, north, west));
        // Rotated a little, so that light falls on several of its faces.
        let rotation = upright * Quat::from_euler(EulerRot::YZX, 0.7, 0.35, 0.25);
        *transform = Transform {
            translation: (here.direction() * here.r - camera).as_vec3(),
            rotation,
            scale: Vec3::splat(scene.probe.size as f32),
        };
    }
    let hole_from_disk = scene.disk.hole_from_disk().as_mat3();
    for (DiskLamp { ring, place }, mut transform) in &mut lamps {
        // Every second ring is rotated by half a gap.
        let angle = TAU * (*place as f32 + 0.5 * (*ring % 2) as f32) / LAMPS as f32;
        let radius = DiskRing::new(&scene, *ring, RINGS).radius;
        let on_ring = Vec3::new(angle.cos(), angle.sin(), 0.0) * radius as f32;
        transform.translation = hole_from_disk * on_ring - camera.as_vec3();
    }
}

/// Gives the lamps the disk's light: every lamp of a ring has the same share of its power. They
/// approximate the disk, whose exact light is the traced one. They stay on when the disk is hidden,
/// so that the craft looks the same with and without it.
fn light_lamps(scene: Res<DrawnScene>, mut lamps: Query<(&DiskLamp, &mut PointLight)>) {
    for (DiskLamp { ring, .. }, mut lamp) in &mut lamps {
        let light = DiskRing::new(&scene, *ring, RINGS).light(&scene);
        let colour = light.colour.as_vec3().max(Vec3::ZERO);
        lamp.color = Color::linear_rgb(colour.x, colour.y, colour.z);
        // A point light spreads its intensity over the whole sphere.
        lamp.intensity = light.power as f32 / LAMPS as f32;
        lamp.range = LAMP_RANGE;
    }
}
