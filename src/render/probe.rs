//! The foreground probe: a small craft of metal, ceramic and dark coating, lit by the disk and the
//! stars. It is projected ordinarily, neither lensed nor hidden by the hole, and the geodesic pass
//! leaves its pixels alone.

use super::{Chain, CurrentScene, SceneCamera};
use bevy::light::GlobalAmbientLight;
use bevy::math::DVec3;
use bevy::pbr::ExtractedClusterConfig;
use bevy::prelude::*;
use bevy::render::{Render, RenderApp, RenderSystems};
use lightfall_core::optics::photometry::DISK_HDR_SCALE;
use lightfall_core::optics::{disk, spectrum};
use lightfall_core::scene::Scene;
use std::f32::consts::{FRAC_PI_2, TAU};

/// Marks the craft.
#[derive(Component)]
struct Probe;

/// Marks one of the lamps that stand for the disk: its ring and its place on it.
#[derive(Component)]
struct DiskLamp {
    ring: usize,
    place: usize,
}

/// Rings of lamps that stand for the disk, and lamps on each.
const RINGS: usize = 3;
const LAMPS: usize = 6;

/// Light of the stars from everywhere, in the units of traced light; a good deal more than they
/// give, so that the shape of the dark side shows.
const STARLIGHT: f32 = 0.12;

pub(super) fn plugin(app: &mut App) {
    app.insert_resource(GlobalAmbientLight {
        color: Color::srgb(0.8, 0.88, 1.0),
        brightness: STARLIGHT,
        ..default()
    })
    .add_systems(
        PostUpdate,
        (present, place, shine)
            .chain()
            .run_if(resource_changed::<CurrentScene>)
            .before(TransformSystems::Propagate),
    );
    let Some(render_app) = app.get_sub_app_mut(RenderApp) else {
        return;
    };
    render_app.add_systems(
        Render,
        leave_out_lamps
            .after(RenderSystems::ExtractCommands)
            .before(RenderSystems::CreateViews),
    );
}

/// Without a foreground there is nothing to light, and lamps need not be sorted into the eye's
/// clusters.
fn leave_out_lamps(
    mut commands: Commands,
    scene: Res<CurrentScene>,
    eye: Query<Entity, (With<SceneCamera>, With<ExtractedClusterConfig>)>,
) {
    if !Chain::of(&scene).probe {
        eye.iter().for_each(|eye| {
            commands.entity(eye).remove::<ExtractedClusterConfig>();
        });
    }
}

/// Builds the craft and its lamps when the scene has one, and takes them away when it has none.
fn present(
    mut commands: Commands,
    scene: Res<CurrentScene>,
    parts: Query<Entity, Or<(With<Probe>, With<DiskLamp>)>>,
    mut meshes: ResMut<Assets<Mesh>>,
    mut materials: ResMut<Assets<StandardMaterial>>,
) {
    let wanted = Chain::of(&scene).probe;
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
            for (mesh, material, transform) in craft(&mut materials) {
                probe.spawn((
                    Mesh3d(meshes.add(mesh)),
                    MeshMaterial3d(material),
                    transform,
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

/// The parts of a craft one unit long: x out of the hole, y along the long axis.
fn craft(
    materials: &mut Assets<StandardMaterial>,
) -> Vec<(Mesh, Handle<StandardMaterial>, Transform)> {
    let metal = materials.add(StandardMaterial {
        base_color: Color::srgb(0.78, 0.77, 0.74),
        metallic: 1.0,
        perceptual_roughness: 0.38,
        ..default()
    });
    let ceramic = materials.add(StandardMaterial {
        base_color: Color::srgb(0.86, 0.84, 0.8),
        perceptual_roughness: 0.75,
        double_sided: true,
        cull_mode: None,
        ..default()
    });
    let coating = materials.add(StandardMaterial {
        base_color: Color::srgb(0.03, 0.035, 0.06),
        metallic: 0.3,
        perceptual_roughness: 0.3,
        ..default()
    });
    let lamp = materials.add(StandardMaterial {
        base_color: Color::BLACK,
        emissive: LinearRgba::rgb(3.0, 0.7, 0.25),
        ..default()
    });
    let at = Transform::from_xyz;
    let mut parts: Vec<(Mesh, _, _)> = vec![
        (
            Cylinder::new(0.13, 0.5).mesh().resolution(8).into(),
            metal.clone(),
            at(0.0, 0.0, 0.0),
        ),
        (
            ConicalFrustum {
                radius_top: 0.07,
                radius_bottom: 0.13,
                height: 0.12,
            }
            .into(),
            ceramic.clone(),
            at(0.0, 0.31, 0.0),
        ),
        (
            ConicalFrustum {
                radius_top: 0.24,
                radius_bottom: 0.05,
                height: 0.1,
            }
            .into(),
            ceramic,
            at(0.0, 0.45, 0.0),
        ),
        (
            Cylinder::new(0.012, 0.2).into(),
            metal.clone(),
            at(0.0, 0.55, 0.0),
        ),
        (
            ConicalFrustum {
                radius_top: 0.06,
                radius_bottom: 0.1,
                height: 0.12,
            }
            .into(),
            metal.clone(),
            at(0.0, -0.31, 0.0),
        ),
        (Sphere::new(0.022).into(), lamp.clone(), at(0.0, 0.66, 0.0)),
        (Sphere::new(0.018).into(), lamp, at(0.135, -0.12, 0.0)),
    ];
    for side in [-1.0, 1.0] {
        let boom = at(0.0, 0.0, 0.2 * side).with_rotation(Quat::from_rotation_x(FRAC_PI_2));
        parts.push((Cylinder::new(0.015, 0.16).into(), metal.clone(), boom));
        parts.push((
            Cuboid::new(0.012, 0.3, 0.42).into(),
            coating.clone(),
            at(0.0, 0.0, 0.49 * side),
        ));
        parts.push((
            Cuboid::new(0.02, 0.012, 0.42).into(),
            metal.clone(),
            at(0.0, 0.0, 0.49 * side),
        ));
    }
    parts
}

/// Places everything relative to the eye, which stays at the origin: the difference is taken in
/// f64.
fn place(
    scene: Res<CurrentScene>,
    mut craft: Query<&mut Transform, (With<Probe>, Without<DiskLamp>)>,
    mut lamps: Query<(&DiskLamp, &mut Transform), Without<Probe>>,
) {
    let eye = scene.camera.direction() * scene.camera.r;
    for mut transform in &mut craft {
        let here = lightfall_core::scene::Camera {
            r: scene.probe.r,
            theta_deg: scene.probe.theta_deg,
            phi_deg: scene.probe.phi_deg,
            ..scene.camera
        };
        let [outward, south, east] = [
            here.tetrad().x_axis,
            here.tetrad().y_axis,
            here.tetrad().z_axis,
        ];
        let upright = Quat::from_mat3(&Mat3::from_cols(
            outward.as_vec3(),
            -south.as_vec3(),
            -east.as_vec3(),
        ));
        // Banked and turned a little, so that light falls on several of its faces.
        let rotation = upright * Quat::from_euler(EulerRot::YZX, 0.7, 0.35, 0.25);
        *transform = Transform {
            translation: (here.direction() * here.r - eye).as_vec3(),
            rotation,
            scale: Vec3::splat(scene.probe.size as f32),
        };
    }
    for (DiskLamp { ring, place }, mut transform) in &mut lamps {
        // Lamps of neighbouring rings stand in each other's gaps.
        let angle = TAU * (*place as f32 + 0.5 * (*ring % 2) as f32) / LAMPS as f32;
        let (radius, _) = annulus(&scene, *ring);
        let on_ring = Vec3::new(angle.cos(), angle.sin(), 0.0) * radius as f32;
        transform.translation = on_ring - eye.as_vec3();
    }
}

/// Gives the lamps the disk's light. Hiding the disk leaves them on, so that the craft looks the
/// same with and without.
fn shine(scene: Res<CurrentScene>, mut lamps: Query<(&DiskLamp, &mut PointLight)>) {
    for (DiskLamp { ring, .. }, mut lamp) in &mut lamps {
        let (power, colour) = ring_light(&scene, *ring);
        lamp.color = colour;
        lamp.intensity = power / LAMPS as f32;
        lamp.range = 1e4;
    }
}

/// Radius in the middle and area of the annulus of the disk that a ring of lamps stands for.
fn annulus(scene: &Scene, ring: usize) -> (f64, f64) {
    let inner = disk::inner_edge(scene);
    let edge =
        |ring: usize| inner + (scene.disk.outer - inner).max(0.0) * ring as f64 / RINGS as f64;
    let (low, high) = (edge(ring), edge(ring + 1));
    (
        0.5 * (low + high),
        std::f64::consts::PI * (high * high - low * low),
    )
}

/// Luminous power of an annulus (both faces, unshifted, in the units of traced light) and its
/// colour. The lamps stand for the disk only roughly; the traced light is the exact one.
fn ring_light(scene: &Scene, ring: usize) -> (f32, Color) {
    let (radius, area) = annulus(scene, ring);
    let flux = disk::Profile::new(scene).flux(radius);
    let rgb = DVec3::from(spectrum::colour(disk::temperature(&scene.disk, flux)));
    let brightest = rgb.max_element().max(f64::MIN_POSITIVE);
    let radiance = brightest * flux * DISK_HDR_SCALE * scene.disk.brightness;
    let colour = (rgb / brightest).as_vec3().max(Vec3::ZERO);
    // A Lambertian face of radiance B and area A gives pi B A; the lamp's 4 pi I spreads both over
    // the whole sphere.
    (
        (2.0 * std::f64::consts::PI * radiance * area) as f32,
        Color::linear_rgb(colour.x, colour.y, colour.z),
    )
}
