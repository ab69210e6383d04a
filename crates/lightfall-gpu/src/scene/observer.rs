//! The observer's part of the uniform: its matrix, and where it is.

use encase::ShaderType;
use glam::{DMat3, DVec3, DVec4, Vec3, Vec4};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::expansion::expand_about;
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_model::scene::Scene;
use lightfall_optics::camera_rays::{CameraRays, camera_in_disk_frame};
use lightfall_optics::shift::Shift;

/// Mirror of `Observer` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuObserver {
    pub energy: Vec4,
    pub radial: Vec4,
    pub w_x: Vec4,
    pub w_y: Vec4,
    pub w_z: Vec4,
    pub curvature: Vec4,
    pub expansion_centre: Vec3,
    pub energy_curvature: f32,
    pub frequency: Vec4,
    pub position_direction: Vec3,
    pub r: f32,
    pub u: f32,
    pub u_to_horizon: f32,
    pub ingoing_azimuth_lead: f32,
    pub time_lead: f32,
    pub zamo_lapse: f32,
    pub zamo_angular_velocity: f32,
}

impl GpuObserver {
    pub(super) fn new(
        scene: &Scene,
        kerr: Kerr,
        rays: &CameraRays,
        tetrad_from_direction: DMat3,
    ) -> Self {
        let direction_from_tetrad = tetrad_from_direction.transpose();
        let on_directions = |[one, r, theta, phi]: [f64; 4]| {
            let row = direction_from_tetrad * DVec3::new(r, theta, phi);
            DVec4::new(one, row.x, row.y, row.z)
        };
        let rows = rays.matrix.rows.map(on_directions);
        let centre = (direction_from_tetrad * rays.expanded.centre).as_vec3();
        let expanded = rows.map(|row| expand_about(row, centre.as_dvec3()));
        let [energy, radial, w_x, w_y, w_z] = expanded.map(|(row, _)| row.as_vec4());
        let [energy_curvature, curvatures @ ..] = expanded.map(|(_, curvature)| curvature as f32);
        let zamo = Shift::new(scene).camera();
        let (r, horizon) = (scene.camera.r, kerr.horizon());
        Self {
            energy,
            radial,
            w_x,
            w_y,
            w_z,
            curvature: Vec4::from_array(curvatures),
            expansion_centre: centre,
            energy_curvature,
            frequency: on_directions(rays.frequency).as_vec4(),
            position_direction: camera_in_disk_frame(scene).as_vec3(),
            r: r as f32,
            u: (1.0 / r) as f32,
            u_to_horizon: ((r - horizon) / (horizon * r)) as f32,
            ingoing_azimuth_lead: if r <= horizon {
                0.0
            } else {
                wrap_angle(kerr.ingoing_azimuth_lead(r)) as f32
            },
            time_lead: time_lead(scene).unwrap_or(0.0) as f32,
            zamo_lapse: zamo.lapse as f32,
            zamo_angular_velocity: zamo.dragging as f32,
        }
    }
}

/// The lead of Kerr's ingoing time over the camera's time, in r_s/c; without lensing the camera's
/// distance from the centre of flat space. `None` at and inside the horizon, where the camera's
/// time is the ingoing one.
pub(crate) fn time_lead(scene: &Scene) -> Option<f64> {
    let kerr = scene.kerr();
    let r = scene.camera.r;
    match scene.effects.lensing {
        false => Some(r),
        true => (r > kerr.horizon()).then(|| kerr.ingoing_time_lead(r)),
    }
}
