//! The photons that reach a scene's camera, with the scene's effects on or off. The twin in WGSL is
//! shaders/observer.wgsl.
//!
//! Rays are traced in the disk's frame, in which the disk's plane is z = 0. Without tilt it is the
//! hole's frame. Only disks around holes without spin are tilted; their gravity is the same in both
//! frames, so tracing methods do not depend on the tilt. Directions of the sky are turned back to
//! the hole's frame.

use crate::shift::RestFrame;
use glam::{DVec3, DVec4};
use lightfall_model::geometry::observer::{ExpandedMatrix, ObserverError, ObserverMatrix, Photon};
use lightfall_model::geometry::sphere::celestial_frame;
use lightfall_model::scene::{ObserverKind, Scene};

/// The map from a looking direction to the photon that arrives from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraRays {
    /// The observer's matrix. Without aberration it is the matrix of the zero-angular-momentum
    /// observer (ZAMO) at the camera's place. Without lensing its photons belong to flat space:
    /// `radial` and `w` are the direction of the light for the ZAMO times the frequency it
    /// measures, and `energy` is that frequency times the lapse.
    pub matrix: ObserverMatrix,
    /// The same matrix, expanded: [`CameraRays::photon`] takes the photons from it.
    pub expanded: ExpandedMatrix,
    /// Takes (1, d) to the frequency that the camera measures of the matrix's photon, by which the
    /// photon is divided. It is 1 with aberration, and gamma (1 + v.d) without, v being the
    /// camera's velocity for the ZAMO.
    pub frequency: [f64; 4],
}

impl CameraRays {
    /// The rays of the scene's camera.
    ///
    /// # Errors
    /// If the scene's observer does not exist, or is inside the horizon while an effect is off
    /// whose absence is defined only outside.
    pub fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let (camera, observer, effects) = (&scene.camera, &scene.observer, scene.effects);
        let kerr = scene.kerr();
        let [theta, phi] = camera.polar_angles();
        let matrix = scene.observer_at_camera(observer.kind, observer.velocity)?;
        let rays = |matrix, frequency| Self {
            matrix,
            expanded: ExpandedMatrix::new(&matrix, camera.r),
            frequency,
        };
        let complete = rays(matrix, [1.0, 0.0, 0.0, 0.0]);
        let horizon = kerr.horizon();
        let all_effects =
            effects.lensing && effects.aberration && effects.doppler && effects.gravitational_shift;
        if camera.r <= horizon && !all_effects {
            return Err(ObserverError::Inside {
                r: camera.r,
                horizon,
            });
        }
        if effects.lensing && effects.aberration {
            return Ok(complete);
        }
        let zamo = scene.observer_at_camera(ObserverKind::Zamo, [0.0; 3])?;
        let [_, theta_hat, phi_hat] = celestial_frame(theta, phi);
        let boost = boost_to_zamo(&matrix, &zamo, theta_hat, phi_hat);
        // The boost takes (1, d) of the camera to the ZAMO's; its inverse has the velocity -v.
        let frequency = if effects.aberration {
            complete.frequency
        } else {
            [boost[0].x, -boost[1].x, -boost[2].x, -boost[3].x]
        };
        if effects.lensing {
            return Ok(rays(zamo, frequency));
        }
        let [one, along_r, along_theta, along_phi] = if effects.aberration {
            boost
        } else {
            DVec4::AXES
        };
        let w = |axis: usize| -(along_theta * theta_hat[axis] + along_phi * phi_hat[axis]);
        let lapse = RestFrame::at(kerr, camera.r, theta).lapse;
        let rows = [lapse * one, -along_r, w(0), w(1), w(2)].map(|row| row.to_array());
        Ok(rays(ObserverMatrix { rows }, frequency))
    }

    /// The same rays with the photons' `w` in the disk's frame, in which rays are traced.
    ///
    /// # Errors
    /// As [`CameraRays::new`].
    pub fn in_disk_frame(scene: &Scene) -> Result<Self, ObserverError> {
        let rays = Self::new(scene)?;
        if !scene.disk.is_tilted() {
            return Ok(rays);
        }
        let matrix = rays.matrix.turned(scene.disk.hole_from_disk().transpose());
        Ok(Self {
            matrix,
            expanded: ExpandedMatrix::new(&matrix, scene.camera.r),
            ..rays
        })
    }

    /// The photon that arrives from the unit looking direction `direction`, given on the observer's
    /// axes, per unit frequency for the camera.
    pub fn photon(&self, direction: DVec3) -> Photon {
        let Photon { energy, radial, w } = self.expanded.photon(direction);
        let frequency = DVec4::from_array(self.frequency).dot(DVec4::from((1.0, direction)));
        Photon {
            energy: energy / frequency,
            radial: radial / frequency,
            w: w / frequency,
        }
    }
}

/// Components of a unit vector below this, which is a few roundings, are zero in the disk's frame:
/// a camera in a tilted disk's plane, or on its axis, is there exactly.
const ROUNDING: f64 = 1e-15;

/// The unit vector from the hole to the scene's camera, in the disk's frame.
pub fn camera_in_disk_frame(scene: &Scene) -> DVec3 {
    let n = scene.camera.direction();
    if !scene.disk.is_tilted() {
        return n;
    }
    let turned = scene.disk.hole_from_disk().transpose() * n;
    turned.map(|x| if x.abs() < ROUNDING { 0.0 } else { x })
}

/// The rows of the boost that takes (1, d) of an observer to the ZAMO's (frequency, frequency times
/// direction), found by solving the ZAMO's own matrix for them.
fn boost_to_zamo(
    observer: &ObserverMatrix,
    zamo: &ObserverMatrix,
    theta_hat: DVec3,
    phi_hat: DVec3,
) -> [DVec4; 4] {
    let row = |matrix: &ObserverMatrix, i: usize| DVec4::from_array(matrix.rows[i]);
    let along = |matrix: &ObserverMatrix, hat: DVec3| {
        hat.x * row(matrix, 2) + hat.y * row(matrix, 3) + hat.z * row(matrix, 4)
    };
    let r = row(observer, 1) / row(zamo, 1).y;
    let theta = along(observer, theta_hat) / along(zamo, theta_hat).z;
    let phi = along(observer, phi_hat) / along(zamo, phi_hat).w;
    let energy = row(zamo, 0);
    [
        (row(observer, 0) - energy.w * phi) / energy.x,
        r,
        theta,
        phi,
    ]
}
