//! The path of a scene's camera from picture to picture, for programs that draw something else with the same
//! camera: as a table in CSV, which can be flown as a journey, and as a camera in USD.
//!
//! Both treat the space around the hole as flat: a place is r n, with n the unit vector toward the
//! Boyer-Lindquist angles theta and phi, in r_s, with z along the spin axis. The camera is one with x to
//! the right and y up that looks along -z. Its axes are those of the observer; what the hole and the
//! observer's motion do to the directions of light is in the picture and not in the path.

mod csv;
mod usd;

use super::{Camera, Observer, Projection, Scene};
use crate::geometry::sphere::nearest_turn;
use glam::{DMat3, DQuat, DVec2, DVec3};

/// The columns of a camera path in CSV.
pub const COLUMNS: [&str; 22] = [
    "frame",
    "time_s",
    "r",
    "theta_deg",
    "phi_deg",
    "yaw_deg",
    "pitch_deg",
    "roll_deg",
    "fov_deg",
    "x",
    "y",
    "z",
    "qw",
    "qx",
    "qy",
    "qz",
    "observer",
    "vx",
    "vy",
    "vz",
    "disk_time",
    "exposure_ev",
];

/// Where the camera is in each picture of a sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraPath {
    fps: f64,
    /// Width over height of the pictures.
    aspect: f64,
    stations: Vec<Station>,
}

/// The camera of one picture.
#[derive(Clone, Debug, PartialEq)]
struct Station {
    frame: u32,
    /// Its azimuth, yaw and roll are continued from picture to picture, without jumps of a whole turn.
    camera: Camera,
    /// Of the sign that is nearer to that of the picture before.
    turn: DQuat,
    observer: Observer,
    disk_time: f64,
    exposure_ev: f64,
}

impl CameraPath {
    /// A path without pictures yet: of `fps` a second, `aspect` times as wide as high.
    #[must_use]
    pub fn new(fps: f64, aspect: f64) -> Self {
        Self {
            fps,
            aspect,
            stations: Vec::new(),
        }
    }

    /// Adds the camera of the picture with this number. Numbers increase.
    pub fn add(&mut self, frame: u32, scene: &Scene) {
        let mut camera = scene.camera;
        let mut turn = DQuat::from_mat3(&pose(&camera).1);
        if let Some(Station {
            camera: before,
            turn: last,
            ..
        }) = self.stations.last()
        {
            for (angle, before) in [
                (&mut camera.phi_deg, before.phi_deg),
                (&mut camera.yaw_deg, before.yaw_deg),
                (&mut camera.roll_deg, before.roll_deg),
            ] {
                *angle = nearest_turn(*angle, before);
            }
            if turn.dot(*last) < 0.0 {
                turn = -turn;
            }
        }
        self.stations.push(Station {
            frame,
            camera,
            turn,
            observer: scene.observer,
            disk_time: scene.disk.time,
            exposure_ev: scene.picture.exposure_ev,
        });
    }

    /// Whether some camera has a projection that USD does not have: its cameras are pinhole cameras.
    #[must_use]
    pub fn is_beyond_usd(&self) -> bool {
        let mut cameras = self.stations.iter().map(|station| &station.camera);
        cameras.any(|camera| camera.projection != Projection::Perspective)
    }
}

/// The place of a camera in r_s, and the axes of its picture right, up, back, one per column, in the
/// hole's frame.
fn pose(camera: &Camera) -> (DVec3, DMat3) {
    let axes = camera.tetrad() * camera.tetrad_from_camera();
    let turned = DMat3::from_cols(axes.x_axis, axes.y_axis, -axes.z_axis);
    (camera.r * camera.direction(), turned)
}

/// The shift of a camera's picture, to the right and upward, in picture heights.
fn shift(camera: &Camera) -> DVec2 {
    DVec2::from_array(camera.shift)
}

/// A number with the digits from which it can be read back exactly. Adding zero removes the sign of a
/// negative zero.
fn number(x: f64) -> String {
    (x + 0.0).to_string()
}
