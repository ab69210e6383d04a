//! The uniform: a scene turned into numbers in f64 and rounded to f32 once. Its mirror is `Scene`
//! in shaders/scene.wgsl, which says what each number means; tests/gpu/layout.rs compares the two.

use super::GpuError;
use crate::geometry::kerr::Kerr;
use crate::geometry::observer::ObserverMatrix;
use crate::geometry::schwarzschild::Plunge;
use crate::geometry::sphere::wrap_angle;
use crate::optics::camera_rays::CameraRays;
use crate::optics::disk;
use crate::optics::photometry::DISK_HDR_SCALE;
use crate::optics::shift::Shift;
use crate::scene::{ObserverKind, Quality, Scene};
use encase::ShaderType;
use glam::{DMat3, DVec2, DVec3, DVec4, UVec2, Vec2, Vec3, Vec4};

/// Images of stars and lines are this many pixels in radius: with fewer they flicker as the camera
/// turns.
const SPOT_PIXELS: f64 = 1.5;

/// Height of the picture for which a star's brightness is given. Its flux does not depend on the
/// picture, so a pixel half as wide is four times as bright.
const SPOT_HEIGHT: f64 = 540.0;

/// How near to the horizon, in r_s, is as good as at it.
const NEXT_TO_HORIZON: f64 = 1e-8;

/// Light of a mark after exposure: below what tone mapping begins to bleach.
pub const MARK_BRIGHTNESS: f64 = 0.7;

/// A scene in the GPU's numbers.
#[expect(missing_docs, reason = "shaders/scene.wgsl says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuScene {
    pub energy: Vec4,
    pub radial: Vec4,
    pub w_x: Vec4,
    pub w_y: Vec4,
    pub w_z: Vec4,
    pub bend: Vec4,
    pub dimmest: Vec3,
    pub energy_bend: f32,
    pub frequency: Vec4,
    pub camera_direction: Vec3,
    pub camera_radius: f32,
    pub plunge: Vec4,
    pub plunge_middle: Vec3,
    pub plunge_bend: f32,
    pub plunge_span: f32,
    pub inverse_lapse2: f32,
    pub camera_u: f32,
    pub photon_sphere_depth: f32,
    pub picture_size: Vec2,
    pub tan_half_fov: Vec2,
    pub step_scale: f32,
    pub max_steps: u32,
    pub max_affine: f32,
    pub escape_radius: f32,
    pub disk_inner: f32,
    pub disk_outer: f32,
    pub disk_inner_fade: f32,
    pub disk_outer_fade: f32,
    pub disk_temperature: f32,
    pub disk_brightness: f32,
    pub disk_transmission: f32,
    pub sky_brightness: f32,
    pub reference_star: Vec3,
    pub spot_radius: f32,
    pub star_brightness: f32,
    pub sky_seed: u32,
    pub mark_brightness: f32,
    pub camera_lapse: f32,
    pub camera_dragging: f32,
    pub spin_length: f32,
    pub horizon: f32,
    pub horizon_u: f32,
    pub horizon_u_rest: f32,
    pub horizon_gap: f32,
    pub inner_horizon: f32,
    pub spin_gap: f32,
    pub horizon_depth: f32,
    pub azimuth_lead: f32,
    pub mino_step: f32,
    pub mino_near_step: f32,
}

impl GpuScene {
    /// The numbers for a picture of `size` pixels: directions are (right, up, forward) of the
    /// camera.
    ///
    /// # ErrorSummary
    /// A method or spin that no shader knows, or an observer that cannot be.
    pub fn new(scene: &Scene, size: UVec2) -> Result<Self, GpuError> {
        Self::looking(scene, size, scene.camera.tetrad_from_camera())
    }

    /// The numbers for rays whose directions are on the observer's own axes: (outward, theta, phi).
    ///
    /// # ErrorSummary
    /// As [`GpuScene::new`].
    pub fn for_rays(scene: &Scene) -> Result<Self, GpuError> {
        Self::looking(
            scene,
            UVec2::new(scene.picture.width, scene.picture.height),
            DMat3::IDENTITY,
        )
    }

    fn looking(scene: &Scene, size: UVec2, tetrad_from_direction: DMat3) -> Result<Self, GpuError> {
        let method = scene.method.properties();
        if !method.on_gpu {
            return Err(GpuError::MethodOfCpu);
        }
        if !method.spins && scene.hole.spin != 0.0 && scene.effects.lensing {
            return Err(GpuError::Spin(scene.hole.spin));
        }
        let Scene {
            camera,
            disk,
            sky,
            quality,
            ..
        } = scene;
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let inside = camera.r <= kerr.horizon();
        if inside && !method.inside {
            return Err(GpuError::Inside { r: camera.r });
        }
        let CameraRays { matrix, frequency } = CameraRays::new(scene)?;
        let turned = |[one, r, theta, phi]: [f64; 4]| {
            let row = tetrad_from_direction.transpose() * DVec3::new(r, theta, phi);
            DVec4::new(one, row.x, row.y, row.z)
        };
        let rows = matrix.rows.map(turned);
        let dimmest = dimmest(rows[0])
            .unwrap_or(tetrad_from_direction.transpose() * DVec3::NEG_X)
            .as_vec3();
        let about = rows.map(|row| about(row, dimmest.as_dvec3()));
        let [energy, radial, w_x, w_y, w_z] = about.map(|(row, _)| row.as_vec4());
        let [energy_bend, bends @ ..] = about.map(|(_, bend)| bend as f32);
        let (edge, inverse_lapse2) = plunge(scene, &matrix)?;
        let middle = tetrad_from_direction.transpose() * edge.middle;
        let plunge_middle = middle.as_vec3();
        // What rounding does to the middle is made up for.
        let moved = plunge_middle.as_dvec3() - middle;
        let there = edge.there + 0.5 * edge.bend * moved.length_squared();
        let along = edge.bend * moved;
        let rest = Shift::new(scene).camera();
        let size = size.max(UVec2::ONE).as_dvec2();
        let tan_half_fov = camera.half_height();
        let spot_radius = SPOT_PIXELS * 2.0 * tan_half_fov / size.y;
        let inner = disk::inner_edge(scene);
        let horizon_u = 1.0 / kerr.horizon();
        let pixel = 2.0 * tan_half_fov / size.y;
        let [mino_step, mino_near_step] = mino_steps(quality.max_error_px, pixel, kerr, camera.r);
        Ok(Self {
            energy,
            radial,
            w_x,
            w_y,
            w_z,
            bend: Vec4::from_array(bends),
            dimmest,
            energy_bend,
            frequency: turned(frequency).as_vec4(),
            camera_direction: camera.direction().as_vec3(),
            camera_radius: camera.r as f32,
            plunge: DVec4::new(there, along.x, along.y, along.z).as_vec4(),
            plunge_middle,
            plunge_bend: edge.bend as f32,
            plunge_span: (2.0 * edge.c) as f32,
            inverse_lapse2: inverse_lapse2 as f32,
            camera_u: (1.0 / camera.r) as f32,
            photon_sphere_depth: (2.0 / 3.0 - 1.0 / camera.r) as f32,
            picture_size: size.as_vec2(),
            tan_half_fov: DVec2::new(tan_half_fov * size.x / size.y, tan_half_fov).as_vec2(),
            step_scale: quality.step_scale as f32,
            max_steps: quality.max_steps,
            max_affine: quality.max_affine as f32,
            // Far enough that what bending is left does not show, and beyond the disk whether it is
            // shown or not.
            escape_radius: f64::max(1.15 * camera.r, 3.0 * disk.outer) as f32,
            disk_inner: inner as f32,
            disk_outer: disk.outer as f32,
            disk_inner_fade: (disk.edge_taper * inner) as f32,
            disk_outer_fade: (disk.edge_taper * disk.outer) as f32,
            disk_temperature: disk.temperature_k as f32,
            disk_brightness: (DISK_HDR_SCALE * disk.brightness) as f32,
            disk_transmission: disk.transmission as f32,
            sky_brightness: sky.brightness as f32,
            reference_star: reference_star(sky.reference_theta_deg, sky.reference_phi_deg)
                .as_vec3(),
            spot_radius: spot_radius as f32,
            star_brightness: (size.y / SPOT_HEIGHT).powi(2) as f32,
            sky_seed: sky.seed,
            mark_brightness: (MARK_BRIGHTNESS / scene.picture.exposure_ev.exp2()) as f32,
            camera_lapse: rest.lapse as f32,
            camera_dragging: rest.dragging as f32,
            spin_length: kerr.a() as f32,
            horizon: kerr.horizon() as f32,
            horizon_u: horizon_u as f32,
            horizon_u_rest: (horizon_u - f64::from(horizon_u as f32)) as f32,
            horizon_gap: ((1.0 - kerr.spin) * (1.0 + kerr.spin)).sqrt() as f32,
            inner_horizon: kerr.inner_horizon() as f32,
            spin_gap: (1.0 - kerr.spin) as f32,
            horizon_depth: ((camera.r - kerr.horizon()) / (kerr.horizon() * camera.r)) as f32,
            azimuth_lead: if inside {
                0.0
            } else {
                wrap_angle(kerr.ingoing_azimuth_lead(camera.r)) as f32
            },
            mino_step: mino_step as f32,
            mino_near_step: mino_near_step as f32,
        })
    }
}

/// What decides between sky and shadow without spin, and 1/(1 - 1/r).
///
/// On the horizon itself both are at a limit: an observer who falls through is taken to be next to
/// it, where nothing she sees is other by more than that.
fn plunge(scene: &Scene, matrix: &ObserverMatrix) -> Result<(Plunge, f64), GpuError> {
    let at = |r: f64, [energy, radial, ..]: [[f64; 4]; 5]| {
        (Plunge::new(energy, radial, r), r / (r - 1.0))
    };
    if scene.observer.kind == ObserverKind::Rain && (scene.camera.r - 1.0).abs() < NEXT_TO_HORIZON {
        let mut beside = scene.clone();
        beside.camera.r = 1.0 + NEXT_TO_HORIZON;
        return Ok(at(beside.camera.r, CameraRays::new(&beside)?.matrix.rows));
    }
    Ok(at(scene.camera.r, matrix.rows))
}

/// The direction from which light has the least energy, by the row that gives it; none if all of it
/// has the same.
fn dimmest(energy: DVec4) -> Option<DVec3> {
    let slope = DVec3::new(energy.y, energy.z, energy.w);
    (slope.length() > 1e-6 * energy.x.abs()).then(|| -slope.normalize())
}

/// What takes (1, off), off = d - m, to dot(row, (1, d)) less its bend times |off|^2/2, and the
/// bend, for unit d: with row = (s, b m + q), q across m, that is s + b m.m + b m.off + q.off, and
/// m.off = (1 - |m|^2 - |off|^2)/2.
fn about(row: DVec4, m: DVec3) -> (DVec4, f64) {
    let slope = DVec3::new(row.y, row.z, row.w);
    let along = slope.dot(m) / m.length_squared();
    let across = slope - along * m;
    let there = row.x + 0.5 * along * (1.0 + m.length_squared());
    (DVec4::new(there, across.x, across.y, across.z), -along)
}

/// The steps of method mino, in radians, where a pixel is `pixel` radians wide: of rays that pass
/// far from the critical curve, and of those that may come near it.
///
/// Measured: the turn that explains a ray's error is at most 4.5e-4 step^5.5, and mostly below 3e-4
/// step^5.5. Below a step of 0.25 nothing is left but f32's rounding. Up to 0.53 the disk's places
/// are right to 1e-5 of their radius in the median, and up to 0.4 the shadow's edge to 2e-6 of its
/// own: both are asked for at the default setting, and whoever allows more than it allows more of
/// both. With the camera next to a spinning hole the error is up to three times that, and all rays
/// may come near the curve.
fn mino_steps(max_error_px: f64, pixel: f64, kerr: Kerr, r: f64) -> [f64; 2] {
    let growth = |error: f64| error.powf(1.0 / 5.5);
    let wanted = growth(max_error_px * pixel / 4.5e-4);
    let looser = growth((max_error_px / Quality::default().max_error_px).max(1.0));
    let [far, near] = [0.53, 0.4].map(|longest| wanted.clamp(0.25, longest * looser));
    if kerr.spin != 0.0 && r < 2.0 * kerr.horizon() {
        [0.8 * near; 2]
    } else {
        [far, near]
    }
}

/// Unit vector toward a place at infinity.
fn reference_star(theta_deg: f64, phi_deg: f64) -> DVec3 {
    let [direction, ..] =
        crate::geometry::sphere::celestial_frame(theta_deg.to_radians(), phi_deg.to_radians());
    direction
}
