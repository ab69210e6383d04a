//! The camera's sky: from directions of another observer at the same place, in whose frame curves
//! are found, to directions on the camera's axes.

use crate::camera_rays::{CameraRays, camera_in_disk_frame};
use glam::{DMat3, DMat4, DVec3, DVec4};
use lightfall_model::geometry::observer::{
    ObserverError, ObserverKind, ObserverMatrix, observer_matrix,
};
use lightfall_model::geometry::sphere::celestial_axes;
use lightfall_model::geometry::tetrad::transformation;
use lightfall_model::scene::Scene;

/// The sky of a camera, and the observer in whose frame curves are found.
pub(crate) struct Sky {
    /// The camera's radius, in r_s.
    pub(crate) r: f64,
    /// The unit vector from the hole to the camera.
    pub(crate) n: DVec3,
    /// The matrix of the observer in whose frame curves are found.
    pub(crate) frame: ObserverMatrix,
    /// That observer's axes (outward, theta, phi), as columns.
    pub(crate) axes: DMat3,
    /// From (1, d) of that observer to (frequency, frequency times d) of the camera.
    to_camera: DMat4,
}

/// A place on the celestial sphere of the disk's frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// Polar angle and azimuth, in radians.
    pub(super) theta: f64,
    pub(super) phi: f64,
    /// From components on an observer's axes (outward, theta, phi) of the disk's frame to those on
    /// its axes of the hole's frame.
    pub(super) turn: DMat3,
}

impl Place {
    /// The camera's.
    pub(super) fn of(scene: &Scene) -> Self {
        let camera = &scene.camera;
        if !scene.disk.is_tilted() {
            let [theta, phi] = camera.polar_angles();
            let turn = DMat3::IDENTITY;
            return Self { theta, phi, turn };
        }
        let n = camera_in_disk_frame(scene);
        let (theta, phi) = (n.truncate().length().atan2(n.z), n.y.atan2(n.x));
        let axes = scene.disk.hole_from_disk() * celestial_axes(theta, phi);
        Self {
            theta,
            phi,
            turn: camera.tetrad().transpose() * axes,
        }
    }
}

impl Sky {
    /// The sky of bent light, in the disk's frame. Curves are found in the frame of `rain`, which
    /// exists on both sides of the horizon, at `place`, which may differ a little from the camera's
    /// own.
    pub(super) fn bent(scene: &Scene, place: &Place) -> Result<Self, ObserverError> {
        let camera = &scene.camera;
        let (spin, kind) = (scene.hole.spin, ObserverKind::Rain);
        let [theta, phi] = camera.polar_angles();
        let rain = scene.observer_at_camera(kind, [0.0; 3])?;
        let to_camera = transformation(&rain, &CameraRays::new(scene)?.matrix, theta, phi);
        let Place { theta, phi, turn } = *place;
        let frame = observer_matrix(spin, kind, [0.0; 3], camera.r, theta, phi)?;
        let to_camera = to_camera * with_time(turn);
        Ok(Self::new(camera.r, theta, phi, frame, to_camera))
    }

    /// The sky without bending, where Boyer-Lindquist r, theta, phi are spherical coordinates of
    /// flat space. Curves are found in the frame of the zero-angular-momentum observer.
    pub(super) fn flat(scene: &Scene) -> Result<Self, ObserverError> {
        let mut scene = scene.clone();
        scene.effects.lensing = false;
        Self::of_zamo(&scene)
    }

    /// The sky of a camera outside the horizon, with light bent as the scene says, in the hole's
    /// frame. Curves are found in the frame of the zero-angular-momentum observer.
    pub(crate) fn of_zamo(scene: &Scene) -> Result<Self, ObserverError> {
        let [theta, phi] = scene.camera.polar_angles();
        let mut scene = scene.clone();
        let camera = CameraRays::new(&scene)?.matrix;
        scene.effects.aberration = false;
        let frame = CameraRays::new(&scene)?.matrix;
        let to_camera = transformation(&frame, &camera, theta, phi);
        Ok(Self::new(scene.camera.r, theta, phi, frame, to_camera))
    }

    fn new(r: f64, theta: f64, phi: f64, frame: ObserverMatrix, to_camera: DMat4) -> Self {
        let axes = celestial_axes(theta, phi);
        Self {
            r,
            n: axes.x_axis,
            frame,
            axes,
            to_camera,
        }
    }

    /// A direction of the frame on the camera's axes. `None` where rounding leaves none, at the
    /// horizon.
    pub(crate) fn seen(&self, direction: DVec3) -> Option<DVec3> {
        let [x, y, z] = direction.to_array();
        let [frequency, rest @ ..] = (self.to_camera * DVec4::new(1.0, x, y, z)).to_array();
        (DVec3::from_array(rest) / frequency).try_normalize()
    }

    /// As [`seen`](Self::seen), for every point of a curve.
    pub(super) fn curve_seen(&self, curve: impl IntoIterator<Item = DVec3>) -> Vec<DVec3> {
        curve
            .into_iter()
            .filter_map(|point| self.seen(point))
            .collect()
    }
}

/// A rotation of d as one of (1, d).
fn with_time(turn: DMat3) -> DMat4 {
    DMat4::from_cols(
        DVec4::X,
        DVec4::from((0.0, turn.x_axis)),
        DVec4::from((0.0, turn.y_axis)),
        DVec4::from((0.0, turn.z_axis)),
    )
}
